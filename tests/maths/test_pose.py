"""Poses: copies, rows of a crowd, blending."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation, Slerp
from statwalk.maths import quat
from statwalk.maths.pose import Pose, rest

RNG = np.random.default_rng(11)


def some_pose(*leading: int) -> Pose:
    turns = quat.normalize(RNG.normal(size=(*leading, 4, 4)))
    return Pose(
        RNG.normal(size=(*leading, 4, 3)),
        turns,
        RNG.uniform(0.5, 2, (*leading, 4, 3)),
        RNG.uniform(size=(*leading, 2)),
    )


def test_blend_is_straight_for_places_sizes_and_weights():
    a, b = some_pose(), some_pose()
    blended = a.blend(b, 0.25)
    for name in ("translation", "scale", "weights"):
        np.testing.assert_allclose(
            getattr(blended, name), 0.75 * getattr(a, name) + 0.25 * getattr(b, name), atol=1e-15
        )


def test_blend_is_scipys_slerp_for_rotations():
    a, b = some_pose(), some_pose()
    blended = a.blend(b, 0.25).rotation
    expected = [
        Slerp([0, 1], Rotation.from_quat([p, q]))(0.25).as_quat()
        for p, q in zip(a.rotation, b.rotation, strict=True)
    ]
    np.testing.assert_allclose(quat.align(np.array(expected), blended), expected, atol=1e-12)


def test_a_weight_for_each_actor():
    a, b = some_pose(3), some_pose(3)
    blended = a.blend(b, np.array([0.0, 0.5, 1.0]))
    np.testing.assert_array_equal(blended.take(0).rotation, a.take(0).rotation)
    np.testing.assert_array_equal(blended.take(1).translation, a.take(1).blend(b.take(1), 0.5).translation)


def test_a_copy_is_independent():
    pose = rest(3)
    pose.copy().translation[:] = 5
    assert (pose.translation == 0).all()


@pytest.mark.parametrize("array", rest(2, 3))
def test_rest_is_float32(array):
    assert array.dtype == np.float32
