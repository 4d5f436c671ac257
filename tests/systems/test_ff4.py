"""FF4 MD2: Quake II's models, every frame a key, cycles by the beginnings of names; against other readers.

Broken files are refused with the byte. A character written as MD2 is what assimp reads.
"""

import json
from pathlib import Path

import assimp_dump
import numpy as np
import pytest
import statwalk
import tiny_model
from assimp import needs_assimp
from md2_models import md2
from paths import ASSETS, GROUND_TRUTH, needs_assets
from statwalk.character.character import Character
from statwalk.errors import ModelError
from statwalk.files.md2 import read_md2, write_md2

FOLDER = ASSETS / "md2"
FILES = ("tube_states", "faerie")
BROKEN = sorted(path.name for path in (ASSETS / "invalid" / "md2").glob("*.md2"))
INCH = 0.0254
CYCLES = {
    "tube_states": {"stand": 3, "run": 4, "jump": 3},
    "faerie": {
        **{"stand": 40, "run": 6, "attack": 8, "pain1": 4, "pain2": 4, "pain3": 4, "jump": 6, "flip": 12},
        **{"salute": 11, "taunt": 17, "wave": 11, "point": 12, "crstnd": 19, "crwalk": 6, "crattak": 9},
        **{"crpain": 4, "crdeath": 5, "death1": 6, "death2": 6, "death3": 8},
    },
}


def loaded(name: str) -> Character:
    character = statwalk.load(FOLDER / f"{name}.md2")
    assert isinstance(character, Character)
    return character


def truth(name: str) -> dict[str, np.ndarray]:
    return dict(np.load(GROUND_TRUTH / "md2" / f"{name}.md2.gt.npz"))


def corners(character: Character, positions: np.ndarray) -> np.ndarray:
    """Corners (T, 3, 3), in the order of the file's triangles."""
    return positions[character.parts[0].indices].reshape(-1, 3, 3)[:, ::-1]


@needs_assets
@pytest.mark.parametrize("name", FILES)
def test_every_frame_is_the_ground_truths(name: str) -> None:
    character, expected = loaded(name), truth(name)
    places = expected["positions"][:, expected["triangles"]][..., [1, 2, 0]] * INCH
    places[..., 1] -= expected["positions"][0, :, 2].min() * INCH
    frame = 0
    for cycle, count in CYCLES[name].items():
        for number in range(count):
            pose = character.clips[cycle].sample(number / 10)
            (part,) = character.vertices(pose)
            assert np.abs(corners(character, part.positions) - places[frame]).max() < 1e-6
            frame += 1
    assert frame == len(places)


@needs_assets
@pytest.mark.parametrize("name", FILES)
def test_cycles_are_clips_in_the_order_of_the_file(name: str) -> None:
    assert list(loaded(name).clips) == list(CYCLES[name])


@needs_assets
@pytest.mark.parametrize("name", FILES)
def test_texture_coordinates_are_the_pixels(name: str) -> None:
    character, expected = loaded(name), truth(name)
    pixels = (expected["uv"] + 0.5) / expected["skin_size"]
    shown = character.parts[0].attributes["TEXCOORD_0"][character.parts[0].indices].reshape(-1, 3, 2)
    assert shown[:, ::-1] == pytest.approx(pixels[expected["triangle_uv_index"]], abs=1e-6)


@needs_assets
@needs_assimp
@pytest.mark.parametrize("name", FILES)
def test_assimp_sees_the_same_normals(name: str, tmp_path: Path) -> None:
    character, seen = loaded(name), assimp_dump.corners(FOLDER / f"{name}.md2", tmp_path)
    assert character.parts[0].normals is not None
    normals = corners(character, character.parts[0].normals)[..., [2, 0, 1]]
    assert np.abs(normals[:, ::-1] - seen.normals).max() < 2e-6


@needs_assets
@pytest.mark.parametrize("name", BROKEN)
def test_broken_files_are_refused_with_the_byte(name: str) -> None:
    listed = json.loads((ASSETS / "invalid" / "expectations.json").read_text())["files"]
    (expected,) = (entry["expect"] for entry in listed if entry["file"] == f"invalid/md2/{name}")
    assert expected in ("reject", "either")
    with pytest.raises(ModelError, match=r"^byte [0-9]+: "):
        read_md2((ASSETS / "invalid" / "md2" / name).read_bytes(), "broken")


@needs_assets
def test_a_file_without_a_vertex_is_refused() -> None:
    with pytest.raises(ModelError, match="byte 24: a model has 1 to 65,535 vertices, not 0"):
        read_md2((FOLDER / "malformed_zero_numvertices.md2").read_bytes(), "none")


@needs_assimp
def test_assimp_reads_what_is_written(tmp_path: Path) -> None:
    (tmp_path / "a.md2").write_bytes(md2())
    (tmp_path / "b.md2").write_bytes(write_md2(read_md2(md2(), "tetra")))
    _compare(
        assimp_dump.corners(tmp_path / "a.md2", tmp_path), assimp_dump.corners(tmp_path / "b.md2", tmp_path)
    )


@needs_assets
@needs_assimp
@pytest.mark.parametrize("name", FILES)
def test_assimp_reads_the_written_file_as_the_file_before(name: str, tmp_path: Path) -> None:
    (tmp_path / "again.md2").write_bytes(write_md2(loaded(name)))
    before = assimp_dump.corners(FOLDER / f"{name}.md2", tmp_path)
    _compare(before, assimp_dump.corners(tmp_path / "again.md2", tmp_path))


def test_convert_writes_one_and_says_what_is_lost(tmp_path: Path) -> None:
    (tmp_path / "tiny.glb").write_bytes(tiny_model.model())
    report = statwalk.convert(tmp_path / "tiny.glb", tmp_path / "tiny.md2")
    assert {loss.part: loss.instead for loss in report.lost}["skins"] == "as frames, ten a second"
    again = statwalk.load(tmp_path / "tiny.md2", inbetween="switched")
    assert isinstance(again, Character)
    assert [clip.channels[0].interpolation for clip in again.clips.values()] == ["STEP"]


def _compare(before: assimp_dump.Corners, after: assimp_dump.Corners) -> None:
    """The same triangles, normals and texture coordinates; the floor lies 24 units below the origin."""
    floor = np.array([0, 0, -24 - before.positions[..., 2].min()])
    assert np.abs(after.positions - before.positions - floor).max() < 1e-4
    assert np.abs(after.normals - before.normals).max() < 2e-6
    assert np.abs(after.coordinates - before.coordinates).max() < 2e-6
