"""A knee bends about the hinge of its thigh, wherever the ankle is: against the way to the ankle, turned by a
right angle about that hinge.
"""

from __future__ import annotations

import numpy as np
import pytest
from foot_at_step import FEET, legs_at
from foot_kernels import bend_knee
from statwalk.solve.chains import ROWS, TARGET

LEGS = legs_at(0.0, 0.0)
"""the hip is at the origin"""
BENT = np.radians(64)
"""from the thigh to the direction in which the knee bends, as in KayKit's models"""


def _rows(direction: list[float]) -> np.ndarray:
    rows = np.tile(direction, (len(FEET.bend), 1))
    rows.flags.writeable = False
    return rows


BEND, ACROSS = [0.0, -np.cos(BENT), np.sin(BENT)], [0.0, -np.sin(BENT), -np.cos(BENT)]
"""the thigh points down"""
KNIGHT = FEET._replace(bend=_rows(BEND), across=_rows(ACROSS))


def way(angle_deg: float, aside: float = 0.0) -> np.ndarray:
    """The direction to an ankle that is turned forward from the thigh; `aside`: to the left."""
    angle = np.radians(angle_deg)
    direction = np.array([aside, -np.cos(angle), np.sin(angle)])
    return direction / np.linalg.norm(direction)


def pole_of(direction: np.ndarray) -> np.ndarray:
    """The unit vector in which the solver bends the knee: the pole, at right angles to the way."""
    inputs, pole = np.zeros((ROWS, 16), np.float32), np.zeros(3)
    inputs[TARGET : TARGET + 3, 0] = direction * 0.4
    bend_knee(KNIGHT, LEGS, inputs, pole)
    pole -= pole @ direction * direction
    return pole / np.linalg.norm(pole)


@pytest.mark.parametrize("angle_deg", range(-110, 180, 10))
def test_a_knee_bends_about_its_hinge(angle_deg: float) -> None:
    np.testing.assert_allclose(pole_of(way(angle_deg)), way(angle_deg + 90), atol=1e-6)


def test_a_knee_never_flips_on_the_way_of_a_foot_beside_it() -> None:
    poles = np.array([pole_of(way(angle, aside=0.1)) for angle in np.arange(-110, 170, 2)])
    assert np.degrees(np.arccos((poles[1:] * poles[:-1]).sum(1).clip(-1, 1))).max() < 8


def test_below_the_hip_the_bend_of_the_clips_counts() -> None:
    """Sideways the hinge would give another direction than the bend."""
    direction = way(0, aside=0.2)
    expected = BEND - BEND @ direction * direction
    np.testing.assert_allclose(pole_of(direction), expected / np.linalg.norm(expected), atol=1e-6)
