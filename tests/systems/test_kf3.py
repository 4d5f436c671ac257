"""KF3 linear interpolation (FAQ Q17): P = P0·(1−f) + P1·f on angles and places; on quaternions straight and
normalised.
"""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from statwalk.maths import quat
from text_character import from_text, keyed, place

BONE = "Root --- - - - -\nArm Root 2 1 0 0\n"
ANGLES = np.array([[10.0, 20, -30], [80, -40, 60]])
MOMENTS = [0.0, 0.25, 0.6, 1.0]


def arm_turn(tmp_path, interpolation: str, time: float) -> Rotation:
    arm = from_text(
        tmp_path, BONE, swing=(keyed([0, 1], "#rotate", "Arm", ANGLES), f"interpolation: {interpolation}")
    )
    return Rotation.from_quat(arm.clip("swing").sample(time).rotation[1])


@pytest.mark.parametrize("time", MOMENTS)
def test_the_faqs_own_way_interpolates_each_angle(tmp_path, time):
    expected = Rotation.from_euler("xyz", ANGLES[0] * (1 - time) + ANGLES[1] * time, degrees=True)
    assert (arm_turn(tmp_path, "euler linear", time) * expected.inv()).magnitude() < 2e-4


@pytest.mark.parametrize("time", MOMENTS)
def test_quaternions_are_normalised_along_the_shorter_arc(tmp_path, time):
    q0, q1 = Rotation.from_euler("xyz", ANGLES, degrees=True).as_quat()
    expected = Rotation.from_quat(q0 * (1 - time) + np.sign(q0 @ q1) * q1 * time)
    assert (arm_turn(tmp_path, "linear", time) * expected.inv()).magnitude() < 2e-4


def test_the_sign_of_a_quaternion_does_not_matter():
    q0, q1 = Rotation.from_euler("xyz", ANGLES, degrees=True).as_quat()
    np.testing.assert_allclose(quat.nlerp(q0, -q1, 0.3), quat.nlerp(q0, q1, 0.3), atol=1e-15)


@pytest.mark.parametrize("time", MOMENTS)
def test_places_go_straight(tmp_path, time):
    arm = from_text(
        tmp_path,
        BONE,
        slide=(keyed([0, 1], "#translate", "Arm", np.array([[0, 0, 0], [3, 5, 7]])), "interpolation: linear"),
    )
    np.testing.assert_allclose(
        place(arm, arm.clip("slide").sample(time), "Arm"), np.array([3, 5, 7]) * time, atol=1e-6
    )
