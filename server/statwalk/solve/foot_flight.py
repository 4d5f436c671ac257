"""A foot on its way through the air over uneven ground, part of its fit (`foot_fit`).

It goes along the string of its path (`foot_path`) as evenly as its motion goes over a floor: where the string
rises at once, the foot rises before it goes on.

`f`, `legs`, `root`, `keep`, `row`, `at` as in `foot_fit`; x and z the middle of the sole on the stage.
"""

from __future__ import annotations

import math
from typing import Any

from statwalk.maths.compiling import inlined
from statwalk.maths.scalar import sincos
from statwalk.solve.foot_path import along_path, choose_landing, stretch_path
from statwalk.solve.foot_tables import (
    AIM_X,
    AIM_Z,
    AT_X,
    AT_Z,
    BENT,
    CLIMB,
    FLIES,
    FROM_X,
    FROM_Z,
    HEIGHT,
    OLD_X,
    OLD_Z,
    PATH,
    PATH_PARTS,
    PLAN,
    PROGRESS,
    SEARCHES,
    SHIFT_X,
    SHIFT_X_RATE,
    SHIFT_Z,
    SHIFT_Z_RATE,
    SHIFTED,
    SLIP,
    TO_X,
    TO_Z,
)  # fmt: skip
from statwalk.solve.footing import MARGIN, height_over, slope_under

LAND_EARLY_S, SOONEST_S, LATE_S = 0.05, 0.05, 0.1
"""seconds before it lands in which a foot is above the place where it lands; seconds that it takes to come
there at least, and if it should stand already
"""
CHANGED, IN_TIME_S = 0.03, 0.12
"""metres by which a motion must land elsewhere than it did, for a foot to take another way; seconds before it
lands after which it looks for no other tread
"""
FASTEST_FALL, SLOWEST_FALL, BRAKES = 2.5, 0.4, 20.0
"""m/s at which a foot on its way is lowered at most; the same where it lands; and how much faster for each
metre above that (1/s)
"""
HASTE = 50.0
"""m/s² with which a foot on its way changes its pace at most; what is missing dies out"""
GENTLE, GENTLEST = 3.0, 0.3
"""a foot rises with BENT times GENTLE of HASTE, with GENTLEST of HASTE at least"""
SHORT_WAY, LONG_WAY = 0.45, 0.7
"""metres: a foot on a way up to SHORT_WAY rises gently, a foot on a way from LONG_WAY on rises with HASTE"""
AHEAD_S = 0.15
"""seconds: a foot whose motion does not say where it lands looks so far ahead"""
FORGET = 4.0
"""1/s: how fast a foot without a known landing comes back to the place of its motion"""
IN_PLACE = 0.0064
"""metres²: a way that is shorter is none"""


@inlined
def go_over(keep: Any, row: int, at: int, height: float) -> None:
    """Wants another height (units) from now on: the difference dies out."""
    keep[row, at + SLIP] += keep[row, at + HEIGHT] - height
    keep[row, at + HEIGHT] = height


@inlined
def is_new(keep: Any, row: int, at: int, to_x: float, to_z: float) -> Any:
    """Returns whether a foot sets off, or its motion lands elsewhere than it did."""
    u, v = to_x - keep[row, at + AIM_X], to_z - keep[row, at + AIM_Z]
    return keep[row, at + PLAN] != FLIES or u * u + v * v > CHANGED * CHANGED


@inlined
def set_off(
    f: Any, keep: Any, row: int, foot: int, at: int, to_x: float, to_z: float, yaw: float, seconds: float
) -> None:  # fmt: skip
    """Plans a foot's way through the air from where it is; one that lands in a moment looks for no other
    tread.
    """
    chooses = keep[row, at + PLAN] != FLIES or seconds > IN_TIME_S
    keep[row, at + TO_X] += to_x - keep[row, at + AIM_X]
    keep[row, at + TO_Z] += to_z - keep[row, at + AIM_Z]
    keep[row, at + AIM_X], keep[row, at + AIM_Z] = to_x, to_z
    if keep[row, at + PLAN] != FLIES:
        keep[row, at + CLIMB] = keep[row, at + SHIFT_X_RATE] = keep[row, at + SHIFT_Z_RATE] = 0.0
    keep[row, at + PLAN], keep[row, at + SHIFTED], keep[row, at + PROGRESS] = FLIES, 0.0, 0.0
    keep[row, at + FROM_X], keep[row, at + FROM_Z] = keep[row, at + AT_X], keep[row, at + AT_Z]
    keep[row, at + OLD_X], keep[row, at + OLD_Z] = keep[row, at + SHIFT_X], keep[row, at + SHIFT_Z]
    if chooses:
        sine, cosine = sincos(yaw)
        choose_landing(f, keep, row, foot, at, to_x, to_z, sine, cosine)
    stretch_path(f, keep, row, foot, at, yaw)


@inlined
def fly(keep: Any, row: int, at: int, x: float, z: float, seconds: float, dt: float) -> None:
    """Moves a foot on its way to where it lands; its motion lands in `seconds`."""
    until = max(seconds - LAND_EARLY_S, SOONEST_S) if seconds >= 0.0 else LATE_S
    keep[row, at + SHIFTED] += (1.0 - keep[row, at + SHIFTED]) * min(dt / until, 1.0)
    gone = keep[row, at + SHIFTED]
    part = gone * gone * (3.0 - 2.0 * gone)
    x, z = x - keep[row, at + SHIFT_X], z - keep[row, at + SHIFT_Z]
    u, v = keep[row, at + TO_X] - keep[row, at + AIM_X], keep[row, at + TO_Z] - keep[row, at + AIM_Z]
    shift_x = keep[row, at + OLD_X] + (u - keep[row, at + OLD_X]) * part
    shift_z = keep[row, at + OLD_Z] + (v - keep[row, at + OLD_Z]) * part
    from_x, from_z = keep[row, at + FROM_X], keep[row, at + FROM_Z]
    u, v = keep[row, at + TO_X] - from_x, keep[row, at + TO_Z] - from_z
    square = u * u + v * v
    gone = ((x + shift_x - from_x) * u + (z + shift_z - from_z) * v) / square if square > IN_PLACE else part
    gone = max(keep[row, at + PROGRESS], min(max(gone, 0.0), 1.0))
    share, height = along_path(keep, row, at, gone, math.sqrt(square))
    above = keep[row, at + HEIGHT] - keep[row, at + PATH + PATH_PARTS]
    fall = min(FASTEST_FALL, SLOWEST_FALL + BRAKES * max(above, 0.0))
    height = max(height, keep[row, at + HEIGHT] - fall * dt)
    keep[row, at + PROGRESS] = gone
    _climb(keep, row, at, height, math.sqrt(square), dt)
    keep[row, at + SHIFT_X] = shift_x + (share - gone) * u
    keep[row, at + SHIFT_Z] = shift_z + (share - gone) * v


@inlined
def _climb(keep: Any, row: int, at: int, height: float, way: float, dt: float) -> None:
    """Wants the height of the path, without haste: the knee of a leg that is nearly straight moves much
    farther than its foot rises.
    """
    step, before = height - keep[row, at + HEIGHT], keep[row, at + CLIMB] * dt
    most = HASTE * dt * dt
    hurry = (way - SHORT_WAY) / (LONG_WAY - SHORT_WAY)
    rise = min(max(GENTLE * keep[row, at + BENT], GENTLEST, hurry), 1.0) * most
    made = min(max(step, before - most), before + rise)
    keep[row, at + SLIP] += made - step
    keep[row, at + HEIGHT], keep[row, at + CLIMB] = height, made / dt


@inlined
def look_ahead(
    f: Any, keep: Any, row: int, foot: int, at: int, x: float, z: float, yaw: float, dt: float
) -> None:
    """Moves a foot whose motion does not say where it lands: it is above all ground that is near ahead."""
    u, v = (x - keep[row, at + AT_X]) / dt * AHEAD_S, (z - keep[row, at + AT_Z]) / dt * AHEAD_S
    sine, cosine = sincos(yaw)
    height = 0.0
    for step in range(3):
        px, pz = x + 0.5 * step * u, z + 0.5 * step * v
        slope_x, slope_z = slope_under(f, foot, px, pz, sine, cosine)
        over = height_over(f, foot, px, pz, sine, cosine, slope_x, slope_z, MARGIN, MARGIN, MARGIN)
        height = max(height, over)
    go_over(keep, row, at, height)
    keep[row, at + PLAN] = SEARCHES
    part = max(1.0 - FORGET * dt, 0.0)
    keep[row, at + SHIFT_X] *= part
    keep[row, at + SHIFT_Z] *= part
