"""A character as an MD2 file, read again by statwalk and, byte by byte, by this file."""

import struct

import numpy as np
import pytest
import tiny_model
from md2_models import HEAD, md2
from paths import ASSETS, GLTF, needs_assets
from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.files.gltf import read_model
from statwalk.files.md2 import read_md2, write_md2
from statwalk.files.md2.md2_content import read_content
from statwalk.services.library.load import load

STEP = 1 / 255


def head(data: bytes) -> dict[str, int]:
    return dict(zip(HEAD, struct.unpack_from("<15i", data, 8), strict=True))


def test_a_file_comes_back_but_for_half_a_step_and_the_floor() -> None:
    data = md2(["stand01", "stand02", "stand03", "pain101", "pain102", "jump01", "jump02"])
    before, after = read_content(data), read_content(write_md2(read_md2(data, "tetra")))
    assert (before.names, before.skins, before.skin_size) == (after.names, after.skins, after.skin_size)
    floor = np.array([0, 0, before.positions[0, :, 2].min() + 24])
    half = 0.51 * STEP * np.ptp(before.positions, 1)[:, None, None]
    away = after.positions[:, after.corners] + floor - before.positions[:, before.corners]
    assert (np.abs(away) <= half).all()
    assert np.array_equal(after.normals[:, after.corners], before.normals[:, before.corners])
    assert np.array_equal(
        after.coordinates[after.corner_coordinates], before.coordinates[before.corner_coordinates]
    )


@needs_assets
@pytest.mark.parametrize("name", ["tube_states", "faerie"])
def test_a_file_whose_frames_fill_their_bounds_comes_back_byte_for_byte(name: str) -> None:
    data = (ASSETS / "md2" / f"{name}.md2").read_bytes()
    again = write_md2(read_md2(data, name))
    old, new = read_content(data), read_content(again)
    assert np.array_equal(points(again)[:, new.corners], points(data)[:, old.corners])
    assert np.array_equal(new.coordinates[new.corner_coordinates], old.coordinates[old.corner_coordinates])


def points(data: bytes) -> np.ndarray:
    """The four bytes of every vertex in every frame (F, V, 4)."""
    first, count, size = head(data)["frames_at"], head(data)["frames"], head(data)["frame_bytes"]
    frames = np.frombuffer(data, np.uint8, count * size, first).reshape(count, size)
    return frames[:, 40:].reshape(count, -1, 4)


def test_gl_commands_draw_the_triangles() -> None:
    data = write_md2(read_md2(md2(), "tetra"))
    content, first = read_content(data), head(data)["commands_at"]
    drawn = []
    while (count := struct.unpack_from("<i", data, first)[0]) != 0:
        assert count == 3
        corners = [struct.unpack_from("<ffi", data, first + 4 + 12 * row) for row in range(3)]
        drawn.append([vertex for *_, vertex in corners])
        first += 40
    assert drawn == content.corners.tolist()
    assert first + 4 == len(data) == head(data)["end"]


@needs_assets
@pytest.mark.parametrize("name", ["CesiumMan", "Khronos_Fox", "Quaternius_PlatformerCharacter"])
def test_a_skinned_character_is_off_by_half_a_step_of_a_byte(name: str) -> None:
    walker = read_model((GLTF / f"{name}.glb").read_bytes(), name)
    again = read_md2(write_md2(walker), name)
    assert len(again.clips) == len(walker.clips)
    lowest = None
    for old, new in zip(walker.clips.values(), again.clips.values(), strict=True):
        frames = round(old.duration * 10)
        for frame in (0, frames // 2):
            a = triangles(walker, old.sample(old.duration * frame / frames))
            b = triangles(again, new.sample(frame / 10))
            lowest = a[..., 1].min() if lowest is None else lowest  # it stands on the ground again
            away = np.abs(b + np.array([0, lowest, 0]) - a).max((0, 1))
            assert (away <= 1.01 * STEP * np.ptp(a, (0, 1)) + 1e-5).all()


def triangles(character: Character, pose) -> np.ndarray:
    """Corners (T, 3, 3) of all parts in a pose."""
    return np.concatenate(
        [
            part.positions[rest.indices].reshape(-1, 3, 3)
            for rest, part in zip(character.parts, character.vertices(pose), strict=True)
        ]
    )


def test_a_model_without_clips_is_one_frame() -> None:
    root, binary = tiny_model.document()
    root.pop("animations")
    still = read_model(tiny_model.glb(root, binary), "still")
    assert read_content(write_md2(still)).names == ("frame01",)


def test_without_a_triangle_there_is_nothing_to_write() -> None:
    tetra = read_md2(md2(), "tetra")
    bare = Character("bare", tetra.skeleton, tetra.node_index, tetra.bind_pose, tetra.clips)
    with pytest.raises(ContentError, match="no triangles"):
        write_md2(bare)


def test_the_shipped_walker_comes_back_with_all_its_clips() -> None:
    walker = load("faq-walker").character
    assert len(read_md2(write_md2(walker), "walker").clips) == len(walker.clips)
