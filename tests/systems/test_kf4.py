"""KF4 quaternion interpolation (FAQ Q17): slerp along the shorter arc at constant angular speed; squad
without kinks.
"""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation, Slerp
from text_character import from_text, keyed

BONE = "Root --- - - - -\nArm Root 2 1 0 0\n"
ANGLES = np.array([[0.0, 0, 0], [70, 20, -50], [10, -80, 30], [-60, 10, 20]])
TIMES = [0.0, 0.5, 1.0, 1.5]


UNEVEN = [0.0, 0.6, 1.2, 3.0]


def turns(
    tmp_path,
    interpolation: str,
    moments: np.ndarray,
    times: list[float] = TIMES,
    angles: np.ndarray | list[list[float]] = ANGLES,
) -> Rotation:
    arm = from_text(
        tmp_path, BONE, swing=(keyed(times, "#rotate", "Arm", angles), f"interpolation: {interpolation}")
    )
    return Rotation.from_quat(arm.clip("swing").sample(moments).rotation[:, 1])


def speeds(rotations: Rotation, dt: float) -> np.ndarray:
    """Angular velocity vectors between successive moments, rad/s."""
    return (rotations[:-1].inv() * rotations[1:]).as_rotvec() / dt


def test_slerp_is_scipys(tmp_path):
    moments = np.linspace(0, 1.5, 61)
    expected = Slerp(TIMES, Rotation.from_euler("xyz", ANGLES, degrees=True))(moments)
    assert (turns(tmp_path, "slerp", moments) * expected.inv()).magnitude().max() < 2e-6


def test_slerp_has_constant_angular_speed(tmp_path):
    speed = np.linalg.norm(speeds(turns(tmp_path, "slerp", np.linspace(0, 0.5, 21)), 0.025), axis=1)
    np.testing.assert_allclose(speed, speed.mean(), rtol=1e-4)


def test_squad_meets_the_keys(tmp_path):
    expected = Rotation.from_euler("xyz", ANGLES, degrees=True)
    assert (turns(tmp_path, "squad", np.array(TIMES)) * expected.inv()).magnitude().max() < 1e-6


def test_squad_turns_the_corner_that_slerp_takes_sharply(tmp_path):
    around = 0.5 + np.array([-1, 0, 1]) / 60
    corner = {
        name: np.linalg.norm(np.diff(speeds(turns(tmp_path, name, around), 1 / 60), axis=0))
        for name in ("slerp", "squad")
    }
    assert corner["squad"] < 0.15 * corner["slerp"]


def test_squad_passes_a_key_between_uneven_times_at_one_speed(tmp_path):
    moments = 1.2 + np.array([-1, 0, 1]) / 60
    before, after = speeds(turns(tmp_path, "squad", moments, UNEVEN), 1 / 60)
    assert np.linalg.norm(after - before) < 0.1 * np.linalg.norm(before)


def test_squad_passes_a_key_at_the_speed_of_the_parabola_about_one_axis(tmp_path):
    angles = [[0.0, 0, 0], [0, 30, 0], [0, 90, 0], [0, 100, 0]]
    arm = from_text(tmp_path, BONE, swing=(keyed(UNEVEN, "#rotate", "Arm", angles), "interpolation: squad"))
    moments = 1.2 + np.array([-1, 0, 1]) / 1024
    at = Rotation.from_quat(arm.clip("swing").sample(moments).rotation[:, 1]).as_rotvec(degrees=True)[:, 1]
    slope = np.polyfit(UNEVEN[1:], [30, 90, 100], 2) @ [2 * 1.2, 1, 0]  # degrees a second: 75.4
    np.testing.assert_allclose(np.diff(at) * 1024, slope, rtol=0.03)


LAP = [[0.0, 0, 0], [70, 20, -50], [10, -80, 30], [0, 0, 0]]


def seam(tmp_path, times, angles):
    """The velocities just before and just after the end of a lap."""
    around = np.array([times[-1] - 1 / 512, times[-1], 0, 1 / 512])
    turned = turns(tmp_path, "squad, loop: true", around, times, angles)
    return speeds(turned[:2], 1 / 512)[0], speeds(turned[2:], 1 / 512)[0]


@pytest.mark.parametrize("times", [TIMES, UNEVEN], ids=["even", "uneven"])
def test_squad_goes_on_into_the_next_lap_at_one_speed(tmp_path, times):
    before, after = seam(tmp_path, times, LAP)
    assert np.linalg.norm(before) > 0.3
    np.testing.assert_allclose(after, before, atol=0.12 * np.linalg.norm(before))


def test_squad_turns_evenly_through_laps_of_a_whole_turn(tmp_path):
    before, after = seam(tmp_path, [0.0, 1, 2, 3, 4], [[0.0, angle, 0] for angle in (0, 90, 180, 270, 360)])
    np.testing.assert_allclose([before, after], [[0, np.pi / 2, 0]] * 2, atol=1e-3)


def test_squad_without_a_loop_ends_as_it_did_where_its_ends_meet(tmp_path):
    moments = np.linspace(0, 1.5, 31)
    laps = turns(tmp_path, "squad, loop: true", moments, TIMES, LAP)
    once = turns(tmp_path, "squad", moments, TIMES, LAP)
    inner = (moments >= 0.5) & (moments <= 1.0)
    assert (laps[inner] * once[inner].inv()).magnitude().max() < 1e-6
    assert (laps * once.inv()).magnitude().max() > 0.02
