"""The feet of terrain at a step of a height of their own, not turned, wherever a test puts them."""

from __future__ import annotations

import numpy as np
from paths import MACHINES
from statwalk.services.library.load import load_role
from statwalk.solve.foot_tables import FootTables

LEGS = load_role(MACHINES / "terrain").solvers.legs
EDGE, HEIGHT = 1.0, 0.12
"""metres: a step from z = 1 on"""


def _locked(array: np.ndarray) -> np.ndarray:
    array.flags.writeable = False
    return array


FEET: FootTables = LEGS._replace(ground=_locked(np.array([[-1.0, EDGE, 1.0, 3.0, HEIGHT, 0.0, 0.0]])))
SOLE = np.array(FEET.point[: FEET.first_point[1]])
FRONT, FRONT_BESIDE = SOLE[:, 2].max(), SOLE[: FEET.spread[0], 2].max()
"""z of the foremost point of a sole; z of the foremost point that `way_out` looks at"""


def legs_at(y: float, z: float) -> np.ndarray:
    """The matrices of legs whose feet are not turned and are at 0, y, z."""
    legs = np.zeros((1, len(FEET.joints), 12, 16), np.float32)
    legs[:, :, [0, 5, 10]] = 1.0
    legs[:, :, 7], legs[:, :, 11] = y, z
    return _locked(legs)


def toes_up(legs: np.ndarray, angle: float) -> np.ndarray:
    """The same legs, their feet turned by an angle (radians) about the joint that carries them."""
    turned = legs.copy()
    turned[:, :, [5, 10]] = np.cos(angle)
    turned[:, :, 6], turned[:, :, 9] = np.sin(angle), -np.sin(angle)
    return _locked(turned)


LOWEST = SOLE[:, 1].min()
ON_THE_FLOOR = -LOWEST
