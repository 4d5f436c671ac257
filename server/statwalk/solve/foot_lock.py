"""The foot lock: a foot that stands stays where it stands; a foot that must go elsewhere takes a step.

For each foot of one actor, from its animated pose on the stage: while a foot is planted, the point of the
sole on which it stands and its yaw do not move; the difference from the motion grows. A foot is released when
its motion lifts it, or when the difference has become too large; then the difference dies out on the way, and
the foot is held so high that it does not drag. While the other foot is in the air, a foot that its motion
plants comes down where it is, and takes its step later. The sole never goes below the ground.

`f`, `legs`, `root` as in `foot_points`; `keep` the solvers' memory, a row for each actor; `at` the column of
the foot's first number, `other` of another foot's.
"""

from __future__ import annotations

import math
from typing import Any

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.solve.foot_height import LOOK_AHEAD, come_down_gently, floor_of, raise_foot, touch_softly
from statwalk.solve.foot_points import ankle_of, lowest_point, shown_point, size_of, speeds_of, stage_point
from statwalk.solve.foot_return import approach, eagerness, take_rates
from statwalk.solve.foot_tables import (
    EAGER,
    LEAVING,
    LOWEST_X,
    LOWEST_Y,
    LOWEST_Z,
    PIVOT,
    PIVOT_X,
    PIVOT_Z,
    PLANTED,
    SINCE,
    STANDING,
    TOO_SHORT,
    TURN,
    Y_RATE,
    YAW,
    X,
    Y,
    Z,
)  # fmt: skip
from statwalk.solve.ground import ground_at

LOW, SLOW = 0.012, 0.35
"""a foot is planted when its lowest point is this near to the ground (metres), and slower than this (m/s)"""
NOT_FAST, TOUCHING = 1.0, 0.008
"""a foot that touches the ground in a blend or where its motion plants it, or touches uneven ground, is
planted when it is slower than NOT_FAST (m/s), and nearer to the ground than TOUCHING (metres): otherwise the
foot would drag
"""
KEPT_OFF, DRAGS, IN_BLEND = 0.007, 1.5, 0.3
"""metres by which a foot on its way is kept off the ground if it is as fast as DRAGS (m/s); at NOT_FAST it
is not kept off, and between the two speeds the metres grow evenly; in a blend, this part of them
"""
LANDING = 2.0
"""m/s: a foot that its motion plants, while the other is in the air, comes down unless it is faster"""
LIFTED, LIFTED_IN_BLEND = 0.003, 0.005
"""metres by which its motion, if that is not slow, must have lifted a planted foot for it to go along; in a
blend, which may lower the foot again
"""
STEP, FAR, FARTHEST = 0.03, 0.14, 0.25
"""metres from its motion at which a planted foot takes a step: if the other foot has stood for a moment; if
the other foot stands; in any case
"""
TWIST, FAR_TWIST = 0.15, 0.5
"""radians: if the other foot has stood for a moment; in any case"""
SHORTEST_STAND, SHORTEST_STEP = 0.05, 0.1
"""seconds; a step that touches the ground, and would drag, may end after SHORTEST_STAND"""
CLEAR, LONGEST_LEAVE = 0.007, 0.1
"""a released foot keeps its place until it is so high (metres), for so long at most (seconds)"""
ROLL = 0.001
"""metres by which another point of the sole must be lower, for the foot to roll on to it"""


@inlined
def begin_blend(keep: Any, row: int, at: int) -> None:
    """Forgets how far a shown foot is from its motion: the new motion begins in the pose that is shown."""
    keep[row, at + LOWEST_X] += keep[row, at + X]
    keep[row, at + LOWEST_Z] += keep[row, at + Z]
    keep[row, at + LOWEST_Y] += keep[row, at + Y]
    for number in range(X, Y_RATE + 1):
        keep[row, at + number] = 0.0


@called
def step_foot(
    f: Any, legs: Any, keep: Any, row: int, foot: int, at: int, other: int, root: Any, is_down: bool,
    blends: bool, dt: float,
) -> None:  # fmt: skip
    """Moves the numbers of one foot on by a tick; `is_down`: its motion plants it now; `blends`: it goes over
    from one motion into another; `other`: -1 if it is the only foot.
    """
    ankle = ankle_of(f, legs, row, foot, root)
    low = lowest_point(f, legs, row, foot, root, keep[row, at + X], keep[row, at + Z])
    speed, fall, sank = speeds_of(f, legs, keep, row, at, low, root, dt)
    if keep[row, at + SINCE] < 0.0:
        _begin(f, keep, row, at, low, ankle, root, is_down)
    old = keep[row, at + X], keep[row, at + Z], keep[row, at + TURN], keep[row, at + Y]
    keep[row, at + SINCE] += dt
    shown = old[3] + max(sank, 0.0)
    goes_along = keep[row, at + PLANTED] == STANDING and speed > SLOW and fall <= 0.0
    if goes_along or keep[row, at + PLANTED] == LEAVING:
        floor = floor_of(f, legs, keep, row, foot, at, ankle, low, root, shown, dt)
        if goes_along:
            _perhaps_go_along(f, keep, row, at, floor, blends, speed)
        else:
            _perhaps_leave(keep, row, at, floor, speed)
    if keep[row, at + PLANTED] >= LEAVING:
        _hold(f, legs, keep, row, at, ankle, root)
        take_rates(keep, row, at, old, dt)
        if keep[row, at + PLANTED] == STANDING:
            _perhaps_release(keep, row, at, other, is_down, speed)
    else:
        approach(keep, row, at, old, speed, dt)
    ahead = fall * LOOK_AHEAD if blends else 0.0
    lands = is_down and _must_land(keep, row, at, other, speed)
    floor = floor_of(f, legs, keep, row, foot, at, ankle, low, root, shown, dt)
    floor += _kept_off(f, keep, row, at, blends, lands, speed, sank)
    rate = keep[row, at + Y_RATE]
    raise_foot(keep, row, at, floor, is_down or blends, speed, ahead, lands, dt)
    if f.fit[0] >= 0 and lands:
        come_down_gently(keep, row, at, old[3], rate, old[3] + sank, floor, dt)
    if f.fit[0] >= 0 and blends and keep[row, at + PLANTED] == 0.0:
        touch_softly(keep, row, at, old[3], old[3] + sank, floor, dt)
    _perhaps_plant(f, keep, row, at, low, root, is_down, blends, lands, speed)
    if keep[row, at + PLANTED] == STANDING:
        _roll(f, legs, keep, row, at, low, ankle, root)


@inlined
def _begin(f: Any, keep: Any, row: int, at: int, low: Any, ankle: Any, root: Any, is_down: bool) -> None:
    """A new actor: a foot that its motion plants is planted where it is."""
    is_low = low[2] - ground_at(f.ground, low[1], low[3], root[1]) < LOW
    keep[row, at + PLANTED] = STANDING if is_down and is_low else 0.0
    keep[row, at + PIVOT], keep[row, at + PIVOT_X], keep[row, at + PIVOT_Z] = low[0], low[1], low[3]
    keep[row, at + YAW], keep[row, at + SINCE] = ankle[3], 1.0


@inlined
def _perhaps_go_along(
    f: Any, keep: Any, row: int, at: int, floor: float, blends: bool, speed: float
) -> None:  # fmt: skip
    """Releases a planted foot that its motion has lifted, before it is held back: a foot that sets off late
    would still be behind when it lands. On uneven ground a foot comes down before its motion does, and then
    stands for a moment at least.
    """
    may_go = f.fit[0] < 0 or keep[row, at + SINCE] > SHORTEST_STAND
    height = -floor  # of the animated foot above the ground
    if may_go and height > (LIFTED_IN_BLEND if blends else LIFTED):
        keep[row, at + PLANTED], keep[row, at + SINCE] = 0.0, 0.0
        keep[row, at + EAGER] = eagerness(keep, row, at, speed)


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
def _perhaps_release(
    keep: Any, row: int, at: int, other: int, is_down: bool, speed: float
) -> None:  # fmt: skip
    """Releases a foot that its motion lifts, that is too far from its motion, or that takes a step."""
    x, z, twist = keep[row, at + X], keep[row, at + Z], abs(keep[row, at + TURN])
    away = math.sqrt(x * x + z * z)
    far = FAR if other < 0 or keep[row, other + PLANTED] == STANDING else FARTHEST
    goes = not is_down or away > far or twist > FAR_TWIST or keep[row, at + TOO_SHORT] > 0.0
    if not goes and other >= 0 and keep[row, at + SINCE] > SHORTEST_STAND:
        stands = keep[row, other + PLANTED] == STANDING and keep[row, other + SINCE] > SHORTEST_STAND
        further = size_of(keep, row, at) >= size_of(keep, row, other)
        goes = stands and further and (away > STEP or twist > TWIST)
    if goes:
        keep[row, at + PLANTED], keep[row, at + SINCE] = LEAVING, 0.0
        keep[row, at + EAGER] = eagerness(keep, row, at, speed)


@inlined
def _perhaps_leave(keep: Any, row: int, at: int, floor: float, speed: float) -> None:
    """Lets a released foot go to its motion: once it is clear of the ground, or too far behind."""
    x, z = keep[row, at + X], keep[row, at + Z]
    away = math.sqrt(x * x + z * z)
    clear = keep[row, at + Y] - floor > CLEAR
    if clear or away > FAR or keep[row, at + SINCE] > LONGEST_LEAVE:
        keep[row, at + PLANTED] = 0.0
        keep[row, at + EAGER] = eagerness(keep, row, at, speed)


@inlined
def _must_land(keep: Any, row: int, at: int, other: int, speed: float) -> Any:
    """Whether a foot on its way that its motion plants comes down at once: because the other foot does not
    stand, or because this foot already comes down, and is lower than its motion.
    """
    comes_already = keep[row, at + Y] < -TOUCHING
    lands = other >= 0 and (comes_already or keep[row, other + PLANTED] != STANDING)
    on_its_way = keep[row, at + PLANTED] == 0.0 and keep[row, at + SINCE] >= SHORTEST_STEP
    return lands and on_its_way and speed <= LANDING and size_of(keep, row, at) < FAR


@inlined
def _kept_off(
    f: Any, keep: Any, row: int, at: int, blends: bool, lands: bool, speed: float, sank: float
) -> Any:  # fmt: skip
    """Metres by which a foot in the air is kept off the ground; 0 if it comes down. Over a level floor no
    more than its motion has just lowered it: clips that walk on the spot drag their feet, and do not hover.
    """
    if keep[row, at + PLANTED] != 0.0 or lands:
        return 0.0
    most = KEPT_OFF * IN_BLEND if blends else KEPT_OFF
    if f.fit[0] < 0:
        most = min(most, max(sank, 0.0))
    return most * min(max((speed - NOT_FAST) / (DRAGS - NOT_FAST), 0.0), 1.0)


@inlined
def _perhaps_plant(
    f: Any, keep: Any, row: int, at: int, low: Any, root: Any, is_down: bool, blends: bool, lands: bool,
    speed: float,
) -> None:  # fmt: skip
    """Plants a foot that has come down where its motion plants it, or that touches the ground and would drag:
    where its motion plants it, in a blend, or on uneven ground, of which its motion knows nothing.
    """
    since = keep[row, at + SINCE]
    if keep[row, at + PLANTED] != 0.0 or since < SHORTEST_STAND:
        return
    x, z = keep[row, at + X], keep[row, at + Z]
    height = low[2] + keep[row, at + Y] - ground_at(f.ground, low[1] + x, low[3] + z, root[1])
    comes_down = is_down and (lands or speed <= SLOW) and height < LOW and since >= SHORTEST_STEP
    touches = (blends or is_down or f.fit[0] >= 0) and speed <= NOT_FAST
    if comes_down or (touches and height < TOUCHING):
        keep[row, at + PLANTED], keep[row, at + SINCE], keep[row, at + PIVOT] = STANDING, 0.0, low[0]
        keep[row, at + EAGER] = keep[row, at + TOO_SHORT] = 0.0


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
