"""The path of a foot through the air over uneven ground: where it lands, and how high it must be on its way.

The path is a string, stretched from where the foot stood to where it will stand over all ground between; the
motion's own height of the foot comes on top of it. `f`, `keep`, `row` as in `foot_lock`; `at` the column of
the foot's first number for uneven ground (`foot_tables`).
"""

from __future__ import annotations

import math
from typing import Any

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.scalar import sincos
from statwalk.solve.foot_tables import (
    FROM_X,
    FROM_Z,
    HEIGHT,
    PATH,
    PATH_PARTS,
    TO_X,
    TO_Z,
)
from statwalk.solve.footing import MARGIN, height_over, height_under, points_supported, slope_under

FARTHEST, STRIDE = 0.13, 0.02
"""metres by which a foot lands before or behind the place of its motion at most, to stand on one tread; in
which steps a place is looked for
"""
COST, COST_BACK = 18.0, 27.0
"""points of a sole that a metre before, or behind the place of the motion must win"""
TOE_CAP = 0.02
"""metres by which toes are longer than the points of the sole"""
AIR, EVEN = 0.015, 0.03
"""metres by which a foot is higher than the string in the middle of its path; if heights along it differ by
more
"""
ROUNDED = 0.075
"""the share of a path over which its corners are rounded"""
UPWARD, DOWNWARD = 1.5, 0.4
"""metres of a level way that take as long as a metre up, or down"""
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
def stretch_path(f: Any, keep: Any, row: int, foot: int, at: int, yaw: float) -> None:
    """Writes the heights of the string from where the foot is to where it lands."""
    sine, cosine = sincos(yaw)
    x, z = keep[row, at + FROM_X], keep[row, at + FROM_Z]
    u, v = keep[row, at + TO_X] - x, keep[row, at + TO_Z] - z
    along, across = abs(u * sine + v * cosine), abs(u * cosine - v * sine)
    keep[row, at + PATH] = keep[row, at + HEIGHT]
    for part in range(1, PATH_PARTS):
        share = _share_of(part)
        half = 0.5 * max(share - _share_of(part - 1), _share_of(part + 1) - share)
        behind, wider = half * along + MARGIN, half * across + MARGIN
        px, pz = x + share * u, z + share * v
        slope_x, slope_z = slope_under(f, foot, px, pz, sine, cosine)
        height = height_over(f, foot, px, pz, sine, cosine, slope_x, slope_z, behind + TOE_CAP, behind, wider)
        keep[row, at + PATH + part] = height
    slope_x, slope_z = slope_under(f, foot, x + u, z + v, sine, cosine)
    height = height_under(f, foot, x + u, z + v, sine, cosine, slope_x, slope_z)
    keep[row, at + PATH + PATH_PARTS] = height
    _stretch(keep, row, at)


@inlined
def _share_of(part: int) -> Any:
    """The share of the way at which a height is kept: close together where the foot rises and comes down."""
    share = min(part / PATH_PARTS, 1.0)
    return share * share * (3.0 - 2.0 * share)


@inlined
def _stretch(keep: Any, row: int, at: int) -> None:
    """Raises each height to the lines between heights before and behind it."""
    for part in range(1, PATH_PARTS):
        place, height = _share_of(part), keep[row, at + PATH + part]
        for first in range(part):
            for last in range(part + 1, PATH_PARTS + 1):
                start, end = keep[row, at + PATH + first], keep[row, at + PATH + last]
                gone = (place - _share_of(first)) / (_share_of(last) - _share_of(first))
                height = max(height, start + (end - start) * gone)
        keep[row, at + PATH + part] = height


@called
def along_path(keep: Any, row: int, at: int, progress: float, size: float) -> Any:
    """Returns the share of the way and the height at a share 0…1 of the string, its corners rounded; `size`:
    metres from where the foot was to where it lands.
    """
    near = min(ROUNDED, progress, 1.0 - progress)
    share, height = _on_string(keep, row, at, progress, size)
    share_before, height_before = _on_string(keep, row, at, progress - near, size)
    share_after, height_after = _on_string(keep, row, at, progress + near, size)
    least, most = keep[row, at + PATH], keep[row, at + PATH]
    for part in range(1, PATH_PARTS + 1):
        least, most = min(least, keep[row, at + PATH + part]), max(most, keep[row, at + PATH + part])
    air = 4.0 * AIR * progress * (1.0 - progress) if most - least > EVEN else 0.0
    share = 0.5 * share + 0.25 * (share_before + share_after)
    return share, 0.5 * height + 0.25 * (height_before + height_after) + air


@called
def _on_string(keep: Any, row: int, at: int, progress: float, size: float) -> Any:
    """The share of the way and the height at a share of the string's length."""
    total = 0.0
    for part in range(PATH_PARTS):
        total += _length(keep, row, at, part, size)
    left = progress * total
    for part in range(PATH_PARTS):
        length = _length(keep, row, at, part, size)
        if left <= length or part == PATH_PARTS - 1:
            gone = min(left / max(length, 1e-9), 1.0)
            start, end = keep[row, at + PATH + part], keep[row, at + PATH + part + 1]
            share = _share_of(part)
            return share + (_share_of(part + 1) - share) * gone, start + (end - start) * gone
        left -= length
    return 1.0, keep[row, at + PATH + PATH_PARTS]


@inlined
def _length(keep: Any, row: int, at: int, part: int, size: float) -> Any:
    """Metres of a level way that take as long as a part of the string."""
    rise = keep[row, at + PATH + part + 1] - keep[row, at + PATH + part]
    rise *= UPWARD if rise > 0.0 else DOWNWARD
    way = (_share_of(part + 1) - _share_of(part)) * size
    return math.sqrt(way * way + rise * rise)
