"""The path of a foot through the air over uneven ground: where it lands, and how high it must be on its way.

The path is a string, stretched from where the foot stood to where it will stand over all ground between; the
motion's own height of the foot comes on top of it. `f`, `keep`, `row` as in `foot_lock`; `at` the column of
the foot's first number for uneven ground (`foot_tables`).
"""

from __future__ import annotations

from typing import Any

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.scalar import sincos
from statwalk.solve.foot_tables import (
    FROM_X,
    FROM_Z,
    HALF_LENGTH,
    HEIGHT,
    PATH,
    PATH_PARTS,
    TO_X,
    TO_Z,
)
from statwalk.solve.footing import MARGIN, height_over, points_supported, slope_under

FARTHEST, STRIDE = 0.13, 0.02
"""metres by which a foot lands before or behind the place of its motion at most, to stand on one tread; in
which steps a place is looked for
"""
COST, COST_BACK = 18.0, 27.0
"""points of a sole that a metre before, or behind the place of the motion must win"""
SHORT_PART = 0.5
"""the share of a path in which a foot that hangs down becomes as long as one that lies"""
TOE_CAP = 0.02
"""metres by which toes are longer than the points of the sole"""
AIR, EVEN = 0.015, 0.03
"""metres by which a foot is higher than the string in the middle of its path; if heights along it differ by
more
"""
ROUNDED = 0.12
"""the share of a path over which its corners are rounded"""
EVERY_POINT = 15


@called
def choose_landing(
    f: Any, keep: Any, row: int, foot: int, at: int, x: float, z: float, sine: float, cosine: float
) -> None:
    """Writes where a foot lands: as near as possible to the place of its motion (x, z), with as much ground
    below the sole as possible.
    """
    best = points_supported(f, foot, x, z, sine, cosine) + 0.0
    found = 0.0
    if best < EVERY_POINT:
        away = STRIDE
        while away < FARTHEST:
            for side in range(2):
                shift = away if side == 0 else -away
                worth = points_supported(f, foot, x + shift * sine, z + shift * cosine, sine, cosine)
                cost = (COST if side == 0 else COST_BACK) * away
                if worth - cost > best:
                    best, found = worth - cost, shift
            away += STRIDE
    keep[row, at + TO_X], keep[row, at + TO_Z] = x + found * sine, z + found * cosine


@called
def stretch_path(f: Any, keep: Any, row: int, foot: int, at: int, yaw: float, front: float) -> None:
    """Writes the heights of the ground along the path from where the foot is; `front`: metres from the middle
    of the sole to its foremost point now.
    """
    sine, cosine = sincos(yaw)
    x, z = keep[row, at + FROM_X], keep[row, at + FROM_Z]
    u, v = (keep[row, at + TO_X] - x) / PATH_PARTS, (keep[row, at + TO_Z] - z) / PATH_PARTS
    along, wider = 0.5 * abs(u * sine + v * cosine) + MARGIN, 0.5 * abs(u * cosine - v * sine) + MARGIN
    shorter = min(front - f.print[foot, HALF_LENGTH], 0.0)
    keep[row, at + PATH] = keep[row, at + HEIGHT]
    for part in range(1, PATH_PARTS + 1):
        hangs = max(1.0 - part / (SHORT_PART * PATH_PARTS), 0.0)
        hangs = hangs * (2.0 - hangs)
        before, behind = along + shorter * hangs + TOE_CAP, along
        if part == PATH_PARTS:
            before, behind, wider = 0.0, 0.0, 0.0
        px, pz = x + part * u, z + part * v
        slope_x, slope_z = slope_under(f, foot, px, pz, sine, cosine)
        height = height_over(f, foot, px, pz, sine, cosine, slope_x, slope_z, before, behind, wider)
        keep[row, at + PATH + part] = height


@inlined
def first_rise(keep: Any, row: int, at: int) -> Any:
    """Returns how much (metres) the first third of a path rises."""
    rise = 0.0
    for part in range(1, PATH_PARTS // 3 + 1):
        rise = max(rise, keep[row, at + PATH + part] - keep[row, at + PATH])
    return rise


@called
def path_height(keep: Any, row: int, at: int, progress: float) -> Any:
    """Returns the height of the stretched string at a share 0…1 of the path, its corners rounded."""
    near = min(ROUNDED, progress, 1.0 - progress)
    sides = _string(keep, row, at, progress - near) + _string(keep, row, at, progress + near)
    least, most = keep[row, at + PATH], keep[row, at + PATH]
    for part in range(1, PATH_PARTS + 1):
        least, most = min(least, keep[row, at + PATH + part]), max(most, keep[row, at + PATH + part])
    air = 4.0 * AIR * progress * (1.0 - progress) if most - least > EVEN else 0.0
    return 0.5 * _string(keep, row, at, progress) + 0.25 * sides + air


@inlined
def _string(keep: Any, row: int, at: int, progress: float) -> Any:
    place = progress * PATH_PARTS
    height = -1e9
    for first in range(PATH_PARTS):
        for last in range(first + 1, PATH_PARTS + 1):
            if first <= place <= last:
                part = (place - first) / (last - first)
                start, end = keep[row, at + PATH + first], keep[row, at + PATH + last]
                height = max(height, start + (end - start) * part)
    return height
