"""A foot in the air that comes against the side of a step is moved aside, out of the step, part of its fit
(`foot_fit`).

The way out is as long as the foot is deep in the step: it begins with nothing, and ends as the foot rises
above the step. Arguments as in `foot_fit`.
"""

from __future__ import annotations

from typing import Any

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.springs import settled
from statwalk.solve.foot_flight import HASTE
from statwalk.solve.foot_points import stage_point
from statwalk.solve.foot_tables import (
    ASIDE_X,
    ASIDE_X_RATE,
    ASIDE_Z,
    ASIDE_Z_RATE,
    LIFT,
    SHIFT_X,
    SHIFT_Z,
    TOOK,
    X,
    Y,
    Z,
)  # fmt: skip

STUMBLE, CLEARED = 0.015, 0.035
"""metres by which a point of the sole is below the top of a step: from STUMBLE on the step is in its way,
from CLEARED on wholly
"""
ROOM, DEEPEST = 0.008, 0.09
"""metres between the sole of a foot that is moved aside and the step: the ankle above is thicker; metres by
which a foot is moved aside at most
"""
COME_BACK = 25.0
"""1/s: how eagerly a foot that a step has kept aside comes back"""


@called
def way_out(f: Any, legs: Any, row: int, foot: int, root: Any, x: float, y: float, z: float) -> Any:
    """Returns x and z (metres) that bring the sole of an animated foot, shown `x`, `y`, `z` from where it is
    in `legs`, out of all level pieces of the ground that it is in.
    """
    left, right, back, front = 0.0, 0.0, 0.0, 0.0
    first = f.first_point[foot]
    for point in range(first, first + f.spread[foot]):
        px, py, pz = stage_point(f, legs, row, point, root)
        px, py, pz = px + x, py + y, pz + z
        for piece in range(f.ground.shape[0]):
            if f.ground[piece, 5] == 0.0 and f.ground[piece, 6] == 0.0:
                u, v = _out_of(f.ground, piece, px, py, pz)
                left, right, back, front = min(left, u), max(right, u), min(back, v), max(front, v)
    return left + right, back + front


@inlined
def _out_of(ground: Any, piece: int, x: float, y: float, z: float) -> Any:
    """The nearest way out of a level piece for a point below its top, through one of its sides."""
    low_x, low_z = ground[piece, 0] - ROOM - x, ground[piece, 1] - ROOM - z
    high_x, high_z = ground[piece, 2] + ROOM - x, ground[piece, 3] + ROOM - z
    below = ground[piece, 4] - y
    if low_x > 0.0 or low_z > 0.0 or high_x < 0.0 or high_z < 0.0 or below <= STUMBLE:
        return 0.0, 0.0
    share = min((below - STUMBLE) / (CLEARED - STUMBLE), 1.0)
    u = low_x if -low_x < high_x else high_x
    v = low_z if -low_z < high_z else high_z
    if abs(u) < abs(v):
        return min(max(u, -DEEPEST), DEEPEST) * share, 0.0
    return 0.0, min(max(v, -DEEPEST), DEEPEST) * share


@inlined
def without_haste(keep: Any, row: int, shift: int, rate: int, aside: int, old: float, dt: float) -> None:
    """Moves into `aside`, where it dies out, what a change of `shift` has of haste."""
    step, before, most = keep[row, shift] - old, keep[row, rate] * dt, HASTE * dt * dt
    made = min(max(step, before - most), before + most)
    keep[row, aside] += made - step
    keep[row, rate] = made / dt


@inlined
def go_aside(
    f: Any, legs: Any, keep: Any, row: int, foot: int, lock: int, at: int, root: Any, left: float, dt: float
) -> None:  # fmt: skip
    """Keeps a foot on its way out of the steps that it would be in; where there are none it comes back."""
    old_x, old_z = keep[row, at + ASIDE_X], keep[row, at + ASIDE_Z]
    aside_x, rate_x = settled(old_x, keep[row, at + ASIDE_X_RATE], COME_BACK, dt)
    aside_z, rate_z = settled(old_z, keep[row, at + ASIDE_Z_RATE], COME_BACK, dt)
    x = keep[row, at + SHIFT_X] - left * keep[row, at + TOOK + SHIFT_X] + keep[row, lock + X] + aside_x
    z = keep[row, at + SHIFT_Z] - left * keep[row, at + TOOK + SHIFT_Z] + keep[row, lock + Z] + aside_z
    y = keep[row, at + LIFT] - left * keep[row, at + TOOK + LIFT] + keep[row, lock + Y]
    u, v = way_out(f, legs, row, foot, root, x, y, z)
    if u != 0.0 or v != 0.0:
        aside_x, aside_z = aside_x + u, aside_z + v
        rate_x, rate_z = (aside_x - old_x) / dt, (aside_z - old_z) / dt
    keep[row, at + ASIDE_X], keep[row, at + ASIDE_X_RATE] = aside_x, rate_x
    keep[row, at + ASIDE_Z], keep[row, at + ASIDE_Z_RATE] = aside_z, rate_z
