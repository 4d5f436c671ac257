"""How a foot lies on uneven ground, and its path through the air, worked out by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest
from foot_kernels import land, lie
from paths import MACHINES
from statwalk.services.library.load import load_role
from statwalk.solve.foot_tables import FROM_X, FROM_Z, HALF_LENGTH, HEIGHT, OF_FIT, FootTables
from statwalk.solve.footing import CALF_ROOM

LEGS = load_role(MACHINES / "terrain").solvers.legs
HALF = float(LEGS.print[0, HALF_LENGTH])
STEP = (-1.0, 1.0, 1.0, 2.0, 0.1, 0.0, 0.0)
"""from z = 1, 0.1 high"""


def _locked(array: np.ndarray) -> np.ndarray:
    array.flags.writeable = False
    return array


def on(*pieces: tuple[float, ...]) -> FootTables:
    return LEGS._replace(ground=_locked(np.array(pieces, np.float64).reshape(-1, 7)))


def lying(feet: FootTables, x: float, z: float, yaw: float = 0.0) -> np.ndarray:
    out = np.zeros(4)
    lie(feet, 0, x, z, math.sin(yaw), math.cos(yaw), out)
    return out


@pytest.mark.parametrize("yaw", [0.0, 0.4, 1.5, -2.0])
def test_a_foot_on_a_slope_has_its_slope_whatever_its_yaw(yaw: float) -> None:
    slope = (-5.0, -5.0, 5.0, 5.0, 2.0, 0.1, -0.2)
    x, z, height, supported = lying(on(slope), 0.5, 1.0, yaw)
    assert (x, z) == pytest.approx((0.1, -0.2))
    assert height == pytest.approx(2.0 + 0.05 - 0.2)
    assert supported == 15


def test_a_foot_lies_no_steeper_than_thirty_degrees() -> None:
    x, z, _, _ = lying(on((-5.0, -5.0, 5.0, 5.0, 9.0, 0.0, 1.5)), 0.0, 0.0)
    assert math.degrees(math.atan(math.hypot(x, z))) == pytest.approx(30, abs=0.01)


def test_a_foot_over_the_edge_of_a_step_is_level_and_on_the_step() -> None:
    x, z, height, supported = lying(on(STEP), 0.0, 1.0 - 0.5 * HALF)
    assert (x, z, height) == (0, 0, 0.1)
    assert 0 < supported < 15


def test_a_foot_in_front_of_a_step_is_on_the_floor() -> None:
    assert lying(on(STEP), 0.0, 1.0 - HALF - 0.01)[2] == 0


def landed(feet: FootTables, z: float) -> tuple[float, np.ndarray, np.ndarray]:
    """Where a foot lands in z that sets off at z = 0 on the floor, and z and heights along its path."""
    keep, place, path = np.zeros((1, OF_FIT)), np.zeros(2), np.zeros((41, 2))
    keep[0, FROM_X], keep[0, FROM_Z], keep[0, HEIGHT] = 0.0, 0.0, 0.0
    land(feet, 0, 0.0, z, keep, place, path)
    return float(place[1]), path[:, 0] * place[1], path[:, 1]


def test_on_a_level_floor_a_foot_lands_where_its_motion_does_and_goes_evenly() -> None:
    place, ways, heights = landed(on(), 0.9)
    assert place == 0.9
    assert ways == pytest.approx(np.linspace(0, 0.9, 41))
    assert not heights.any()


def test_a_foot_lands_wholly_on_a_step_or_wholly_before_it() -> None:
    place, _, _ = landed(on(STEP), 1.0 + 0.5 * HALF)
    assert place - HALF > 1.0
    place, _, _ = landed(on(STEP), 1.0 - 0.9 * HALF)
    assert place + HALF < 1.0


@pytest.mark.parametrize(("height", "room"), [(0.4, CALF_ROOM), (0.1, 0.0)])
def test_a_foot_lands_so_far_from_a_wall_behind_it_that_its_calf_has_room(height: float, room: float) -> None:
    wall = (-1.0, -1.0, 1.0, 0.5, height, 0.0, 0.0)
    place, _, _ = landed(on(wall), 0.5 + HALF + 0.015)
    assert room <= place - HALF - 0.5 < room + 0.03


def test_a_path_begins_and_ends_on_the_ground_and_is_above_all_between() -> None:
    hurdle = (-1.0, 0.5, 1.0, 0.6, 0.2, 0.0, 0.0)
    place, ways, heights = landed(on(hurdle), 1.0)
    assert (ways[0], ways[-1]) == pytest.approx((0, place))
    assert (heights[0], heights[-1]) == pytest.approx((0, 0), abs=1e-9)
    over = (ways + HALF > 0.5) & (ways - HALF < 0.6)
    assert heights[over].min() > 0.17  # its corners are rounded
    assert np.abs(np.diff(heights, 2)).max() < 0.02
    assert np.diff(ways).min() > 0


def test_a_foot_close_to_a_step_rises_before_it_goes_on() -> None:
    """Its toes are 2 cm before the step: when they are over it, all of the foot is above it."""
    near = (-1.0, HALF + 0.02, 1.0, 2.0, 0.1, 0.0, 0.0)
    _, ways, heights = landed(on(near), 0.9)
    assert heights[ways > 0.02].min() > 0.07  # its corners are rounded
    assert ways[heights < 0.05].max() < 0.015


def test_the_way_up_a_step_does_not_come_down_between() -> None:
    _, _, heights = landed(on(STEP), 1.4)
    assert heights[-1] == pytest.approx(0.1)
    assert np.diff(heights).min() > -0.002
