"""Clamps the angles about X, then Y, then Z (FAQ order, R = Rz·Ry·Rx) of sixteen rotations by their sines and
cosines: no angle is computed.

A turn is a pair of sine and cosine. With S = (X + Z) / 2 and D = (X − Z) / 2 a rotation x y z w has

    x + z = p sin S   w − y = p cos S   p = cos Y/2 − sin Y/2
    x − z = m sin D   w + y = m cos D   m = cos Y/2 + sin Y/2
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.clamp_kinds import TOLERANCE
from statwalk.maths.compiling import inlined
from statwalk.maths.simd.euler_lanes import LOCKED, ROUNDING, euler_excess, from_euler
from statwalk.maths.simd.lane_elementary import of
from statwalk.maths.simd.lane_functions import any_above, fused, least, most, size, where_below, with_sign
from statwalk.maths.simd.lane_turns import half_turn, where4_below
from statwalk.maths.simd.lane_vector import per_root
from statwalk.maths.simd.lanes import broadcast, spread

ZERO, HALF, ONE = np.float32(0), np.float32(0.5), np.float32(1)
OF_ROW = 16
"""numbers of a row of `ClampTable.sines`"""


@inlined
def clamp_angles(table: Any, row: int, q: Any) -> Any:
    """Returns how far the angles of rotations are beyond the limits of a row, and the rotations with the
    angles clamped. The excess is above 0 beyond the limits, about radians where it is small, and grows with
    the angle.

    Of the two triples of angles of a rotation the nearer counts; with Y at a quarter turn, the nearest of
    all.
    """
    at, lost = OF_ROW * row, of(LOCKED * LOCKED)
    s, d = (q[0] + q[2], q[3] - q[1]), (q[0] - q[2], q[3] + q[1])
    p_square, m_square = _square(s), _square(d)
    per_p, per_m = per_root(most(p_square, lost)), per_root(most(m_square, lost))
    p, m = p_square * per_p, m_square * per_m
    s, d = (s[0] * per_p, s[1] * per_p), (d[0] * per_m, d[1] * per_m)
    sine, cosine = (m_square - p_square) * broadcast(HALF), p * m
    x, z = _from_middle(table, at, _sum(s, d)), _from_middle(table, at + 8, _difference(s, d))
    y = _from_middle(table, at + 4, (sine, cosine))
    first = most(_excess(table, at, x), most(_excess(table, at + 4, y), _excess(table, at + 8, z)))
    other = first
    x2, z2, y2 = _opposite(x), _opposite(z), _from_middle(table, at + 4, (sine, -cosine))
    # the other triple is farther where X and Z are within a quarter turn of their middles
    if any_above(broadcast(ZERO), least(least(x[1], z[1]), spread(table.sines, at + 5))):
        other = most(_excess(table, at, x2), most(_excess(table, at + 4, y2), _excess(table, at + 8, z2)))
    known, clamped = least(p_square, m_square), q
    excess = least(first, other) - of(ROUNDING) * most(per_p, per_m)
    if any_above(lost, known):
        excess_of_lost, angles = euler_excess(q, _three(table, 6 * row), _three(table, 6 * row + 3))
        excess, clamped = where_below(known, lost, excess_of_lost, excess), from_euler(angles)
    if any_above(excess, of(TOLERANCE)):
        half_y = (m - p) * broadcast(HALF), (m + p) * broadcast(HALF)
        if any_above(first, other):
            x, y, z = _pick(other, first, x2, x), _pick(other, first, y2, y), _pick(other, first, z2, z)
            s = _pick(other, first, _opposite(s), s)
            half_y = _pick(other, first, (half_y[1], half_y[0]), half_y)
        half_y = _within(table, at + 4, y, half_y)
        of_known = _turned(s, d, _turn_back(table, at, x), half_y, _turn_back(table, at + 8, z))
        clamped = where4_below(known, lost, clamped, of_known)
    return excess, clamped


@inlined
def _turned(s: Any, d: Any, x_back: Any, half_y: Any, z_back: Any) -> Any:
    """The rotations of S, D and Y/2 after turns by half of what X and Z are turned back."""
    s, d = _sum(s, _sum(x_back, z_back)), _sum(d, _difference(x_back, z_back))
    half = broadcast(HALF)
    p, m = (half_y[1] - half_y[0]) * half, (half_y[1] + half_y[0]) * half
    return (
        fused(p, s[0], m * d[0]),
        fused(m, d[1], -(p * s[1])),
        fused(p, s[0], -(m * d[0])),
        fused(m, d[1], p * s[1]),
    )


@inlined
def _excess(table: Any, at: int, turn: Any) -> Any:
    """How far a turn from the middle is beyond half the range: the sine up to a quarter turn, 2 − the sine
    from there on.
    """
    sine, cosine = _beyond(table, at, turn)
    is_small = most(cosine, -spread(table.sines, at + 3))
    return where_below(is_small, broadcast(ZERO), of(2.0) - sine, sine)


@inlined
def _beyond(table: Any, at: int, turn: Any) -> Any:
    """The turn from the end of the range to a turn from the middle, in the direction of this."""
    return _difference((size(turn[0]), turn[1]), (spread(table.sines, at + 2), spread(table.sines, at + 3)))


@inlined
def _turn_back(table: Any, at: int, turn: Any) -> Any:
    """Half the turn that brings a turn from the middle back into the range."""
    zero, beyond = broadcast(ZERO), _beyond(table, at, turn)
    sine, cosine = half_turn(beyond[1], beyond[0])
    excess = _excess(table, at, turn)
    return where_below(zero, excess, with_sign(sine, -turn[0]), zero), where_below(
        zero, excess, cosine, broadcast(ONE)
    )


@inlined
def _within(table: Any, at: int, turn: Any, half: Any) -> Any:
    """Half the angle about Y, clamped; of the turn from the middle, and half the angle."""
    sine, cosine = spread(table.sines, at + 10), spread(table.sines, at + 11)
    end = _sum((spread(table.sines, at + 8), spread(table.sines, at + 9)), (with_sign(sine, turn[0]), cosine))
    zero, excess = broadcast(ZERO), _excess(table, at, turn)
    return where_below(zero, excess, end[0], half[0]), where_below(zero, excess, end[1], half[1])


@inlined
def _from_middle(table: Any, at: int, turn: Any) -> Any:
    return _difference(turn, (spread(table.sines, at), spread(table.sines, at + 1)))


@inlined
def _three(table: Any, at: int) -> Any:
    return spread(table.angles, at), spread(table.angles, at + 1), spread(table.angles, at + 2)


@inlined
def _square(a: Any) -> Any:
    return fused(a[0], a[0], a[1] * a[1])


@inlined
def _sum(a: Any, b: Any) -> Any:
    """The turn by a and b."""
    return fused(a[0], b[1], a[1] * b[0]), fused(a[1], b[1], -(a[0] * b[0]))


@inlined
def _difference(a: Any, b: Any) -> Any:
    """The turn by a, back by b."""
    return fused(a[0], b[1], -(a[1] * b[0])), fused(a[1], b[1], a[0] * b[0])


@inlined
def _opposite(turn: Any) -> Any:
    return -turn[0], -turn[1]


@inlined
def _pick(a: Any, b: Any, x: Any, y: Any) -> Any:
    """The turn x in lanes with a < b, else y."""
    return where_below(a, b, x[0], y[0]), where_below(a, b, x[1], y[1])
