"""Fits the animated feet of an actor to uneven ground, before the foot lock looks at them: a foot lies on the
slope below it, lands on a tread, and is carried over what is in its way.

A foot's fit is five numbers: x, z (metres from its motion), the slope along x and z (metres a metre), and how
much higher than the root's floor it is (metres). A pose offset that begins takes the fit over: as long as it
lasts, the animated foot has its share of it already.

`f`, `legs`, `root`, `keep`, `row` as in `foot_lock`; `at` the column of the foot's first number for uneven
ground, `lock` of its first number for the foot lock; `landing` whether the motion says where the foot lands,
x, z, yaw, and the seconds until then (below 0: it should stand already, where it is in its motion); `left`
the share of the pose offset that is left.
"""

from __future__ import annotations

import math
from typing import Any

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.scalar import sincos
from statwalk.maths.simd.pose_layout import place_of
from statwalk.maths.springs import settled
from statwalk.solve.foot_aside import go_aside, without_haste
from statwalk.solve.foot_flight import fly, go_over, is_new, look_ahead, set_off
from statwalk.solve.foot_path import choose_landing
from statwalk.solve.foot_points import ankle_of, flat_place, stage_point
from statwalk.solve.foot_tables import (
    ASIDE_X,
    ASIDE_X_RATE,
    ASIDE_Z,
    ASIDE_Z_RATE,
    AT_X,
    AT_Z,
    CLIMB,
    FIT,
    FLIES,
    HEIGHT,
    LIFT,
    PLAN,
    PLANTED,
    SHIFT_X,
    SHIFT_X_RATE,
    SHIFT_Z,
    SHIFT_Z_RATE,
    SHIFTED,
    SINCE,
    SLIP,
    SLIP_RATE,
    SLOPE_X,
    SLOPE_Z,
    STANDING,
    STANDS,
    TILT_X,
    TILT_X_RATE,
    TILT_Z,
    TILT_Z_RATE,
    TO_X,
    TO_Z,
    TOOK,
    TURN,
    X,
    Z,
)  # fmt: skip
from statwalk.solve.footing import height_under, slope_under

NEAR, FAR = 0.03, 0.12
"""metres above the ground: a foot that is nearer lies on the slope; one that is farther is as in its motion
"""
SOON_S, BLENDED = 0.1, 0.5
"""a foot whose motion lands in so few seconds, while more than this share of a pose offset is left, lands
where it is: the offset keeps it away from where its motion lands
"""
LEAN = 18.0
"""1/s: how eagerly a foot leans to a slope"""
SETTLE = 17.0
"""1/s: how eagerly a foot comes to another height than it was going to"""


@called
def fit_foot(
    f: Any, legs: Any, keep: Any, row: int, foot: int, lock: int, at: int, root: Any, landing: Any,
    left: float, dt: float,
) -> None:  # fmt: skip
    """Moves the matrices of an animated foot in `legs` to the ground of the stage."""
    ankle = ankle_of(f, legs, row, foot, root)
    sine, cosine = sincos(ankle[3])
    x, z = flat_place(f, legs, row, foot, root, sine, cosine)
    own_x, own_z = x - left * keep[row, at + TOOK + SHIFT_X], z - left * keep[row, at + TOOK + SHIFT_Z]
    here_x = own_x + keep[row, at + SHIFT_X] + keep[row, lock + X]
    here_z = own_z + keep[row, at + SHIFT_Z] + keep[row, lock + Z]
    yaw = ankle[3] + keep[row, lock + TURN]
    taken = left * keep[row, at + TOOK + LIFT]
    if keep[row, lock + SINCE] < 0.0:
        _begin(f, keep, row, foot, at, here_x, here_z, yaw, landing[0] and landing[4] < 0.0)
    elif keep[row, lock + PLANTED] == STANDING:
        _stand(f, keep, row, foot, at, here_x, here_z, yaw)
    else:
        own, here = (own_x, own_z), (here_x, here_z)
        _on_its_way(f, legs, keep, row, foot, lock, at, root, landing, own, here, yaw, left, dt)
    if keep[row, at + PLAN] != STANDS:
        near = _nearness(f, legs, row, foot, root, taken)
        sine, cosine = sincos(yaw)
        slope_x, slope_z = slope_under(f, foot, here_x, here_z, sine, cosine)
        if keep[row, at + PLAN] == FLIES:
            there_x, there_z = slope_under(f, foot, keep[row, at + TO_X], keep[row, at + TO_Z], sine, cosine)
            part = keep[row, at + SHIFTED] * keep[row, at + SHIFTED]
            slope_x, slope_z = slope_x + (there_x - slope_x) * part, slope_z + (there_z - slope_z) * part
        keep[row, at + SLOPE_X], keep[row, at + SLOPE_Z] = slope_x * near, slope_z * near
    keep[row, at + AT_X], keep[row, at + AT_Z] = here_x, here_z
    _settle(keep, row, at, root, dt)
    _move(f, legs, keep, row, foot, at, x, root[1] + taken, z, root, left)


@inlined
def _on_its_way(
    f: Any, legs: Any, keep: Any, row: int, foot: int, lock: int, at: int, root: Any, landing: Any, own: Any,
    here: Any, yaw: float, left: float, dt: float,
) -> None:  # fmt: skip
    """A foot in the air: it goes to where its motion lands, or looks ahead, and keeps out of steps."""
    keep[row, at + SHIFT_X] -= keep[row, at + ASIDE_X]
    keep[row, at + SHIFT_Z] -= keep[row, at + ASIDE_Z]
    old_x, old_z = keep[row, at + SHIFT_X], keep[row, at + SHIFT_Z]
    x, z = here[0] - keep[row, at + ASIDE_X], here[1] - keep[row, at + ASIDE_Z]
    if landing[0]:
        seconds = landing[4] if landing[4] > SOON_S or left < BLENDED else -1.0
        to_x, to_z = (landing[1], landing[2]) if seconds >= 0.0 else own
        if is_new(keep, row, at, to_x, to_z):
            set_off(f, keep, row, foot, at, to_x, to_z, landing[3], seconds)
        fly(keep, row, at, x, z, seconds, dt)
    else:
        look_ahead(f, keep, row, foot, at, x, z, yaw, dt)
    without_haste(keep, row, at + SHIFT_X, at + SHIFT_X_RATE, at + ASIDE_X, old_x, dt)
    without_haste(keep, row, at + SHIFT_Z, at + SHIFT_Z_RATE, at + ASIDE_Z, old_z, dt)
    if keep[row, lock + PLANTED] == 0.0:
        go_aside(f, legs, keep, row, foot, lock, at, root, left, dt)
    keep[row, at + SHIFT_X] += keep[row, at + ASIDE_X]
    keep[row, at + SHIFT_Z] += keep[row, at + ASIDE_Z]


@inlined
def begin_fit(keep: Any, row: int, at: int) -> None:
    """A new motion begins in the pose that is shown: its offset takes the fit over, and how fast it moves."""
    for number in range(FIT):
        keep[row, at + TOOK + number] = keep[row, at + number]
    keep[row, at + CLIMB] = keep[row, at + SLIP_RATE] = 0.0
    keep[row, at + TILT_X_RATE] = keep[row, at + TILT_Z_RATE] = 0.0
    keep[row, at + ASIDE_X_RATE] = keep[row, at + ASIDE_Z_RATE] = 0.0
    keep[row, at + SHIFT_X_RATE] = keep[row, at + SHIFT_Z_RATE] = 0.0


@inlined
def _begin(
    f: Any, keep: Any, row: int, foot: int, at: int, x: float, z: float, yaw: float, is_down: bool
) -> None:
    """A new actor: its feet are on the ground at once; a foot that its motion plants, where it would land."""
    to_x, to_z = x, z
    if is_down:
        sine, cosine = sincos(yaw)
        choose_landing(f, keep, row, foot, at, x, z, sine, cosine)
        to_x, to_z = keep[row, at + TO_X], keep[row, at + TO_Z]
    keep[row, at + SHIFT_X], keep[row, at + SHIFT_Z] = to_x - x, to_z - z
    _stand(f, keep, row, foot, at, to_x, to_z, yaw)
    keep[row, at + SLIP] = 0.0
    keep[row, at + TILT_X], keep[row, at + TILT_Z] = keep[row, at + SLOPE_X], keep[row, at + SLOPE_Z]


@inlined
def _stand(f: Any, keep: Any, row: int, foot: int, at: int, x: float, z: float, yaw: float) -> None:
    """A foot that stands: the ground below it is looked at once."""
    if keep[row, at + PLAN] != STANDS:
        sine, cosine = sincos(yaw)
        slope_x, slope_z = slope_under(f, foot, x, z, sine, cosine)
        height = height_under(f, foot, x, z, sine, cosine, slope_x, slope_z)
        go_over(keep, row, at, height)
        keep[row, at + SLOPE_X], keep[row, at + SLOPE_Z] = slope_x, slope_z
        keep[row, at + PLAN] = STANDS


@inlined
def _nearness(f: Any, legs: Any, row: int, foot: int, root: Any, taken: float) -> Any:
    """1 for a foot that is near the ground in its motion, 0 for one that is far above it."""
    least = 1e9
    first = f.first_point[foot]
    for point in range(first, first + f.lowest[foot]):
        _, y, _ = stage_point(f, legs, row, point, root)
        least = min(least, y)
    part = min(max((FAR - (least - root[1] - taken)) / (FAR - NEAR), 0.0), 1.0)
    return part * part * (3.0 - 2.0 * part)


@inlined
def _settle(keep: Any, row: int, at: int, root: Any, dt: float) -> None:
    """The fit comes to what is wanted."""
    slope_x, slope_z = keep[row, at + SLOPE_X], keep[row, at + SLOPE_Z]
    tilt, rate = settled(keep[row, at + TILT_X] - slope_x, keep[row, at + TILT_X_RATE], LEAN, dt)
    keep[row, at + TILT_X], keep[row, at + TILT_X_RATE] = slope_x + tilt, rate
    tilt, rate = settled(keep[row, at + TILT_Z] - slope_z, keep[row, at + TILT_Z_RATE], LEAN, dt)
    keep[row, at + TILT_Z], keep[row, at + TILT_Z_RATE] = slope_z + tilt, rate
    slip, rate = settled(keep[row, at + SLIP], keep[row, at + SLIP_RATE], SETTLE, dt)
    keep[row, at + SLIP], keep[row, at + SLIP_RATE] = slip, rate
    keep[row, at + LIFT] = keep[row, at + HEIGHT] + slip - root[1]


@inlined
def _move(
    f: Any, legs: Any, keep: Any, row: int, foot: int, at: int, x: float, y: float, z: float, root: Any,
    left: float,
) -> None:  # fmt: skip
    """Turns the joints of a foot about the point x, y, z below the middle of its sole, and moves them."""
    block, lane = place_of(row)
    fit_x = keep[row, at + SHIFT_X] - left * keep[row, at + TOOK + SHIFT_X]
    fit_z = keep[row, at + SHIFT_Z] - left * keep[row, at + TOOK + SHIFT_Z]
    lift = keep[row, at + LIFT] - left * keep[row, at + TOOK + LIFT]
    tilt_x = keep[row, at + TILT_X] - left * keep[row, at + TOOK + TILT_X]
    tilt_z = keep[row, at + TILT_Z] - left * keep[row, at + TOOK + TILT_Z]
    to_x, to_z = fit_x * root[4] - fit_z * root[3], fit_z * root[4] + fit_x * root[3]  # in model space
    a, c = tilt_z * root[3] - tilt_x * root[4], -tilt_z * root[4] - tilt_x * root[3]
    size = 1.0 / math.sqrt(1.0 + a * a + c * c)
    a, b, c = a * size, size, c * size  # the normal of the slope
    px, pz = x - root[0], z - root[2]
    px, py, pz = px * root[4] - pz * root[3], y - root[1], pz * root[4] + px * root[3]
    part, unit = 1.0 / (1.0 + b), f.unit[0]
    px, py, pz, to_x, to_z, lift = px * unit, py * unit, pz * unit, to_x * unit, to_z * unit, lift * unit
    for number in range(f.first_below[foot], f.first_below[foot + 1]):
        place = f.below[number]
        for column in range(4):
            u, v, w = (
                legs[block, place, column, lane],
                legs[block, place, 4 + column, lane],
                legs[block, place, 8 + column, lane],
            )
            if column == 3:
                u, v, w = u - px, v - py, w - pz
            along = (a * u + c * w) * part
            new_u, new_v, new_w = u + a * v - a * along, b * v - a * u - c * w, w + c * v - c * along
            if column == 3:
                new_u, new_v, new_w = new_u + px + to_x, new_v + py + lift, new_w + pz + to_z
            legs[block, place, column, lane] = new_u
            legs[block, place, 4 + column, lane] = new_v
            legs[block, place, 8 + column, lane] = new_w
