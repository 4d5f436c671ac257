"""Turns of limbs given by points: the target is reached from the turned bones; a right angle by hand."""

import numpy as np
from scipy.spatial.transform import Rotation
from statwalk.maths import quat
from statwalk.solve.limb_turns import two_bone


def test_the_turned_bones_end_at_the_target():
    root, mid, end, pole = np.random.default_rng(17).normal(size=(4, 100, 3))
    reach = np.linalg.norm(mid - root, axis=1) + np.linalg.norm(end - mid, axis=1)
    least = np.abs(np.linalg.norm(mid - root, axis=1) - np.linalg.norm(end - mid, axis=1))
    aim = Rotation.random(100, np.random.default_rng(1)).apply([0, 0, 1])
    target = root + aim * ((reach + least) / 2)[:, None]
    upper, lower = two_bone(root, mid, end, target, pole)
    solved = root + quat.rotate(upper, mid - root) + quat.rotate(lower, end - mid)
    np.testing.assert_allclose(solved, target, atol=1e-5)


def test_a_right_angle_worked_out_by_hand():
    hip, knee, ankle = np.array([[0.0, 2, 0]]), np.array([[0.0, 1, 0]]), np.array([[0.0, 0, 0]])
    upper, lower = two_bone(hip, knee, ankle, np.array([[0.0, 1, 1]]), np.array([[0.0, 0, 1]]))
    expected = Rotation.from_euler("x", -90, degrees=True).as_quat()
    np.testing.assert_allclose(np.abs((upper * expected).sum()), 1, atol=1e-6)
    np.testing.assert_allclose(np.abs(lower[0, 3]), 1, atol=1e-6)
