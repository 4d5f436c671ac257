"""Joint matrices in lanes against the slow hierarchy in float64; lists of joints; any lane gives the same
bits.
"""

import locked_arrays
import numpy as np
import pytest
import slow_hierarchy
from statwalk.maths import quat
from statwalk.maths.pose import Pose, rest
from statwalk.maths.pose_buffer import PoseBuffer
from statwalk.rig.model_buffer import JointList, ModelBuffer
from statwalk.rig.skeleton import Skeleton

PARENTS = np.array([-1, 0, 1, 0, -1, 4, 5, 2], np.int32)
SKELETON = Skeleton(tuple("abcdefgh"), PARENTS)
JOINTS, ACTORS = len(PARENTS), 21
CHANCE = np.random.default_rng(3)
POSES = Pose(
    CHANCE.normal(size=(ACTORS, JOINTS, 3)).astype(np.float32),
    quat.normalize(CHANCE.normal(size=(ACTORS, JOINTS, 4))).astype(np.float32),
    CHANCE.uniform(0.5, 2, (ACTORS, JOINTS, 3)).astype(np.float32),
    np.zeros((ACTORS, 0), np.float32),
)
EXPECTED = slow_hierarchy.worlds(PARENTS, POSES)


def filled(rows, wanted=None):
    buffer = ModelBuffer.room(JointList.of(SKELETON, wanted), len(rows))
    buffer.fill(PoseBuffer.of(rest(JOINTS), POSES.take(rows)))
    return buffer


EVERYONE = np.arange(ACTORS)


def test_every_joint_is_where_numpy_puts_it():
    assert filled(EVERYONE).matrices() == pytest.approx(EXPECTED, abs=2e-5)


def test_joints_that_are_needed_bring_along_those_above_them_and_no_others():
    listed = JointList.of(SKELETON, [7, 3])
    assert listed.joints.tolist() == [0, 1, 2, 3, 7]
    assert listed.parents.tolist() == [-1, 0, 1, 0, 2]


def test_a_list_gives_the_bits_that_all_joints_give():
    some, whole = filled(EVERYONE, [6, 2]), filled(EVERYONE)
    places = some.joints.places(np.array([6, 2]))
    assert some.matrices(places).tobytes() == whole.matrices(np.array([6, 2])).tobytes()


def test_what_rides_on_no_joint_has_no_place():
    assert JointList.of(SKELETON, [3]).places(np.array([-1, 3])).tolist() == [-1, 1]


@pytest.mark.parametrize("rows", [[18], [3, 18, 7], list(range(20, -1, -1))])
def test_a_lane_does_not_matter(rows):
    assert filled(np.array(rows)).matrices().tobytes() == filled(EVERYONE).matrices()[rows].tobytes()


def test_the_arrays_of_a_list_cannot_be_written():
    locked_arrays.check(JointList.of(SKELETON, [3]))
