"""What counts as ground below a foot over, beside and in a step, against its height and its distance."""

from __future__ import annotations

import numpy as np
import pytest
from foot_at_step import EDGE, FEET, FRONT, HEIGHT, LOWEST, ON_THE_FLOOR, SOLE, legs_at, toes_up
from foot_kernels import gently, raised
from statwalk.solve.foot_flight import BRAKES, FASTEST_FALL, HASTE, SLOWEST_FALL
from statwalk.solve.foot_height import KERB, WAY_OUT
from statwalk.solve.foot_tables import OF_FOOT, Y


def floor(y: float, z: float, level: float, old: float = 0.0) -> float:
    """By how much a level foot at y, z is raised; `level`: how high its sole was a tick before."""
    keep = np.zeros((1, OF_FOOT))
    keep[0, Y] = old
    return float(raised(FEET, legs_at(y, z), keep, level - y - LOWEST))


def test_a_foot_on_the_floor_is_not_raised_by_the_step_beside_it() -> None:
    assert floor(ON_THE_FLOOR, EDGE - FRONT + 0.01, 0.0) == pytest.approx(0, abs=1e-6)


def test_a_foot_that_comes_down_on_the_step_stops_there() -> None:
    """It was 1 cm above the step, and its motion is 2 cm below it now."""
    wanted = floor(HEIGHT - LOWEST - 0.02, EDGE + 0.5, HEIGHT + 0.01)
    assert wanted == pytest.approx(0.02, abs=1e-6)


def counted(points: np.ndarray) -> float:
    """By how much a foot with these points is raised by the step and the floor, each point by itself."""
    over = np.where(points[:, 2] >= EDGE, HEIGHT, 0.0) - points[:, 1]
    return float(np.where(over <= KERB, over, np.maximum(2 * KERB - over, 0)).max())


def test_what_is_higher_counts_less_and_less() -> None:
    levels, z = np.linspace(HEIGHT, -0.1, 221), EDGE - FRONT + 0.05
    floors = np.array([floor(level - LOWEST, z, level) for level in levels])
    assert 0.015 < floors.max() <= KERB
    assert np.abs(np.diff(floors)).max() < 0.0011
    assert floors == pytest.approx(
        [counted(np.add(SOLE, (0, level - LOWEST, z))) for level in levels], abs=1e-6
    )


def test_toes_that_are_just_below_a_step_come_on_to_it_however_low_the_heel_is() -> None:
    """They are 1 cm over the edge and 7 mm below it; the heel is more than a kerb lower."""
    angle = 0.3
    sole = SOLE @ [[1, 0, 0], [0, np.cos(angle), -np.sin(angle)], [0, np.sin(angle), np.cos(angle)]]
    toe = sole[sole[:, 2].argmax()]
    y, z = HEIGHT - 0.007 - toe[1], EDGE + 0.01 - toe[2]
    assert sole[:, 1].min() < toe[1] - 2 * KERB
    wanted = raised(FEET, toes_up(legs_at(y, z), angle), np.zeros((1, OF_FOOT)), 0.0)
    assert wanted == pytest.approx(counted(np.add(sole, (0, y, z))), abs=1e-6)
    assert wanted > 0.007


def test_a_foot_in_the_middle_of_a_step_rises_out_of_it_slowly() -> None:
    assert floor(ON_THE_FLOOR, EDGE + 1.0, 0.0, old=0.03) == pytest.approx(0.03 + WAY_OUT / 60, abs=1e-6)


def lowered(to: float, old: float, rate: float, shown: float, floor: float) -> float:
    """The height of a foot that would come down from `old` to `to` in a tick."""
    keep = np.zeros((1, OF_FOOT))
    keep[0, Y] = to
    gently(keep, old, rate, shown, floor)
    return float(keep[0, Y])


def test_a_foot_that_is_lowered_far_does_not_fall_at_once() -> None:
    assert lowered(-0.1, 0.0, 0.0, 0.0, -0.36) == pytest.approx(-HASTE / 3600)
    assert lowered(-0.3, -0.1, -60.0, -0.1, -0.36) == pytest.approx(-0.1 - FASTEST_FALL / 60)


def test_a_foot_that_is_lowered_brakes_before_the_ground() -> None:
    fall = SLOWEST_FALL + BRAKES * 0.01
    assert lowered(-0.1, -0.09, -3.0, -0.09, -0.1) == pytest.approx(-0.09 - fall / 60)


def test_a_foot_that_its_motion_brings_down_is_not_held_above_it() -> None:
    assert lowered(0.0, 0.0, 0.0, 0.1, -0.2) == 0.0


def test_a_foot_on_the_ground_is_not_below_it() -> None:
    assert lowered(-0.05, -0.04, 0.0, -0.049, -0.05) == -0.05
