"""Points of an actor's feet on the stage, from the model matrices of its legs.

`f` FootTables; `legs` the model matrices of `f.joints`; `root` x, y, z of the actor, sine and cosine of its
heading. All places on the stage are in units of `f.unit`: every character has about the walker's size in it.
"""

from __future__ import annotations

import math
from typing import Any

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.scalar import atan2, sincos
from statwalk.maths.simd.pose_layout import place_of
from statwalk.solve.foot_tables import LOWEST, LOWEST_X, LOWEST_Y, LOWEST_Z, SINCE, TURN, X, Z
from statwalk.solve.ground import ground_at

TWIST_LENGTH = 0.2
"""metres that count as one radian, where two feet are compared"""
FASTEST_FALL = 1.5
"""m/s"""


@inlined
def stage_point(f: Any, legs: Any, row: int, point: int, root: Any) -> Any:
    """Returns x, y, z on the stage of an animated point of the sole."""
    block, lane = place_of(row)
    place = f.carrier[point]
    x, y, z = f.point[point, 0], f.point[point, 1], f.point[point, 2]
    a = legs[block, place, 0, lane] * x + legs[block, place, 1, lane] * y + legs[block, place, 2, lane] * z
    b = legs[block, place, 4, lane] * x + legs[block, place, 5, lane] * y + legs[block, place, 6, lane] * z
    c = legs[block, place, 8, lane] * x + legs[block, place, 9, lane] * y + legs[block, place, 10, lane] * z
    a, b = a + legs[block, place, 3, lane], b + legs[block, place, 7, lane]
    return in_units(f, a, b, c + legs[block, place, 11, lane], root)


@inlined
def in_units(f: Any, x: float, y: float, z: float, root: Any) -> Any:
    """Returns a point of model space (metres) on the stage."""
    per_metre = 1.0 / f.unit[0]
    return on_stage(x * per_metre, y * per_metre, z * per_metre, root)


@inlined
def on_stage(x: float, y: float, z: float, root: Any) -> Any:
    """Returns a point of model space on the stage, all in the same unit."""
    return x * root[4] + z * root[3] + root[0], y + root[1], z * root[4] - x * root[3] + root[2]


@inlined
def lowest_point(f: Any, legs: Any, row: int, foot: int, root: Any, away_x: float, away_z: float) -> Any:
    """Returns the animated point of a sole that is nearest to the ground below it, and its x, y, z; the foot
    is shown `away_x` and `away_z` metres from its motion.
    """
    best = f.first_point[foot]
    if f.ground.shape[0] == 0:
        least = _height(f, legs, row, best)
        for point in range(best + 1, best + f.lowest[foot]):
            height = _height(f, legs, row, point)
            if height < least:
                best, least = point, height
        bx, by, bz = stage_point(f, legs, row, best, root)
        return best, bx, by, bz
    bx, by, bz = stage_point(f, legs, row, best, root)
    least = by - ground_at(f.ground, bx + away_x, bz + away_z, root[1])
    for point in range(best + 1, best + f.lowest[foot]):
        x, y, z = stage_point(f, legs, row, point, root)
        height = y - ground_at(f.ground, x + away_x, z + away_z, root[1])
        if height < least:
            best, bx, by, bz, least = point, x, y, z, height
    return best, bx, by, bz


@called
def flat_place(f: Any, legs: Any, row: int, foot: int, root: Any, sine: float, cosine: float) -> Any:
    """Returns x, z on the stage where the middle of a sole will lie that rolls flat over its lowest animated
    point; `sine` and `cosine` of the foot's yaw.
    """
    best = f.first_point[foot]
    least = _height(f, legs, row, best)
    for point in range(best + 1, best + f.lowest[foot]):
        height = _height(f, legs, row, point)
        if height < least:
            best, least = point, height
    x, _, z = stage_point(f, legs, row, best, root)
    return from_point(f, best, x, z, sine, cosine)


@inlined
def from_point(f: Any, point: int, x: float, z: float, sine: float, cosine: float) -> Any:
    """Returns x, z of the middle of a flat sole, one point of which is at `x`, `z`."""
    along, across = f.on_print[point, 0], f.on_print[point, 1]
    return x - along * sine - across * cosine, z - along * cosine + across * sine


@inlined
def _height(f: Any, legs: Any, row: int, point: int) -> Any:
    """The y of an animated point of the sole in model space."""
    block, lane = place_of(row)
    place = f.carrier[point]
    x, y, z = f.point[point, 0], f.point[point, 1], f.point[point, 2]
    b = legs[block, place, 4, lane] * x + legs[block, place, 5, lane] * y + legs[block, place, 6, lane] * z
    return b + legs[block, place, 7, lane]


@inlined
def speeds_of(f: Any, legs: Any, keep: Any, row: int, at: int, low: Any, root: Any, dt: float) -> Any:
    """Returns the speed over the ground (m/s) of the point that was the lowest in the tick before, and how
    fast it comes down (m/s), and by how much it has (metres); notes the lowest point `low` and where it is.
    """
    speed, fall, sank = 0.0, 0.0, 0.0
    if keep[row, at + SINCE] >= 0.0:
        x, y, z = stage_point(f, legs, row, int(keep[row, at + LOWEST]), root)
        x, z = x - keep[row, at + LOWEST_X], z - keep[row, at + LOWEST_Z]
        speed = math.sqrt(x * x + z * z) / dt
        sank = keep[row, at + LOWEST_Y] - y
        fall = max((keep[row, at + LOWEST_Y] - max(y, low[2])) / dt, 0.0)
    keep[row, at + LOWEST], keep[row, at + LOWEST_X] = low[0], low[1]
    keep[row, at + LOWEST_Y], keep[row, at + LOWEST_Z] = low[2], low[3]
    return speed, min(fall, FASTEST_FALL), sank


@inlined
def ankle_of(f: Any, legs: Any, row: int, foot: int, root: Any) -> Any:
    """Returns x, y, z on the stage and the yaw of an animated ankle."""
    block, lane = place_of(row)
    place, a = f.ankle[foot], f.left[foot]
    # x, z: where the foot points, a quarter of a turn from its left
    z = legs[block, place, 0, lane] * a[0] + legs[block, place, 1, lane] * a[1]
    z += legs[block, place, 2, lane] * a[2]
    x = -legs[block, place, 8, lane] * a[0] - legs[block, place, 9, lane] * a[1]
    x -= legs[block, place, 10, lane] * a[2]
    yaw = atan2(x * root[4] + z * root[3], z * root[4] - x * root[3])
    px, py, pz = in_units(
        f, legs[block, place, 3, lane], legs[block, place, 7, lane], legs[block, place, 11, lane], root
    )
    return px, py, pz, yaw


@inlined
def hip_of(f: Any, legs: Any, row: int, foot: int, root: Any) -> Any:
    """Returns x, y, z on the stage of an animated hip."""
    block, lane = place_of(row)
    place = f.hip[foot]
    x, y, z = legs[block, place, 3, lane], legs[block, place, 7, lane], legs[block, place, 11, lane]
    return in_units(f, x, y, z, root)


@inlined
def shown_point(point: Any, ankle: Any, turn: float, x: float, z: float) -> Any:
    """Returns x, z of a point of the foot, turned about its ankle by `turn` and moved by x and z."""
    sine, cosine = sincos(turn)
    a, c = point[0] - ankle[0], point[2] - ankle[2]
    return a * cosine + c * sine + ankle[0] + x, c * cosine - a * sine + ankle[2] + z


@inlined
def size_of(keep: Any, row: int, at: int) -> Any:
    """Returns how far a shown foot is from its motion: metres, its turn counted as well."""
    x, z = keep[row, at + X], keep[row, at + Z]
    return math.sqrt(x * x + z * z) + TWIST_LENGTH * abs(keep[row, at + TURN])
