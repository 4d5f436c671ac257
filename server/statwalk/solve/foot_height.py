"""How high a shown foot is above its animated one: never below the ground, clear of it on its way.

Arguments as in `foot_lock`; `low` its `lowest_point`.
"""

from __future__ import annotations

import math
from typing import Any

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.scalar import sincos
from statwalk.maths.springs import settled
from statwalk.solve.foot_flight import BRAKES, FASTEST_FALL, HASTE, SLOWEST_FALL
from statwalk.solve.foot_points import stage_point
from statwalk.solve.foot_tables import PLANTED, STANDING, TURN, Y_RATE, X, Y, Z
from statwalk.solve.ground import ground_at

CLEARANCE, PER_METRE, PER_SPEED = 0.06, 0.3, 0.03
"""metres by which a foot on its way is lifted at most; for each metre from its motion; for each m/s"""
LEAST_CLEARANCE, NEARLY_THERE = 0.009, 0.004
"""metres by which a foot on its way is lifted at least, until it is so near to its motion"""
RISE = 24.0
"""1/s: how eagerly a foot comes to its height"""
SOFT = 0.8
"""m/s at which a foot touches uneven ground in a blend at most"""
LOOK_AHEAD = 2.0 / RISE
"""seconds by which a foot comes later to its height, so that it looks so far ahead in a blend"""
KERB = 0.025
"""metres: where the ground is so much higher than a point of a foot, the point is at the side of a step, and
no foot stands there
"""
MANY, WAY_OUT = 3, 0.6
"""of so many points of a sole one must be in a step for the foot to be in it; m/s at which it then rises"""


@inlined
def floor_of(
    f: Any, legs: Any, keep: Any, row: int, foot: int, at: int, ankle: Any, low: Any, root: Any,
    shown: float, dt: float,
) -> Any:  # fmt: skip
    """Returns by how much (metres) a shown foot is at least above its animated one; `shown`: by how much
    the foot would be above it, had the foot not come down since the tick before.
    """
    floor = root[1] - low[2]
    if f.ground.shape[0] > 0:
        away = keep[row, at + X], keep[row, at + Z]
        floor, inside = _over_ground(f, legs, row, foot, root, ankle, keep[row, at + TURN], away, shown)
        if inside * MANY > f.first_point[foot + 1] - f.first_point[foot]:
            floor = max(floor, keep[row, at + Y] + WAY_OUT * dt)
    return floor


@called
def _over_ground(
    f: Any, legs: Any, row: int, foot: int, root: Any, ankle: Any, turn: float, away: Any, shown: float
) -> Any:  # fmt: skip
    """By how much a foot that is turned about its ankle and moved `away`, x and z, must be higher for its
    sole to be on uneven ground or above it, and how many of its points are in a step.
    """
    sine, cosine = sincos(turn)
    floor, inside = -1e9, 0
    for point in range(f.first_point[foot], f.first_point[foot + 1]):
        x, y, z = stage_point(f, legs, row, point, root)
        a, c = x - ankle[0], z - ankle[2]
        x, z = a * cosine + c * sine + ankle[0] + away[0], c * cosine - a * sine + ankle[2] + away[1]
        over = ground_at(f.ground, x, z, 0.0) - y - shown
        if over > KERB:  # the higher it is, the less it counts
            over = max(2.0 * KERB - over, 0.0)
            inside += 1 if over == 0.0 else 0
        floor = max(floor, shown + over)
    return floor, inside


@inlined
def raise_foot(
    keep: Any, row: int, at: int, floor: float, may_drag: bool, speed: float, ahead: float, lands: bool,
    dt: float,
) -> None:  # fmt: skip
    """Moves the height of the shown foot on: on the ground, `floor`, if it is planted, or lands; clear of it
    on its way, and of where it will be `ahead` metres lower.
    """
    x, z, old = keep[row, at + X], keep[row, at + Z], keep[row, at + Y]
    wanted = 0.0  # as high above the ground as in the motion: on uneven ground `foot_fit` has seen to it
    if keep[row, at + PLANTED] == STANDING or lands:
        wanted = floor
    elif may_drag or -floor < CLEARANCE:
        away = math.sqrt(x * x + z * z)
        clear = PER_METRE * away + (PER_SPEED * min(speed, 1.0) if may_drag else 0.0)
        if away > NEARLY_THERE or clear > LEAST_CLEARANCE:
            wanted = max(wanted, floor + ahead + min(max(clear, LEAST_CLEARANCE), CLEARANCE))
    height, rate = settled(old - wanted, keep[row, at + Y_RATE], RISE, dt)
    height += wanted
    if height < floor:
        height, rate = floor, (floor - old) / dt
    keep[row, at + Y], keep[row, at + Y_RATE] = height, rate


@inlined
def come_down_gently(
    keep: Any, row: int, at: int, old: float, rate: float, shown: float, floor: float, dt: float
) -> None:
    """Lets a foot that is lowered below its motion come down as slowly as one on its way (`foot_flight`).

    `old` and `rate`: its height before this tick, and how fast that changed; `shown`: the height at which it
    would be where it was shown then.
    """
    fall = min(FASTEST_FALL, SLOWEST_FALL + BRAKES * max(shown - floor, 0.0))
    least = max(shown - fall * dt, old + (rate - HASTE * dt) * dt)
    least = max(min(least, 0.0), floor)
    if keep[row, at + Y] < least:
        keep[row, at + Y], keep[row, at + Y_RATE] = least, (least - old) / dt


@inlined
def touch_softly(keep: Any, row: int, at: int, old: float, shown: float, floor: float, dt: float) -> None:
    """Holds a foot above its motion that would come down faster than it can brake; arguments as in
    `come_down_gently`.
    """
    least = shown - (SOFT + BRAKES * max(shown - floor, 0.0)) * dt
    if keep[row, at + Y] < least:
        keep[row, at + Y], keep[row, at + Y_RATE] = least, (least - old) / dt
