"""An MD2 file as a character: axes, units, the ground, clips and their ends."""

from pathlib import Path

import numpy as np
import pytest
import statwalk
from md2_models import FACES, NAMES, md2, units, with_bytes, with_field
from statwalk.errors import ContentError
from statwalk.files.gltf import read_model
from statwalk.files.md2 import md2_file, read_md2
from statwalk.files.md2.md2_normals import NORMALS

INCH = 0.0254


def on_the_ground(frame: int) -> np.ndarray:
    """Corners (T, 3, 3) of a frame in metres: x to the left, y up, z forward, counter-clockwise."""
    forward, left, up = np.array(units(frame))[list(map(list, FACES))].transpose(2, 0, 1) * INCH
    lowest = min(height for *_, height in units(0)) * INCH
    return np.stack([left, up - lowest, forward], -1)[:, ::-1]


def corners_of(part, positions: np.ndarray) -> np.ndarray:
    return positions[part.indices].reshape(-1, 3, 3)


@pytest.mark.parametrize("frame", range(len(NAMES)))
def test_each_frame_is_a_key(frame: int) -> None:
    tetra = read_md2(md2(), "tetra")
    first = {"stand": 0, "pain1": 3, "jump": 5}
    cycle = max((name for name in first if first[name] <= frame), key=first.__getitem__)
    pose = tetra.clips[cycle].sample((frame - first[cycle]) / 10)
    (part,) = tetra.vertices(pose)
    assert corners_of(tetra.parts[0], part.positions) == pytest.approx(on_the_ground(frame), abs=1e-6)


def test_the_faces_look_outwards() -> None:
    tetra = read_md2(md2(), "tetra")
    a, b, c = corners_of(tetra.parts[0], tetra.vertices(tetra.bind_pose)[0].positions).swapaxes(0, 1)
    assert (a * np.cross(b, c)).sum() > 0


def test_clips_are_cycles() -> None:
    tetra = read_md2(md2(), "tetra")
    ends = {name: (round(clip.duration, 6), clip.loop) for name, clip in tetra.clips.items()}
    assert ends == {"stand": (0.3, True), "pain1": (0.1, False), "jump": (0.1, False)}


def test_a_cycle_that_comes_round_has_its_first_frame_at_its_end() -> None:
    stand = read_md2(md2(), "tetra").clips["stand"]
    assert stand.sample(stand.duration).weights == pytest.approx(stand.sample(0).weights)
    assert np.abs(stand.sample(0.2).weights - stand.sample(0).weights).max() == 1


def test_a_scale_multiplies_all_lengths() -> None:
    small, large = read_md2(md2(), "a"), read_md2(md2(), "b", scale=10)
    assert large.vertices(large.bind_pose)[0].positions == pytest.approx(
        10 * small.vertices(small.bind_pose)[0].positions, rel=1e-5
    )


@pytest.mark.parametrize(("form", "said"), [({"inbetween": "cubic"}, "inbetween"), ({"scale": 0.0}, "scale")])
def test_other_forms_are_refused(form: dict, said: str) -> None:
    with pytest.raises(ContentError, match=said):
        read_md2(md2(), "tetra", **form)


def test_normals_are_quakes() -> None:
    part = read_md2(md2(), "tetra").parts[0]
    assert part.normals is not None
    used = {tuple(np.round(normal, 5)) for normal in part.normals[:, [2, 0, 1]]}
    assert used == {tuple(np.round(NORMALS[number], 5)) for number in (0, 32, 52, 104)}


@pytest.mark.parametrize("normals", [(0, 0, 0, 0), (0, 3, 200, 5)])
def test_normals_that_are_none_are_computed(normals: tuple[int, ...]) -> None:
    tetra = read_md2(md2(normals=normals), "tetra")
    assert tetra.parts[0].normals is not None
    middle = tetra.parts[0].positions.mean(0)
    assert ((tetra.parts[0].positions - middle) * tetra.parts[0].normals).sum(-1).min() > 0
    assert "normals" in tetra.notes[0]


def test_a_texture_coordinate_is_the_middle_of_its_pixel() -> None:
    part = read_md2(md2(), "tetra").parts[0]
    corner = part.attributes["TEXCOORD_0"][part.indices][-1]
    assert corner == pytest.approx([(0 + 0.5) / 32, (15 + 0.5) / 16])


def test_a_file_without_texture_coordinates_is_read() -> None:
    assert not read_md2(with_field("coordinates", 0), "tetra").parts[0].attributes


def test_one_frame_is_a_model_that_rests() -> None:
    flag = read_md2(md2(["flag"]), "flag")
    assert flag.bind_pose.weights.shape == (0,)
    assert flag.clips["flag"].duration == 0
    assert len(read_model(flag.model_glb, "flag").parts) == 1


def test_its_model_is_the_same_character() -> None:
    tetra = read_md2(md2(), "tetra")
    again = read_model(tetra.model_glb, "tetra")
    assert list(again.clips) == list(tetra.clips)
    for name, clip in tetra.clips.items():
        poses = clip.sample(0.13), again.clips[name].sample(0.13)
        a, b = (one.vertices(pose)[0] for one, pose in zip((tetra, again), poses, strict=True))
        assert b.positions == pytest.approx(a.positions, abs=1e-6)
        assert b.normals == pytest.approx(a.normals, abs=1e-5)


def test_a_file_on_disk_has_its_name_in_errors(tmp_path: Path) -> None:
    (tmp_path / "bad.md2").write_bytes(with_field("frames", 0))
    with pytest.raises(ContentError, match=r"bad\.md2, byte 40"):
        statwalk.load(tmp_path / "bad.md2")
    with pytest.raises(ContentError, match="no such file"):
        statwalk.load(tmp_path / "none.md2")


def test_too_many_corners_for_memory_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(md2_file, "LARGEST_MORPHS", 1 << 9)
    with pytest.raises(ContentError, match="byte 40: 7 frames of 7 corners take 0 MiB"):
        read_md2(md2(), "tetra")


def test_numbers_stay_finite_at_the_limits() -> None:
    wide = read_md2(with_bytes(68 + 64 + 20 + 48, "<6f", *[-1e6, 1e6] * 3), "wide", scale=1e6)
    assert np.isfinite(wide.vertices(wide.bind_pose)[0].positions).all()
