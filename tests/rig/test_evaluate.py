"""Transforms of joints against the slow hierarchy: of one actor, of a crowd, and on the stage."""

import numpy as np
import pytest
import slow_hierarchy
from statwalk.maths import quat, transform
from statwalk.maths.pose import Pose
from statwalk.rig.evaluate import stage_from_local, world_from_local
from statwalk.rig.skeleton import Skeleton

RNG = np.random.default_rng(19)
PARENT = np.array([-1, 0, 1, 1, 3, -1, 5, 4], np.int32)
SKELETON = Skeleton(tuple("abcdefgh"), PARENT)


def some_pose(*leading: int) -> Pose:
    shape = (*leading, len(PARENT))
    turns = quat.normalize(RNG.normal(size=(*shape, 4)))
    return Pose(
        RNG.normal(size=(*shape, 3)), turns, RNG.uniform(0.5, 2, (*shape, 3)), np.zeros((*leading, 0))
    )


def single(pose: Pose) -> Pose:
    return Pose(*(array.astype(np.float32) for array in pose))


@pytest.mark.parametrize("leading", [(), (5,), (2, 3), (0,)])
def test_world_is_the_product_of_all_above(leading):
    pose = some_pose(*leading)
    expected = slow_hierarchy.worlds(PARENT, pose)
    np.testing.assert_allclose(world_from_local(SKELETON, pose), expected, atol=1e-12)


def test_one_actor_and_a_crowd_get_the_same_bits():
    crowd = single(some_pose(23))
    worlds = world_from_local(SKELETON, crowd)
    assert worlds.dtype == np.float32
    assert all(world_from_local(SKELETON, crowd.take(i)).tobytes() == worlds[i].tobytes() for i in range(23))


def test_a_chain_of_5000_joints_is_no_recursion():
    chain = Skeleton(("",) * 5000, np.arange(-1, 4999, dtype=np.int32))
    ones = np.ones((5000, 3))
    worlds = world_from_local(chain, Pose(ones, np.tile(quat.IDENTITY, (5000, 1)), ones, np.zeros(0)))
    assert worlds[-1, :, 3].tolist() == [5000, 5000, 5000]


def test_a_pose_of_other_joints_is_refused():
    with pytest.raises(ValueError, match="skeleton of 8 joints"):
        world_from_local(SKELETON, Pose(*(array[:7] for array in some_pose())))
    with pytest.raises(ValueError, match="skeleton of 8 joints"):
        world_from_local(SKELETON, some_pose()._replace(rotation=np.ones((8, 3))))


def test_actors_are_placed_as_a_whole():
    pose, size = some_pose(3), np.ones((3, 3))
    roots = transform.from_trs(RNG.normal(size=(3, 3)), quat.normalize(RNG.normal(size=(3, 4))), size)
    worlds = stage_from_local(SKELETON, single(pose), roots)
    assert worlds == pytest.approx(slow_hierarchy.under(roots, PARENT, pose), abs=2e-5)


def test_a_pose_of_other_actors_is_refused():
    with pytest.raises(ValueError, match="for 2 actors"):
        stage_from_local(SKELETON, some_pose(3), np.zeros((2, 3, 4), np.float32))
