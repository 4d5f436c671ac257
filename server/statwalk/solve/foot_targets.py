"""From locked feet to legs: how far the pelvis gives way, and the targets of the legs' two-bone solver.

Arguments as in `foot_lock`; `rows` are the inputs of the legs' chains for one block (`chains`).
"""

from __future__ import annotations

import math
from typing import Any

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.scalar import sincos
from statwalk.maths.simd.pose_layout import joint_channel, place_of
from statwalk.maths.springs import settled
from statwalk.solve.chains import ROTATION, TARGET, WEIGHT
from statwalk.solve.foot_knee import write_pole
from statwalk.solve.foot_points import ankle_of, hip_of
from statwalk.solve.foot_stretch import beyond_softening
from statwalk.solve.foot_tables import (
    BENT,
    DROP,
    DROP_RATE,
    FLIES,
    HEIGHT,
    LEAVING,
    LIFT_RATE,
    OF_ACTOR,
    OF_FIT,
    OF_FOOT,
    OF_GROUND,
    PATH,
    PATH_PARTS,
    PLAN,
    PLANTED,
    SAG,
    SHIFTED,
    STANDING,
    TOO_SHORT,
    TURN,
    X,
    Y,
    Z,
)  # fmt: skip
from statwalk.solve.ground import ground_at

STRETCH = 0.99
"""of the length of a leg: to keep a planted foot in this reach, the pelvis gives way"""
MOST_DROP, MOST_DROP_ON_GROUND = 0.05, 0.35
"""metres by which the pelvis is lowered, on a level floor and on uneven ground; a foot that needs more is
released
"""
GIVE, GIVE_ON_GROUND, FOLLOW = 21.0, 13.0, 14.0
"""1/s: how eagerly the pelvis gives way, on a level floor and on uneven ground, and the root follows the
ground
"""
REACHED = 0.06
"""metres below the root at which a foot on its way lands, for which the pelvis need not be lowered"""
MOST_OVER = 0.15
"""metres above its place at most that a foot is shown, if its leg is too short"""
SAG_SHARE, MOST_SAG = 0.25, 0.15
"""metres by which the pelvis is lower for each metre that the ground rises or falls in a metre; at most"""
UPRIGHT = 0.6
"""of the length of a leg: a hip stays so high above the ground of its foot when the pelvis is lowered for
rising or falling ground, or for a foot that will land; lower, the knee would go into the step of the foot
"""
MEAN_STEPS, MEAN_STEP = 4, 0.11
"""places before and behind the root whose ground counts for its height, the nearest most; metres between them
"""


@called
def lower_pelvis(f: Any, legs: Any, keep: Any, row: int, root: Any, dt: float) -> Any:
    """Returns by how much the pelvis is lowered (metres), so that planted feet stay in reach."""
    memory, most = f.memory[0], MOST_DROP if f.ground.shape[0] == 0 else MOST_DROP_ON_GROUND
    wanted, room, give = 0.0, 0.0, GIVE
    if f.fit[0] >= 0:
        room, give = _room(f, legs, keep, row, root), GIVE_ON_GROUND
        wanted = min(keep[row, f.fit[0] + SAG], room)
    for foot in range(f.hip.shape[0]):
        at = memory + OF_ACTOR + foot * OF_FOOT
        if keep[row, at + PLANTED] == STANDING or (f.fit[0] >= 0 and keep[row, at + PLANTED] == LEAVING):
            need = _missing(f, legs, keep, row, foot, at, root, STRETCH * f.length[foot])
            keep[row, at + TOO_SHORT] = 1.0 if need > most else 0.0
            wanted = max(wanted, min(need, most))
        elif f.fit[0] >= 0:
            wanted = max(wanted, min(_awaited(keep, row, f.fit[0] + OF_GROUND + foot * OF_FIT, root), room))
    old = keep[row, memory + DROP] - wanted
    drop, rate = settled(old, keep[row, memory + DROP_RATE], give, dt)
    keep[row, memory + DROP], keep[row, memory + DROP_RATE] = drop + wanted, rate
    return drop + wanted


@inlined
def _room(f: Any, legs: Any, keep: Any, row: int, root: Any) -> Any:
    """By how much the pelvis can be lowered with all legs upright: a leg whose foot is ahead may be less
    upright, by as much as the foot is ahead.
    """
    room = MOST_DROP_ON_GROUND
    for foot in range(f.hip.shape[0]):
        ground = keep[row, f.fit[0] + OF_GROUND + foot * OF_FIT + HEIGHT]
        x, y, z = hip_of(f, legs, row, foot, root)
        ankle_x, _, ankle_z, _ = ankle_of(f, legs, row, foot, root)
        ahead = (ankle_x - x) * root[3] + (ankle_z - z) * root[4]
        room = min(room, y - ground - UPRIGHT * f.length[foot] + max(ahead, 0.0))
    return max(room, 0.0)


@inlined
def _awaited(keep: Any, row: int, at: int, root: Any) -> Any:
    """By how much the pelvis is lowered for a foot on its way that will land far below the root."""
    if keep[row, at + PLAN] != FLIES:
        return 0.0
    gone, below = keep[row, at + SHIFTED], root[1] - keep[row, at + PATH + PATH_PARTS]
    return max(below - REACHED, 0.0) * gone


@inlined
def begin_pelvis(f: Any, keep: Any, row: int) -> None:
    """Forgets how far the pelvis is lowered: a new motion begins in the pose that is shown."""
    keep[row, f.memory[0] + DROP], keep[row, f.memory[0] + DROP_RATE] = 0.0, 0.0


@inlined
def _missing(f: Any, legs: Any, keep: Any, row: int, foot: int, at: int, root: Any, reach: float) -> Any:
    """How much lower a hip must be for its leg to reach the shown ankle from `reach` units."""
    x, y, z = hip_of(f, legs, row, foot, root)
    ankle = ankle_of(f, legs, row, foot, root)
    x, z = x - ankle[0] - keep[row, at + X], z - ankle[2] - keep[row, at + Z]
    y -= ankle[1] + keep[row, at + Y]
    return y - math.sqrt(max(reach * reach - x * x - z * z, 0.0))


@inlined
def move_pelvis(f: Any, legs: Any, values: Any, row: int, drop: float) -> None:
    """Lowers the pelvis of the pose in a block of `values` by `drop` units."""
    drop *= f.unit[0]
    block, lane = place_of(row)
    channel, place = joint_channel(f.pelvis[0]), f.above_pelvis[0]
    for axis in range(3):
        part = 1.0 if axis == 1 else 0.0
        if place >= 0:  # the part of the direction up along an axis of the parent
            a, b = legs[block, place, axis, lane], legs[block, place, 4 + axis, lane]
            c = legs[block, place, 8 + axis, lane]
            part = b / max(a * a + b * b + c * c, 1e-12)
        values[block, channel + axis, lane] -= part * drop


@called
def aim_leg(
    f: Any, legs: Any, keep: Any, rows: Any, row: int, foot: int, root: Any, drop: float, left: float,
    weight: float,
) -> None:  # fmt: skip
    """Writes the inputs of a leg's chain: the shown ankle, its rotation, and where the knee bends to; `drop`:
    units by which the pelvis is lowered; `left`: how much of the pose offset of a transition is left.
    """
    block, lane = place_of(row)
    at, inputs = f.memory[0] + OF_ACTOR + foot * OF_FOOT, rows[foot]
    ankle = ankle_of(f, legs, row, foot, root)
    x, y, z = ankle[0] + keep[row, at + X], ankle[1] + keep[row, at + Y], ankle[2] + keep[row, at + Z]
    if f.fit[0] >= 0:  # a foot that is out of reach stays above its place: beside it there may be a step
        missing = _missing(f, legs, keep, row, foot, at, root, f.length[foot])
        y += min(max(missing - drop, 0.0), MOST_OVER)
        _note_bend(f, legs, keep, row, foot, root, x - root[0], y - root[1] + drop, z - root[2])
    elif left > 0.0:
        x, y, z = beyond_softening(f, legs, row, foot, root, ankle, drop, left, (x, y, z))
    x, z = x - root[0], z - root[2]
    inputs[TARGET, lane] = (x * root[4] - z * root[3]) * f.unit[0]
    inputs[TARGET + 1, lane] = (y - root[1]) * f.unit[0]
    inputs[TARGET + 2, lane] = (z * root[4] + x * root[3]) * f.unit[0]
    write_pole(f, legs, inputs, block, lane, foot, drop)
    _write_rotation(legs, inputs, block, f.ankle[foot], lane, keep[row, at + TURN])
    inputs[WEIGHT, lane] = weight


@inlined
def _note_bend(
    f: Any, legs: Any, keep: Any, row: int, foot: int, root: Any, x: float, y: float, z: float
) -> None:
    """Notes how much a leg is bent whose ankle is x, y, z units from the root, and from the animated hip."""
    hip = hip_of(f, legs, row, foot, root)
    u, v, w = hip[0] - root[0] - x, hip[1] - root[1] - y, hip[2] - root[2] - z
    stretched = min((u * u + v * v + w * w) / (f.length[foot] * f.length[foot]), 1.0)
    keep[row, f.fit[0] + OF_GROUND + foot * OF_FIT + BENT] = math.sqrt(1.0 - stretched)


@inlined
def _write_rotation(legs: Any, inputs: Any, block: int, place: int, lane: int, turn: float) -> None:
    """The rotation of the animated ankle in model space, turned about the vertical."""
    x, y, z, w = _quaternion(legs, block, place, lane)
    sine, cosine = sincos(0.5 * turn)
    inputs[ROTATION, lane] = cosine * x + sine * z
    inputs[ROTATION + 1, lane] = cosine * y + sine * w
    inputs[ROTATION + 2, lane] = cosine * z - sine * x
    inputs[ROTATION + 3, lane] = cosine * w - sine * y


@inlined
def _quaternion(legs: Any, block: int, place: int, lane: int) -> Any:
    """The rotation x y z w of a model matrix, its scale taken as even."""
    a, b, c = legs[block, place, 0, lane], legs[block, place, 4, lane], legs[block, place, 8, lane]
    size = 1.0 / math.sqrt(max(a * a + b * b + c * c, 1e-30))
    xx, yx, zx = a * size, b * size, c * size
    xy, yy = legs[block, place, 1, lane] * size, legs[block, place, 5, lane] * size
    zy, xz = legs[block, place, 9, lane] * size, legs[block, place, 2, lane] * size
    yz, zz = legs[block, place, 6, lane] * size, legs[block, place, 10, lane] * size
    if xx + yy + zz > 0.0:
        x, y, z, w = zy - yz, xz - zx, yx - xy, 1.0 + xx + yy + zz
    elif xx > yy and xx > zz:
        x, y, z, w = 1.0 + xx - yy - zz, xy + yx, xz + zx, zy - yz
    elif yy > zz:
        x, y, z, w = xy + yx, 1.0 + yy - xx - zz, yz + zy, xz - zx
    else:
        x, y, z, w = xz + zx, yz + zy, 1.0 + zz - xx - yy, yx - xy
    unit = 1.0 / math.sqrt(x * x + y * y + z * z + w * w)
    return x * unit, y * unit, z * unit, w * unit


@inlined
def follow_ground(f: Any, keep: Any, position: Any, row: int, sine: float, cosine: float, dt: float) -> None:
    """Moves the root to the mean height of the ground below it, before and behind it."""
    if f.fit[0] >= 0:
        ground, weights, rise, square = 0.0, 0.0, 0.0, 0.0
        for step in range(-MEAN_STEPS, MEAN_STEPS + 1):
            weight, away = MEAN_STEPS + 1.0 - abs(step), step * MEAN_STEP
            x, z = position[row, 0] / f.unit[0] + away * sine, position[row, 2] / f.unit[0] + away * cosine
            height = ground_at(f.ground, x, z, 0.0)
            ground, weights = ground + weight * height, weights + weight
            rise, square = rise + weight * height * away, square + weight * away * away
        ground /= weights
        keep[row, f.fit[0] + SAG] = min(SAG_SHARE * abs(rise) / square, MOST_SAG)
        at = f.memory[0] + LIFT_RATE
        height, keep[row, at] = settled(position[row, 1] / f.unit[0] - ground, keep[row, at], FOLLOW, dt)
        position[row, 1] = (ground + height) * f.unit[0]
