"""Two-bone IK: the target is reached, the bones keep their lengths, the knee is on its side."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from statwalk.maths import quat
from statwalk.solve.two_bone import two_bone

RNG = np.random.default_rng(17)
ROOT, MID, END, POLE = (RNG.normal(size=(500, 3)) for _ in range(4))
UPPER, LOWER = np.linalg.norm(MID - ROOT, axis=1), np.linalg.norm(END - MID, axis=1)
AIM = RNG.normal(size=(500, 3))
AIM /= np.linalg.norm(AIM, axis=1, keepdims=True)
NEAREST, FURTHEST = np.abs(UPPER - LOWER), UPPER + LOWER


def solved(target, pole=POLE):
    """Middle and end after the turns."""
    turn_root, turn_mid = two_bone(ROOT, MID, END, target, pole)
    mid = ROOT + quat.rotate(turn_root, MID - ROOT)
    return mid, mid + quat.rotate(turn_mid, END - MID)


WITHIN = ROOT + AIM * (NEAREST + (FURTHEST - NEAREST) * RNG.uniform(0.05, 0.95, 500))[:, None]


def test_reaches_the_target():
    np.testing.assert_allclose(solved(WITHIN)[1], WITHIN, atol=1e-12)


def test_bones_keep_their_lengths():
    mid, end = solved(WITHIN)
    np.testing.assert_allclose(np.linalg.norm(mid - ROOT, axis=1), UPPER, atol=1e-13)
    np.testing.assert_allclose(np.linalg.norm(end - mid, axis=1), LOWER, atol=1e-13)


def test_the_knee_is_on_the_side_of_the_pole():
    mid, _ = solved(WITHIN)
    aside = POLE - AIM * (POLE * AIM).sum(1, keepdims=True)
    assert ((mid - ROOT) * aside).sum(1).min() > 0


@pytest.mark.parametrize("times", [1.0, 1.5, 100.0])
def test_out_of_reach_it_points_at_the_target(times):
    mid, end = solved(ROOT + AIM * FURTHEST[:, None] * times)
    np.testing.assert_allclose(end, ROOT + AIM * FURTHEST[:, None], atol=1e-6)
    np.testing.assert_allclose(mid, ROOT + AIM * UPPER[:, None], atol=1e-6)


def test_too_near_it_folds_towards_the_target():
    np.testing.assert_allclose(
        solved(ROOT + AIM * NEAREST[:, None] * 0.5)[1], ROOT + AIM * NEAREST[:, None], atol=1e-6
    )


def test_a_right_angle_worked_out_by_hand():
    hip, knee, ankle = np.array([0.0, 2, 0]), np.array([0.0, 1, 0]), np.array([0.0, 0, 0])
    turn_hip, turn_knee = two_bone(hip, knee, ankle, np.array([0.0, 1, 1]), np.array([0.0, 0, 1]))
    np.testing.assert_allclose(hip + quat.rotate(turn_hip, knee - hip), [0, 2, 1], atol=1e-7)
    np.testing.assert_allclose(turn_hip, Rotation.from_euler("x", -90, degrees=True).as_quat(), atol=1e-7)
    np.testing.assert_allclose(turn_knee, quat.IDENTITY, atol=1e-7)


def test_the_hinge_turns_with_the_plane_of_the_limb():
    turn_root, _ = two_bone(ROOT, MID, END, WITHIN, POLE)
    mid, end = solved(WITHIN)
    old, new = np.cross(MID - ROOT, END - MID), np.cross(mid - ROOT, end - mid)
    turned = quat.rotate(turn_root, old / np.linalg.norm(old, axis=1, keepdims=True))
    np.testing.assert_allclose(turned, new / np.linalg.norm(new, axis=1, keepdims=True), atol=1e-9)


@pytest.mark.parametrize("target", [[0.0, 2, 0], [0.0, 0, 0], [0.0, 5, 0]])
def test_degenerate_targets_and_poles_give_rotations(target):
    hip, knee, ankle = np.array([0.0, 2, 0]), np.array([0.0, 1, 0]), np.array([0.0, 0, 0])
    for turn in two_bone(hip, knee, ankle, np.array(target), np.array([0.0, -1, 0])):
        assert np.linalg.norm(turn) == pytest.approx(1, abs=1e-12)


def test_float32_stays_float32():
    turns = two_bone(*(points.astype(np.float32) for points in (ROOT, MID, END, WITHIN, POLE)))
    assert {turn.dtype for turn in turns} == {np.dtype(np.float32)}
