"""A foot on its way through the air over uneven ground, part of its fit (`foot_fit`).

`f`, `legs`, `root`, `keep`, `row`, `at` as in `foot_fit`; x and z the middle of the sole on the stage.
"""

from __future__ import annotations

import math
from typing import Any

from statwalk.maths.compiling import inlined
from statwalk.maths.scalar import sincos
from statwalk.solve.foot_path import choose_landing, first_rise, path_height, stretch_path
from statwalk.solve.foot_points import stage_point
from statwalk.solve.foot_tables import (
    AT_X,
    AT_Z,
    FLIES,
    FROM_X,
    FROM_Z,
    HEIGHT,
    OLD_X,
    OLD_Z,
    PLAN,
    PROGRESS,
    SEARCHES,
    SHIFT_X,
    SHIFT_Z,
    SHIFTED,
    SLIP,
    TO_X,
    TO_Z,
)  # fmt: skip
from statwalk.solve.footing import MARGIN, height_over, slope_under

LAND_EARLY_S, LATE_S = 0.05, 0.1
"""seconds before it lands in which a foot is above the place where it lands; seconds in which a foot comes
there that should stand already
"""
CHANGED = 0.2
"""metres by which a motion must land elsewhere than it did, for a foot to look for another place"""
AHEAD_S = 0.15
"""seconds: a foot whose motion does not say where it lands looks so far ahead"""
FORGET = 4.0
"""1/s: how fast a foot without a known landing comes back to the place of its motion"""
LAG_SHARE, MOST_LAG, LAG_CURVE = 0.6, 0.12, 6.75
"""metres by which a foot that must rise at once lags behind its motion, for each metre, and at most; what
makes the highest value of share · (1 - share)² one
"""
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
    u, v = to_x - keep[row, at + TO_X], to_z - keep[row, at + TO_Z]
    return keep[row, at + PLAN] != FLIES or u * u + v * v > CHANGED * CHANGED


@inlined
def foremost(
    f: Any, legs: Any, row: int, foot: int, root: Any, x: float, z: float, sine: float, cosine: float
) -> Any:
    """Returns how far (units) the foremost point of an animated foot is from below the middle of its sole."""
    front = -1e9
    for point in range(f.first_point[foot], f.first_point[foot + 1]):
        px, _, pz = stage_point(f, legs, row, point, root)
        front = max(front, (px - x) * sine + (pz - z) * cosine)
    return front


@inlined
def set_off(
    f: Any, keep: Any, row: int, foot: int, at: int, x: float, z: float, to_x: float, to_z: float, yaw: float,
    front: float,
) -> None:  # fmt: skip
    """Plans a foot's way through the air."""
    keep[row, at + PLAN], keep[row, at + SHIFTED], keep[row, at + PROGRESS] = FLIES, 0.0, 0.0
    keep[row, at + FROM_X], keep[row, at + FROM_Z] = x, z
    keep[row, at + OLD_X], keep[row, at + OLD_Z] = keep[row, at + SHIFT_X], keep[row, at + SHIFT_Z]
    sine, cosine = sincos(yaw)
    choose_landing(f, keep, row, foot, at, to_x, to_z, sine, cosine)
    stretch_path(f, keep, row, foot, at, yaw, front)


@inlined
def fly(
    keep: Any, row: int, at: int, x: float, z: float, to_x: float, to_z: float, seconds: float, dt: float
) -> None:
    """Moves a foot on its way to where it lands; its motion lands in `seconds` at `to_x`, `to_z`."""
    until = max(seconds - LAND_EARLY_S, dt) if seconds >= 0.0 else LATE_S
    keep[row, at + SHIFTED] += (1.0 - keep[row, at + SHIFTED]) * min(dt / until, 1.0)
    gone = keep[row, at + SHIFTED]
    part, lag = gone * gone * (3.0 - 2.0 * gone), LAG_CURVE * gone * (1.0 - gone) * (1.0 - gone)
    u, v = keep[row, at + TO_X] - to_x, keep[row, at + TO_Z] - to_z
    keep[row, at + SHIFT_X] = keep[row, at + OLD_X] + (u - keep[row, at + OLD_X]) * part
    keep[row, at + SHIFT_Z] = keep[row, at + OLD_Z] + (v - keep[row, at + OLD_Z]) * part
    from_x, from_z = keep[row, at + FROM_X], keep[row, at + FROM_Z]
    u, v = keep[row, at + TO_X] - from_x, keep[row, at + TO_Z] - from_z
    square = u * u + v * v
    lag *= min(LAG_SHARE * first_rise(keep, row, at), MOST_LAG) / max(math.sqrt(square), 0.1)
    keep[row, at + SHIFT_X] -= lag * u
    keep[row, at + SHIFT_Z] -= lag * v
    gone = ((x - from_x) * u + (z - from_z) * v) / square if square > IN_PLACE else part
    keep[row, at + PROGRESS] = max(keep[row, at + PROGRESS], min(max(gone, 0.0), 1.0))
    keep[row, at + HEIGHT] = path_height(keep, row, at, keep[row, at + PROGRESS])


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
