"""The way of a released foot back to its motion: the difference dies out as a critically damped spring.

`keep`, `row`, `at` as in `foot_lock`.
"""

from __future__ import annotations

import math
from typing import Any

from statwalk.maths.compiling import inlined
from statwalk.maths.springs import settled
from statwalk.solve.foot_tables import EAGER, TURN, TURN_RATE, X_RATE, Z_RATE, X, Z

HARDEST, MOST_EAGER = 16.0, 24.0
"""m/s² with which a released foot sets off to its motion at most, if that is as fast as a walk; 1/s"""
WALKING = 3.5
"""m/s: a foot whose motion is n times as fast sets off up to n² times as hard, as it does in its motion"""


@inlined
def take_rates(keep: Any, row: int, at: int, old: Any, dt: float) -> None:
    """Notes how fast a foot moves relative to its motion; `old`: its X, Z and TURN a tick before."""
    keep[row, at + X_RATE] = (keep[row, at + X] - old[0]) / dt
    keep[row, at + Z_RATE] = (keep[row, at + Z] - old[1]) / dt
    keep[row, at + TURN_RATE] = (keep[row, at + TURN] - old[2]) / dt


@inlined
def eagerness(keep: Any, row: int, at: int, speed: float) -> Any:
    """Returns 1/s: as much as HARDEST allows for a foot so far from its motion that falls back so fast;
    `speed`: of its motion (m/s).
    """
    faster = max(speed / WALKING, 1.0)
    hardest = HARDEST * faster * faster
    x, z, u, w = keep[row, at + X], keep[row, at + Z], keep[row, at + X_RATE], keep[row, at + Z_RATE]
    away, rate = math.sqrt(x * x + z * z), math.sqrt(u * u + w * w)
    root = math.sqrt(rate * rate + away * hardest)  # of hardest = eager² · away + 2 · eager · rate
    return min(MOST_EAGER, hardest / max(rate + root, 1e-6))


@inlined
def approach(keep: Any, row: int, at: int, old: Any, speed: float, dt: float) -> None:
    """Lets the difference of a foot from its motion die out, faster as it falls back less."""
    eager = max(keep[row, at + EAGER], eagerness(keep, row, at, speed))
    keep[row, at + EAGER] = eager
    keep[row, at + X], keep[row, at + X_RATE] = settled(old[0], keep[row, at + X_RATE], eager, dt)
    keep[row, at + Z], keep[row, at + Z_RATE] = settled(old[1], keep[row, at + Z_RATE], eager, dt)
    keep[row, at + TURN], keep[row, at + TURN_RATE] = settled(old[2], keep[row, at + TURN_RATE], eager, dt)
