"""The foot lock: a foot that stands stays where it stands; a foot that must go elsewhere takes a step.

For each foot of one actor, from its animated pose on the stage: while a foot is planted, the point of the sole
on which it stands and its yaw do not move; the difference from the motion grows. A foot is released when its
motion lifts it, or when the difference has become too large; then the difference dies out on the way, and the
foot is held so high that it does not drag. The sole never goes below the ground.

`f` FootTables; `legs` the model matrices of `f.joints`; `keep` the solvers' memory, a row for each actor; `at`
the column of the foot's first number, `other` of another foot's; `root` x, y, z of the actor, sine and cosine
of its heading.
"""

from __future__ import annotations

import math
from typing import Any

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.scalar import atan2, sincos
from statwalk.maths.simd.pose_layout import place_of
from statwalk.maths.springs import settled
from statwalk.solve.foot_tables import (
    EAGER,
    LOWEST,
    LOWEST_X,
    LOWEST_Z,
    PIVOT,
    PIVOT_X,
    PIVOT_Z,
    PLANTED,
    SINCE,
    TURN,
    TURN_RATE,
    X_RATE,
    Y_RATE,
    YAW,
    Z_RATE,
    X,
    Y,
    Z,
)  # fmt: skip
from statwalk.solve.ground import ground_at

LOW, SLOW = 0.012, 0.35
"""a foot is planted when its lowest point is this near to the ground (metres), and slower than this (m/s)"""
STEP, FAR = 0.03, 0.14
"""metres from its motion at which a planted foot takes a step, if the other foot stands; and in any case"""
TWIST, FAR_TWIST = 0.15, 0.5
"""radians, likewise"""
TWIST_LENGTH = 0.2
"""metres that count as one radian, where two feet are compared"""
SHORTEST_STAND, SHORTEST_STEP = 0.05, 0.1
"""seconds"""
HARDEST, MOST_EAGER = 30.0, 24.0
"""m/s² with which a released foot sets off to its motion at most; 1/s"""
CLEARANCE, PER_METRE, PER_SPEED = 0.06, 0.3, 0.03
"""metres by which a foot on its way is lifted at most; for each metre from its motion; for each m/s"""
LEAST_CLEARANCE = 0.004
CLEAR, LONGEST_LEAVE = 0.007, 0.1
"""a released foot keeps its place until it is so high (metres), for so long at most (seconds)"""
RISE = 28.0
"""1/s: how eagerly a foot comes to its height"""
ROLL = 0.001
"""metres by which another point of the sole must be lower, for the foot to roll on to it"""


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
    return on_stage(a, b, c + legs[block, place, 11, lane], root)


@inlined
def on_stage(x: float, y: float, z: float, root: Any) -> Any:
    """Returns a point of model space on the stage."""
    return x * root[4] + z * root[3] + root[0], y + root[1], z * root[4] - x * root[3] + root[2]


@inlined
def lowest_point(f: Any, legs: Any, row: int, foot: int, root: Any) -> Any:
    """Returns the lowest animated point of a sole, and its x, y, z."""
    best = f.first_point[foot]
    bx, by, bz = stage_point(f, legs, row, best, root)
    for point in range(best + 1, f.first_point[foot + 1]):
        x, y, z = stage_point(f, legs, row, point, root)
        if y < by:
            best, bx, by, bz = point, x, y, z
    return best, bx, by, bz


@inlined
def ankle_of(f: Any, legs: Any, row: int, foot: int, root: Any) -> Any:
    """Returns x, y, z on the stage and the yaw of an animated ankle."""
    block, lane = place_of(row)
    place, a = f.ankle[foot], f.ahead[foot]
    x = legs[block, place, 0, lane] * a[0] + legs[block, place, 1, lane] * a[1]
    x += legs[block, place, 2, lane] * a[2]
    z = legs[block, place, 8, lane] * a[0] + legs[block, place, 9, lane] * a[1]
    z += legs[block, place, 10, lane] * a[2]
    yaw = atan2(x * root[4] + z * root[3], z * root[4] - x * root[3])
    px, py, pz = on_stage(
        legs[block, place, 3, lane], legs[block, place, 7, lane], legs[block, place, 11, lane], root
    )
    return px, py, pz, yaw


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


@inlined
def begin_blend(keep: Any, row: int, at: int) -> None:
    """Forgets how far a shown foot is from its motion: the new motion begins in the pose that is shown."""
    keep[row, at + LOWEST_X] += keep[row, at + X]
    keep[row, at + LOWEST_Z] += keep[row, at + Z]
    for number in range(X, Y_RATE + 1):
        keep[row, at + number] = 0.0


@called
def step_foot(
    f: Any,
    legs: Any,
    keep: Any,
    row: int,
    foot: int,
    at: int,
    other: int,
    root: Any,
    is_down: bool,
    dt: float,
) -> None:
    """Moves the numbers of one foot on by a tick; `is_down`: its motion plants it now; `other`: -1 if it is the
    only foot.
    """
    ankle = ankle_of(f, legs, row, foot, root)
    low = lowest_point(f, legs, row, foot, root)
    speed = _speed(f, legs, keep, row, at, low, root, dt)
    if keep[row, at + SINCE] < 0.0:
        _begin(f, keep, row, at, low, ankle, root, is_down)
    old = keep[row, at + X], keep[row, at + Z], keep[row, at + TURN], keep[row, at + Y]
    keep[row, at + SINCE] += dt
    if keep[row, at + PLANTED] > 0.0:
        _hold(f, legs, keep, row, at, ankle, root)
        _perhaps_release(keep, row, at, other, is_down)
        _take_rates(keep, row, at, old, dt)
    if keep[row, at + PLANTED] == 0.0:
        if _is_leaving(f, keep, row, at, low, root):
            _hold(f, legs, keep, row, at, ankle, root)
            _take_rates(keep, row, at, old, dt)
        else:
            _approach(keep, row, at, old, dt)
    _raise(f, keep, row, at, low, old[3], root, is_down, speed, dt)
    _perhaps_plant(f, keep, row, at, low, root, is_down, speed)
    if keep[row, at + PLANTED] > 0.0:
        _roll(f, legs, keep, row, at, low, ankle, root)


@inlined
def _speed(f: Any, legs: Any, keep: Any, row: int, at: int, low: Any, root: Any, dt: float) -> Any:
    """The speed over the ground (m/s) of the point that was the lowest in the tick before."""
    speed = 0.0
    if keep[row, at + SINCE] >= 0.0:
        x, _, z = stage_point(f, legs, row, int(keep[row, at + LOWEST]), root)
        x, z = x - keep[row, at + LOWEST_X], z - keep[row, at + LOWEST_Z]
        speed = math.sqrt(x * x + z * z) / dt
    keep[row, at + LOWEST], keep[row, at + LOWEST_X], keep[row, at + LOWEST_Z] = low[0], low[1], low[3]
    return speed


@inlined
def _begin(f: Any, keep: Any, row: int, at: int, low: Any, ankle: Any, root: Any, is_down: bool) -> None:
    """A new actor: a foot that its motion plants is planted where it is."""
    is_low = low[2] - ground_at(f.ground, low[1], low[3], root[1]) < LOW
    keep[row, at + PLANTED] = 1.0 if is_down and is_low else 0.0
    keep[row, at + PIVOT], keep[row, at + PIVOT_X], keep[row, at + PIVOT_Z] = low[0], low[1], low[3]
    keep[row, at + YAW], keep[row, at + SINCE] = ankle[3], 1.0


@inlined
def _hold(f: Any, legs: Any, keep: Any, row: int, at: int, ankle: Any, root: Any) -> None:
    """A planted foot: what keeps its yaw and the point on which it stands."""
    turn = keep[row, at + YAW] - ankle[3]
    turn -= 2.0 * math.pi * math.floor(turn / (2.0 * math.pi) + 0.5)
    pivot = stage_point(f, legs, row, int(keep[row, at + PIVOT]), root)
    x, z = shown_point(pivot, ankle, turn, 0.0, 0.0)
    keep[row, at + TURN] = turn
    keep[row, at + X], keep[row, at + Z] = keep[row, at + PIVOT_X] - x, keep[row, at + PIVOT_Z] - z


@inlined
def _perhaps_release(keep: Any, row: int, at: int, other: int, is_down: bool) -> None:
    """Releases a foot that its motion lifts, that is too far from its motion, or that takes a step."""
    x, z, twist = keep[row, at + X], keep[row, at + Z], abs(keep[row, at + TURN])
    away = math.sqrt(x * x + z * z)
    goes = not is_down or away > FAR or twist > FAR_TWIST or keep[row, at + EAGER] > 0.0
    if not goes and other >= 0 and keep[row, at + SINCE] > SHORTEST_STAND:
        stands = keep[row, other + PLANTED] > 0.0 and keep[row, other + SINCE] > SHORTEST_STAND
        further = size_of(keep, row, at) >= size_of(keep, row, other)
        goes = stands and further and (away > STEP or twist > TWIST)
    if goes:
        keep[row, at + PLANTED], keep[row, at + SINCE] = 0.0, 0.0
        keep[row, at + EAGER] = min(MOST_EAGER, math.sqrt(HARDEST / max(away, 0.01)))


@inlined
def _take_rates(keep: Any, row: int, at: int, old: Any, dt: float) -> None:
    keep[row, at + X_RATE] = (keep[row, at + X] - old[0]) / dt
    keep[row, at + Z_RATE] = (keep[row, at + Z] - old[1]) / dt
    keep[row, at + TURN_RATE] = (keep[row, at + TURN] - old[2]) / dt


@inlined
def _is_leaving(f: Any, keep: Any, row: int, at: int, low: Any, root: Any) -> Any:
    """Whether a released foot is still on the ground: it rises before it goes."""
    x, z = low[1] + keep[row, at + X], low[3] + keep[row, at + Z]
    height = low[2] + keep[row, at + Y] - ground_at(f.ground, x, z, root[1])
    return keep[row, at + SINCE] < LONGEST_LEAVE and height < CLEAR and keep[row, at + SINCE] >= 0.0


@inlined
def _approach(keep: Any, row: int, at: int, old: Any, dt: float) -> None:
    """A foot on its way: the difference from its motion dies out."""
    eager = keep[row, at + EAGER]
    keep[row, at + X], keep[row, at + X_RATE] = settled(old[0], keep[row, at + X_RATE], eager, dt)
    keep[row, at + Z], keep[row, at + Z_RATE] = settled(old[1], keep[row, at + Z_RATE], eager, dt)
    keep[row, at + TURN], keep[row, at + TURN_RATE] = settled(old[2], keep[row, at + TURN_RATE], eager, dt)


@inlined
def _raise(
    f: Any, keep: Any, row: int, at: int, low: Any, old: float, root: Any, is_down: bool, speed: float,
    dt: float,
) -> None:  # fmt: skip
    """The height of the shown foot: on the ground if planted; clear of it on its way."""
    x, z = keep[row, at + X], keep[row, at + Z]
    floor = ground_at(f.ground, low[1] + x, low[3] + z, root[1]) - low[2]
    wanted = floor + low[2] - root[1]  # as high above the ground as in the motion
    if keep[row, at + PLANTED] > 0.0:
        wanted = floor
    elif is_down or -floor < CLEARANCE:
        clear = PER_METRE * math.sqrt(x * x + z * z) + (PER_SPEED * min(speed, 1.0) if is_down else 0.0)
        clear = min(clear, CLEARANCE)
        wanted = max(wanted, floor + (clear if clear > LEAST_CLEARANCE else 0.0))
    height, rate = settled(old - wanted, keep[row, at + Y_RATE], RISE, dt)
    height += wanted
    if height < floor:
        height, rate = floor, (floor - old) / dt
    keep[row, at + Y], keep[row, at + Y_RATE] = height, rate


@inlined
def _perhaps_plant(
    f: Any, keep: Any, row: int, at: int, low: Any, root: Any, is_down: bool, speed: float
) -> None:
    """Plants a foot that has come down where its motion plants it."""
    if keep[row, at + PLANTED] > 0.0 or not is_down or speed > SLOW or keep[row, at + SINCE] < SHORTEST_STEP:
        return
    x, z = keep[row, at + X], keep[row, at + Z]
    height = low[2] + keep[row, at + Y] - ground_at(f.ground, low[1] + x, low[3] + z, root[1])
    if height < LOW:
        keep[row, at + PLANTED], keep[row, at + SINCE], keep[row, at + PIVOT] = 1.0, 0.0, low[0]
        keep[row, at + EAGER] = 0.0


@inlined
def _roll(f: Any, legs: Any, keep: Any, row: int, at: int, low: Any, ankle: Any, root: Any) -> None:
    """The point on which a planted foot stands in the next tick, and where it is shown now."""
    pivot = stage_point(f, legs, row, int(keep[row, at + PIVOT]), root)
    if low[2] < pivot[1] - ROLL:
        keep[row, at + PIVOT] = low[0]
        pivot = low[1], low[2], low[3]
    turn = keep[row, at + TURN]
    x, z = shown_point(pivot, ankle, turn, keep[row, at + X], keep[row, at + Z])
    keep[row, at + PIVOT_X], keep[row, at + PIVOT_Z], keep[row, at + YAW] = x, z, ankle[3] + turn
