"""The FAQ's bones: a chain worked out by hand."""

import locked_arrays
import numpy as np
from statwalk.maths import quat
from statwalk.rig.bones import Bones
from statwalk.rig.skeleton import Skeleton

UP = [0.0, 1.0, 0.0]
ARM = Bones(
    Skeleton(("upper", "lower", "hand"), np.array([-1, 0, 1], np.int32)),
    np.array([3.0, 2, 1]),
    np.array([UP, UP, UP]),
)
BENT = quat.from_euler_xyz(np.radians([[0, 0, 90.0], [0, 0, -90], [0, 0, 0]]))


def test_at_rest_each_bone_starts_where_its_parent_ends():
    frames = ARM.evaluate()
    np.testing.assert_allclose(frames.start, [[0, 0, 0], [0, 3, 0], [0, 5, 0]])
    np.testing.assert_allclose(frames.end, [[0, 3, 0], [0, 5, 0], [0, 6, 0]])


def test_a_bent_arm_by_hand():
    frames = ARM.evaluate(BENT)
    np.testing.assert_allclose(frames.end, [[-3, 0, 0], [-3, 2, 0], [-3, 3, 0]], atol=1e-12)


def test_lengths_may_differ_between_the_actors_of_a_batch():
    ends = ARM.evaluate(length=np.array([[3.0, 2, 1], [0, 2, 1]])).end
    np.testing.assert_allclose(ends[:, 2], [[0, 6, 0], [0, 3, 0]])


def test_a_translation_moves_the_bone_off_its_parents_end():
    moved = np.array([[0.0, 0, 0], [0, 0, 0.5], [0, 0, 0]])
    np.testing.assert_allclose(ARM.evaluate(translation=moved).start[1:], [[0, 3, 0.5], [0, 5, 0.5]])


def test_their_arrays_cannot_be_written():
    locked_arrays.check(ARM)
