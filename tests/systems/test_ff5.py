"""FF5 BVH: any order of channels, End Sites are joints, positions replace or add; against independent poses.
Broken files are refused with the line.
"""

import json
import tracemalloc
from pathlib import Path

import captures
import numpy as np
import pytest
import statwalk
from paths import ASSETS, GROUND_TRUTH, needs_assets
from statwalk.character.character import Character
from statwalk.errors import ContentError, TextError
from statwalk.files.bvh import read_bvh
from statwalk.files.bvh.bvh_file import Position
from statwalk.files.trc.trc_file import read_trc
from statwalk.rig.evaluate import world_from_local

FOLDER = ASSETS / "bvh"
FILES = sorted(str(path.relative_to(FOLDER)) for path in FOLDER.rglob("*.bvh"))
BROKEN = sorted(path.name for path in (ASSETS / "invalid" / "bvh").glob("*.bvh"))


@needs_assets
@pytest.mark.parametrize("position", ["replace", "add"])
@pytest.mark.parametrize("name", FILES)
def test_poses_are_those_of_the_ground_truth(name: str, position: Position) -> None:
    truth = np.load(GROUND_TRUTH / "bvh" / f"{name}.gt.npz")
    character = statwalk.load(FOLDER / name, position=position)
    assert isinstance(character, Character)
    (clip,) = character.clips.values()
    world = world_from_local(character.skeleton, clip.sample(clip.channels[0].times[truth["frame_index"]]))
    size = max(np.ptp(truth["rest_position"], 0).max(), np.abs(truth[f"position_{position}"]).max())
    assert character.skeleton.parent.tolist() == truth["parent"].tolist()
    assert np.abs(world[..., 3] - truth[f"position_{position}"]).max() < 2e-6 * size
    assert np.abs(world[..., :3] - truth["rotation"]).max() < 2e-6
    assert np.abs(clip.channels[0].times[truth["frame_index"]] - truth["times"]).max() < 1e-5


@needs_assets
@pytest.mark.parametrize("name", BROKEN)
def test_broken_files_are_refused_with_the_line(name: str) -> None:
    expected = json.loads((ASSETS / "invalid" / "expectations.json").read_text())["files"]
    data = (ASSETS / "invalid" / "bvh" / name).read_bytes()
    one = (
        expected[f"invalid/bvh/{name}"]
        if isinstance(expected, dict)
        else next(e for e in expected if e["file"].endswith(f"bvh/{name}"))
    )
    if one["expect"] == "reject":
        with pytest.raises(TextError, match=r"^(line|byte) [0-9]+: "):
            read_bvh(data, "broken")
    else:
        read_bvh(data, "odd")


def test_a_false_number_of_frames_takes_no_memory() -> None:
    text = captures.walk().replace("Frames: 31", "Frames: 1000000000000")
    tracemalloc.start()
    with pytest.raises(TextError, match="says 1000000000000, but 31 rows follow"):
        read_bvh(text.encode(), "huge")
    assert tracemalloc.get_traced_memory()[1] < 2_000_000
    tracemalloc.stop()


def test_a_negative_number_of_frames_says_what_counts_are() -> None:
    text = captures.walk().replace("Frames: 31", "Frames: -3")
    with pytest.raises(TextError, match=r"Frames: and their number, 0 or more, not 'Frames: -3'"):
        read_bvh(text.encode(), "negative")


def test_no_frames_are_a_pose_at_rest_whatever_blank_lines_follow() -> None:
    head, _ = captures.walk().split("Frames: 31")
    capture = read_bvh(f"{head}Frames: 0\nFrame Time: 0.1\n\n\n".encode(), "still")
    assert all(clip.duration == 0 for clip in capture.clips.values())


def test_joints_are_in_file_order_and_end_sites_are_joints(tmp_path: Path) -> None:
    (tmp_path / "walk.bvh").write_text(captures.walk())
    walk = statwalk.load(tmp_path / "walk.bvh")
    assert isinstance(walk, Character)
    assert walk.skeleton.names[:6] == (
        "Hips",
        "LeftUpLeg",
        "LeftLeg",
        "LeftFoot",
        "LeftToeBase",
        "LeftToeBase.end",
    )
    assert list(walk.clips) == ["walk"]
    assert walk.clips["walk"].sample(1).translation[0] == pytest.approx([0, 90, 100], rel=1e-5)


def test_the_model_of_a_capture_opens_again_as_gltf(tmp_path: Path) -> None:
    walk = read_bvh(captures.walk().encode(), "walk")
    (tmp_path / "walk.glb").write_bytes(walk.model_glb)
    again = statwalk.load(tmp_path / "walk.glb")
    assert isinstance(again, Character)
    assert again.skeleton.names == walk.skeleton.names
    assert np.allclose(
        again.clips["walk"].sample(0.4).rotation, walk.clips["walk"].sample(0.4).rotation, atol=1e-6
    )


TRACKS = captures.trc(["Hips", "LKNE", "LANK", "RHip"], np.random.default_rng(1).random((3, 4, 3)))
CUT = "\t" + TRACKS.split("\n")[6].rpartition("\t")[2]
"""the last number of the second row"""


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (("NumFrames", "Frames"), "no NumFrames"),
        (("\tmm\t", "\tparsec\t"), "line 3: no unit is called 'parsec'"),
        (("\n1\t", "\n1\t7\t"), "line 6: a row has"),
        (("\n2\t0.033333\t", "\n2\t0.033333\tx"), "line 7: 'x"),
        (("RHip", "LHip2\tRHip"), "line 4"),
        ((CUT, ""), "line 7: marker 4 has some of its three numbers"),
        (("Hips", "nobody"), "a body needs a pelvis"),
    ],
)
def test_broken_marker_files_are_refused_with_the_line(change: tuple[str, str], said: str) -> None:
    with pytest.raises(ContentError, match=said):
        read_trc(TRACKS.replace(*change, 1).encode(), "broken")
