from dataclasses import replace

import captures
import numpy as np
import pytest
from reference_poses import MODELS, character
from statwalk.character.character import Character
from statwalk.files.bvh import read_bvh
from statwalk.files.bvh.write_bvh import write_bvh
from statwalk.files.held_parts import carriers
from statwalk.maths import pose as poses
from statwalk.rig.evaluate import world_from_local
from statwalk.rig.skeleton import Skeleton


def bones(names: tuple[str, ...], parents: list[int]) -> Character:
    rest = poses.rest(len(names))
    rest.translation[:] = np.arange(3 * len(names)).reshape(-1, 3)
    skeleton = Skeleton(names, np.array(parents, np.int32))
    return Character("some bones", skeleton, np.arange(len(names), dtype=np.int32), rest)


def order_in_file(source: Character) -> list[int]:
    """The joints in the order in which BVH writes them, without End Sites: depth first."""
    left_out = carriers(source)
    order: list[int] = []
    pending = [joint for joint in range(len(source.skeleton)) if source.skeleton.parent[joint] < 0]
    pending = [joint for joint in reversed(pending) if joint not in left_out]
    while pending:
        joint = pending.pop()
        order.append(joint)
        children = np.flatnonzero(source.skeleton.parent == joint).tolist()
        pending += [child for child in reversed(children) if child not in left_out]
    return order


@pytest.mark.parametrize("name", [name for name in MODELS if "AssetGenerator" not in name])
def test_joints_are_where_they_were(name: str) -> None:
    source = character(name)
    back = read_bvh(write_bvh(source), "back")
    (clip,) = back.clips.values()
    times = clip.channels[0].times
    first = next(iter(source.clips.values()), None)
    pose = first.sample(times) if first else source.bind_pose
    order = order_in_file(source)
    there = world_from_local(source.skeleton, pose)[..., 3][..., order, :]
    rows = [row for row, name in enumerate(back.skeleton.names) if not name.endswith(".end")]
    rows = rows[len(rows) - len(order) :]  # several roots hang on one more
    here = world_from_local(back.skeleton, clip.sample(times))[..., 3][..., rows, :]
    assert np.abs(here - there).max() < 1e-5 * max(np.ptp(there.reshape(-1, 3), 0).max(), 1)


def test_the_rest_pose_is_kept_by_the_offsets() -> None:
    source = character(MODELS[-1])
    back = read_bvh(write_bvh(source), "back")
    rows = [row for row, name in enumerate(back.skeleton.names) if not name.endswith(".end")]
    order = order_in_file(source)
    here = world_from_local(back.skeleton, back.bind_pose)[rows[len(rows) - len(order) :], :, 3]
    there = world_from_local(source.skeleton, source.bind_pose)[order, :, 3]
    assert np.allclose(here, there, atol=1e-4)


def test_a_capture_that_is_written_keeps_its_frames_and_its_end_sites() -> None:
    source = read_bvh(captures.walk().encode(), "walk")
    back = read_bvh(write_bvh(source), "walk")
    assert back.skeleton.names == source.skeleton.names
    ours, theirs = (read.clips["walk"] for read in (back, source))
    assert np.allclose(ours.channels[0].times, theirs.channels[0].times, atol=1e-7)
    times = theirs.channels[0].times
    assert np.allclose(
        world_from_local(back.skeleton, ours.sample(times)),
        world_from_local(source.skeleton, theirs.sample(times)),
        atol=1e-4,  # of 90 centimetres
    )


def test_written_twice_is_the_same_skeleton() -> None:
    once = read_bvh(write_bvh(character(MODELS[0])), "x")
    twice = read_bvh(write_bvh(once), "x")
    assert twice.skeleton.names == once.skeleton.names
    assert twice.skeleton.parent.tolist() == once.skeleton.parent.tolist()


def test_names_become_one_word_each_and_differ() -> None:
    names = ("my hip", "my\thip", "}", "knee.end", "my_hip")
    back = read_bvh(write_bvh(bones(names, [-1, 0, 0, 1, 1])), "x")
    own = [name for name in back.skeleton.names if not name.endswith(".end")]
    assert len(set(own)) == len(names)
    assert "knee_end" in own
    assert not [name for name in own if set(name) & set(" \t{}")]


def test_without_a_clip_there_is_one_frame_of_rest() -> None:
    text = write_bvh(bones(("a", "b"), [-1, 0])).decode()
    assert "Frames: 1\n" in text
    assert text.splitlines()[-1].split() == ["0", "1", "2", *["0"] * 6]


def test_several_roots_hang_on_one() -> None:
    text = write_bvh(bones(("a", "b"), [-1, -1])).decode()
    assert text.count("ROOT") == 1
    assert read_bvh(text.encode(), "x").skeleton.names[:2] == ("some_bones", "a")


def test_a_deep_skeleton_is_written_without_recursion() -> None:
    count = 3_000
    deep = bones(tuple(f"j{row}" for row in range(count)), list(range(-1, count - 1)))
    data = write_bvh(replace(deep, bind_pose=poses.rest(count)))
    assert len(data) < 2_000 * count
    assert len(read_bvh(data, "x").skeleton) == count + 1
