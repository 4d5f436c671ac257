"""World transforms against a loop of 4x4 matrix products."""

import numpy as np
from statwalk.maths import quat, transform
from statwalk.maths.pose import Pose
from statwalk.rig.evaluate import world_from_local
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


def test_world_is_the_product_of_all_above():
    pose = some_pose()
    local = transform.to_matrix4(transform.from_trs(pose.translation, pose.rotation, pose.scale))
    world = [np.eye(4)] * len(PARENT)
    for joint, parent in enumerate(PARENT):
        world[joint] = local[joint] if parent < 0 else world[parent] @ local[joint]
    np.testing.assert_allclose(transform.to_matrix4(world_from_local(SKELETON, pose)), world, atol=1e-12)


def test_one_actor_and_a_crowd_get_the_same_bits():
    crowd = Pose(*(array.astype(np.float32) for array in some_pose(23)))
    worlds = world_from_local(SKELETON, crowd)
    assert worlds.dtype == np.float32
    assert all(world_from_local(SKELETON, crowd.take(i)).tobytes() == worlds[i].tobytes() for i in range(23))
