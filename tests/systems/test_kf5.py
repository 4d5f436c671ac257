"""KF5 B-spline interpolation (FAQ Q17): uniform cubic, near the keys and through them; rotations by the
cumulative form.
"""

import numpy as np
import pytest
from scipy.interpolate import BSpline, CubicSpline
from scipy.spatial.transform import Rotation
from text_character import from_text, keyed, place

BONE = "Root --- - - - -\nArm Root 2 1 0 0\n"
TIMES = [0.0, 1.0, 2.0, 3.0, 4.0]
PLACES = np.array([[0.0, 0, 0], [1, 3, 0], [2, -1, 4], [5, 0, 0], [6, 2, 2]])
MOMENTS = np.linspace(0, 4, 41)


def arm(tmp_path, command: str, values: np.ndarray, interpolation: str):
    return from_text(
        tmp_path, BONE, move=(keyed(TIMES, command, "Arm", values), f"interpolation: {interpolation}")
    )


def path(tmp_path, interpolation: str) -> np.ndarray:
    character = arm(tmp_path, "#translate", PLACES, interpolation)
    return np.array([place(character, character.clip("move").sample(moment), "Arm") for moment in MOMENTS])


def test_near_the_keys_is_scipys_uniform_cubic_bspline(tmp_path):
    extended = np.vstack([2 * PLACES[0] - PLACES[1], PLACES, 2 * PLACES[-1] - PLACES[-2]])
    expected = BSpline(np.arange(-3.0, 8), extended, 3)
    np.testing.assert_allclose(path(tmp_path, "b-spline"), expected(MOMENTS), atol=1e-5)


def test_through_the_keys_is_scipys_natural_cubic_spline(tmp_path):
    np.testing.assert_allclose(
        path(tmp_path, "b-spline through"), CubicSpline(TIMES, PLACES, bc_type="natural")(MOMENTS), atol=1e-5
    )


@pytest.mark.parametrize("interpolation", ["b-spline", "b-spline through"])
def test_acceleration_has_no_step(tmp_path, interpolation):
    character = arm(tmp_path, "#translate", PLACES, interpolation)
    fine = character.clip("move").sample(np.linspace(1.9, 2.1, 41)).translation[:, 1].astype(np.float64)
    acceleration = np.diff(fine[::4], 2, axis=0) / 0.02**2
    assert np.abs(np.diff(acceleration, axis=0)).max() < 0.2 * np.abs(acceleration).max() + 0.5


def turns(tmp_path, interpolation: str, angles: np.ndarray, moments) -> Rotation:
    return Rotation.from_quat(
        arm(tmp_path, "#rotate", angles, interpolation).clip("move").sample(moments).rotation[:, 1]
    )


def test_rotations_about_one_axis_follow_the_bspline_of_the_angle(tmp_path):
    angle = np.array([0.0, 40, -20, 30, 60])
    expected = BSpline(np.arange(-3.0, 8), [2 * angle[0] - angle[1], *angle, 2 * angle[-1] - angle[-2]], 3)(
        MOMENTS
    )
    measured = turns(tmp_path, "b-spline", angle[:, None] * [0, 0, 1], MOMENTS).as_rotvec(degrees=True)
    np.testing.assert_allclose(measured, expected[:, None] * [0, 0, 1], atol=2e-4)


def test_rotations_through_the_keys_meet_them(tmp_path):
    angles = np.array([[0.0, 0, 0], [30, 20, 0], [10, -20, 40], [0, 0, 20], [-20, 30, 10]])
    met = turns(tmp_path, "b-spline through", angles, np.array(TIMES))
    assert (met * Rotation.from_euler("xyz", angles, degrees=True).inv()).magnitude().max() < 2e-6


def test_rotations_are_the_cumulative_product_of_kim_kim_and_shin(tmp_path):
    angles = np.array([[0.0, 0, 0], [30, 20, 0], [10, -20, 40], [0, 0, 20], [-20, 30, 10]])
    keys, f = Rotation.from_euler("xyz", angles, degrees=True), 0.3
    parts = (1 - (1 - f) ** 3 / 6, (1 + 3 * f + 3 * f**2 - 2 * f**3) / 6, f**3 / 6)
    expected = keys[0]
    for k, part in enumerate(parts):
        expected = expected * Rotation.from_rotvec((keys[k].inv() * keys[k + 1]).as_rotvec() * part)
    assert (turns(tmp_path, "b-spline", angles, np.array([1 + f]))[0] * expected.inv()).magnitude() < 2e-6
