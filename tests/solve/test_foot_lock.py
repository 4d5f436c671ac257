"""When a foot that stands on the edge of a step goes along with its motion."""

from __future__ import annotations

import numpy as np
from foot_at_step import EDGE, FEET, HEIGHT, SOLE, legs_at, toes_up
from foot_kernels import stepped
from statwalk.solve.foot_lock import LIFTED
from statwalk.solve.foot_tables import (
    LOWEST,
    LOWEST_X,
    LOWEST_Y,
    LOWEST_Z,
    OF_FOOT,
    PIVOT,
    PIVOT_X,
    PIVOT_Z,
    PLANTED,
    SINCE,
    STANDING,
)

TOES_DOWN, OVER = -0.6, 0.008
"""radians; metres by which the foremost point of the foot is over the step"""
LEANING = SOLE @ [
    [1, 0, 0],
    [0, np.cos(TOES_DOWN), -np.sin(TOES_DOWN)],
    [0, np.sin(TOES_DOWN), np.cos(TOES_DOWN)],
]
TOES = np.flatnonzero(LEANING[:, 2] > LEANING[:, 2].max() - OVER)
TIP = int(TOES[LEANING[TOES, 1].argmin()])
"""the lowest point over the step"""


def planted(height: float) -> float:
    """PLANTED of a foot that stood on the tip of its toes on a step; its motion now brings the tip to
    `height` above the step, and goes forward at 0.6 m/s and a little up.
    """
    y, z = HEIGHT + height - LEANING[TIP, 1], EDGE + OVER - LEANING[:, 2].max()
    keep, (x, tip_y, tip_z) = np.zeros((1, OF_FOOT)), np.add(LEANING[TIP], (0, y, z))
    keep[0, [PLANTED, SINCE]] = STANDING, 1.0
    keep[0, [PIVOT, PIVOT_X, PIVOT_Z]] = TIP, x, tip_z
    keep[0, [LOWEST, LOWEST_X, LOWEST_Y, LOWEST_Z]] = TIP, x, tip_y - 0.001, tip_z - 0.01
    stepped(FEET, toes_up(legs_at(y, z), TOES_DOWN), keep)
    return float(keep[0, PLANTED])


def test_no_point_on_which_a_flat_sole_lies_is_over_the_step() -> None:
    assert LEANING[: FEET.lowest[0], 2].max() < LEANING[:, 2].max() - OVER


def test_a_foot_whose_motion_does_not_lift_its_toes_stays() -> None:
    assert planted(-0.01) == STANDING


def test_a_foot_whose_motion_lifts_its_toes_goes_along() -> None:
    assert planted(LIFTED + 0.002) == 0.0
