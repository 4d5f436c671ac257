"""Clamps the transforms of sixteen actors' joints to limits, also of joints whose rotation and translation
depend on each other: helical and planar joints.

`table` is a ClampTable, `row` a row of it. Lanes inside the limits keep their bits.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.clamp_kinds import TOLERANCE
from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.simd.clamp_lanes import (
    between,
    clamp_rotation,
    clamp_swing_twist,
    clamp_translation,
    same_sign,
    spread3,
    spread4,
)
from statwalk.maths.simd.euler_lanes import around, whole_turns
from statwalk.maths.simd.lane_elementary import of, sine_cosine
from statwalk.maths.simd.lane_functions import any_above, fused, most, root, size, turned, with_sign
from statwalk.maths.simd.lane_quat import conjugate, minus, mul, plus, renormalized, rotated
from statwalk.maths.simd.lanes import broadcast
from statwalk.maths.simd.pose_lanes import either3, either4

ZERO, ONE = np.float32(0), np.float32(1)
FLATTEST = 1e-3
"""cosine of the turn of a PRP joint below which its slides count as parallel"""


@called
def clamp_joint(table: Any, row: int, t: Any, q: Any) -> Any:
    """Returns the local translation t and rotation q (x y z, x y z w) of the row's joint, clamped; the two of
    helical and planar joints depend on each other.
    """
    if table.screw[row, 0] == 0.0 and not table.turning[row, 1]:
        return clamp_translation(table, row, t), clamp_rotation(table, row, q, broadcast(ONE))
    into, frame, rest = (
        spread4(table.into, 4 * row),
        spread4(table.frame, 4 * row),
        spread3(table.rest, 3 * row),
    )
    way, relative = rotated(into, minus(t, rest)), mul(mul(into, q), frame)
    if table.screw[row, 0] != 0.0:
        excess, within, turn = _clamp_screw(table, row, way, relative)
    else:
        excess, within, turn = _clamp_planar(table, row, way, relative)
    if not any_above(excess, of(TOLERANCE)):
        return t, q
    outside, out_of = excess - of(TOLERANCE), conjugate(into)
    back = same_sign(renormalized(mul(mul(out_of, turn), conjugate(frame))), q)
    return either3(outside, plus(rest, rotated(out_of, within)), t), either4(outside, back, q)


@inlined
def _clamp_screw(table: Any, row: int, way: Any, q: Any) -> Any:
    """The excess of a helical joint, and its nearest translation and rotation: the rotation counts, and the
    translation tells whole turns.
    """
    pitch, low, high = spread3(table.screw, 3 * row)
    zero = broadcast(ZERO)
    twist = around(turned(q[1], q[3]), size(q[3])) * of(2.0)
    theta = twist + whole_turns(way[1] / pitch - twist)
    within = between(theta, low, high)
    sine, cosine = sine_cosine(within * of(0.5))
    target = pitch * within
    lack = most(size(way[0]), most(size(way[1] - target), size(way[2])))
    swing = root(fused(q[0], q[0], q[2] * q[2])) * of(2.0)
    excess = most(most(lack, swing), size(theta - within))
    return excess, (zero, target, zero), (zero, sine, zero, cosine)


@inlined
def _clamp_planar(table: Any, row: int, way: Any, q: Any) -> Any:
    """The excess of a planar joint one or both of whose slides turn with it, and its nearest translation and
    rotation.
    """
    turn_excess, turn = clamp_swing_twist(table, row, q, broadcast(ONE))
    sine, cosine = of(2.0) * turn[1] * turn[3], fused(turn[3], turn[3], -(turn[1] * turn[1]))
    low, high = spread3(table.slide, 6 * row), spread3(table.slide, 6 * row + 3)
    if table.turning[row, 0]:  # RPP: both slides have turned
        x = between(fused(way[0], cosine, -(way[2] * sine)), low[0], high[0])
        z = between(fused(way[0], sine, way[2] * cosine), low[2], high[2])
        within = fused(x, cosine, z * sine), broadcast(ZERO), fused(z, cosine, -(x * sine))
    else:  # PRP: the slide along Z has turned
        z = between(way[2] / with_sign(most(size(cosine), of(FLATTEST)), cosine), low[2], high[2])
        x = between(way[0] - z * sine, low[0], high[0])
        within = fused(z, sine, x), broadcast(ZERO), z * cosine
    lack = minus(way, within)
    far = most(size(lack[0]), most(size(lack[1]), size(lack[2])))
    return most(far, turn_excess), within, turn
