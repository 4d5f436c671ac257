"""Clamped rotations and translations against SciPy's angles, at poles too."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from statwalk.maths import clamp, clamp_table, quat
from statwalk.maths.clamp_kinds import CONE, EULER, HINGE, RANGE
from statwalk.maths.clamp_table import JointLimit, frame_of
from statwalk.maths.pose import Pose

TURNS = Rotation.random(2000, random_state=6)
POLES = np.array(
    [
        [1, 0, 0, 0],
        [0, 1, 0, 0],
        [0, 0, 1, 0],
        [0, 0, 0, -1],
        [0, 0.5**0.5, 0, 0.5**0.5],
        [0.5, -0.5, 0.5, 0.5],
    ]
)
ROW = np.array([0])
REST = Rotation.from_euler("xyz", [0.4, -0.2, 0.9])


def table(limit):
    rest = Pose(np.array([[1.0, 2, 3]]), REST.as_quat()[None], np.ones((1, 3)), np.zeros(0))
    return clamp_table.clamp_table({0: limit}, rest)


def clamped(limit, turns):
    """The rotations (N, 4) relative to the rest pose, clamped."""
    local = (REST * Rotation.from_quat(turns)).as_quat()[:, None]
    return REST.inv() * Rotation.from_quat(clamp.clamp_rotation(table(limit), ROW, local)[:, 0])


@pytest.mark.parametrize(
    "limit",
    [
        JointLimit(HINGE, twist=(-0.2, 2.3)),
        JointLimit(CONE, twist=(-1, 1), swing=((-0.3, 1), (-0.7, 0.7))),
        JointLimit(CONE, swing=((0, 1), (0, 0.01))),
        JointLimit(RANGE, twist=(2, 4), swing=((-0.3, 1), (0.2, 0.7))),
        JointLimit(EULER, angles=((-1, 1), (-2, 2), (0, 0))),
    ],
)
def test_a_clamped_rotation_is_inside_and_stays_as_it_is(limit):
    once = clamped(limit, np.concatenate([TURNS.as_quat(), POLES]))
    assert np.isfinite(once.as_quat()).all()
    twice = clamped(limit, once.as_quat())
    assert (once * twice.inv()).magnitude().max() < 3e-6


def test_a_hinge_keeps_the_twist_alone():
    axis = np.array([0.6, 0, 0.8])
    limit = JointLimit(HINGE, tuple(frame_of(axis)), (-0.5, 1.2))
    vectors = clamped(limit, TURNS.as_quat()).as_rotvec()
    along = vectors @ axis
    np.testing.assert_allclose(vectors, along[:, None] * axis, atol=1e-6)
    assert along.min() == pytest.approx(-0.5, abs=1e-6)
    assert along.max() == pytest.approx(1.2, abs=1e-6)


def test_a_swing_goes_to_the_nearest_swing_of_the_ellipse():
    limit = JointLimit(CONE, swing=((-0.5, 0.5), (-1, 1)))
    wanted = np.array([[0.9, 0.0], [0.0, -1.4], [0.8, 1.1]])
    vectors = np.stack([wanted[:, 0], np.zeros(3), wanted[:, 1]], -1)
    found = clamped(limit, Rotation.from_rotvec(vectors).as_quat()).as_rotvec()[:, [0, 2]]
    around = np.linspace(0, 2 * np.pi, 200_001)
    edge = np.stack([0.5 * np.cos(around), np.sin(around)], -1)
    nearest = [edge[((edge - point) ** 2).sum(-1).argmin()] for point in wanted]
    np.testing.assert_allclose(found, nearest, atol=2e-5)


def test_angles_are_clamped_one_by_one_in_the_order_x_y_z():
    limit = JointLimit(EULER, angles=((-0.3, 0.4), (-0.5, 0.6), (-0.7, 0.8)))
    angles = np.random.default_rng(1).uniform(-1.5, 1.5, (500, 3))
    found = clamped(limit, Rotation.from_euler("xyz", angles).as_quat()).as_euler("xyz")
    np.testing.assert_allclose(found, np.clip(angles, [-0.3, -0.5, -0.7], [0.4, 0.6, 0.8]), atol=1e-6)


@pytest.mark.parametrize("about_y", [np.pi / 2, -np.pi / 2])
def test_in_gimbal_lock_a_rotation_that_limits_allow_stays(about_y):
    limit = JointLimit(EULER, angles=((0.5, 1.5), (-2, 2), (-0.1, 0.1)))
    turn = Rotation.from_euler("xyz", [1.0, about_y, 0.0]).as_quat()[None]
    local = (REST * Rotation.from_quat(turn)).as_quat()[:, None]
    np.testing.assert_array_equal(clamp.clamp_rotation(table(limit), ROW, local), local)


def test_inside_the_limits_the_input_comes_back_bit_for_bit():
    limit = JointLimit(CONE, twist=(-1, 1), swing=((-0.3, 1), (-0.7, 0.7)))
    swing = np.random.default_rng(2).uniform([-0.2, -0.4], [0.5, 0.4], (300, 2))
    turn = clamp.from_swing_twist(clamp.Turn(np.linspace(-1, 1, 300), swing))
    local = quat.mul(np.broadcast_to(REST.as_quat(), turn.shape), turn)[:, None].astype(np.float32)
    np.testing.assert_array_equal(clamp.clamp_rotation(table(limit), ROW, local), local)


def test_a_translation_is_clamped_along_the_axes_of_the_rest_pose():
    limit = JointLimit(slide=((-1, 1), (0, 0), (0, 0.5)))
    ways = np.random.default_rng(3).normal(size=(100, 3)) * 2
    found = clamp.clamp_translation(table(limit), ROW, (np.array([1, 2, 3]) + REST.apply(ways))[:, None])
    expected = np.clip(ways, [-1, 0, 0], [1, 0, 0.5])
    np.testing.assert_allclose(REST.inv().apply(found[:, 0] - [1, 2, 3]), expected, atol=1e-6)


def test_swing_and_twist_make_the_rotation_again():
    turns = TURNS.as_quat()
    again = clamp.from_swing_twist(clamp.swing_twist(turns))
    assert (Rotation.from_quat(again) * TURNS.inv()).magnitude().max() < 1e-9
