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
SMALLEST = 1e-37
"""the least product of p² and m² whose root is taken"""
OF_ROW = 16
"""numbers of a row of `ClampTable.sines`"""


@inlined
def clamp_angles(table: Any, row: int, q: Any, per_length: Any) -> Any:
    """Returns how far the angles of rotations are beyond the limits of a row, and the rotations with the
    angles clamped, at unit length; q may have any length, `per_length` is 1 / that.

    The excess is above 0 beyond the limits, about radians where it is small, and grows with the angle.

    Of the two triples of angles of a rotation the nearer counts; with Y at a quarter turn, the nearest of
    all.
    """
    at, lost, per_square = OF_ROW * row, of(LOCKED * LOCKED), per_length * per_length
    s, d = (q[0] + q[2], q[3] - q[1]), (q[0] - q[2], q[3] + q[1])
    p_square, m_square = _square(s), _square(d)
    known, clamped = least(p_square, m_square) * per_square, q
    sine, cosine_square = (m_square - p_square) * broadcast(HALF), most(p_square * m_square, of(SMALLEST))
    per_cosine = per_root(cosine_square)
    cosine = cosine_square * per_cosine
    x, z = _scaled(_sum(s, d), per_cosine), _scaled(_difference(s, d), per_cosine)
    x, z = _from_middle(table, at, x), _from_middle(table, at + 8, z)
    sine, cosine = sine * per_square, cosine * per_square
    y, y2 = _from_middle(table, at + 4, (sine, cosine)), _from_middle(table, at + 4, (sine, -cosine))
    x_end, y_end, z_end = _beyond(table, at, x), _beyond(table, at + 4, y), _beyond(table, at + 8, z)
    first = _largest_excess(table, at, x_end, y_end, z_end)
    other, x2, z2 = first, _opposite(x), _opposite(z)
    # the other triple is farther where X and Z are within a quarter turn of their middles
    if any_above(broadcast(ZERO), least(least(x[1], z[1]), spread(table.sines, at + 5))):
        x2_end, y2_end = _beyond(table, at, x2), _beyond(table, at + 4, y2)
        other = _largest_excess(table, at, x2_end, y2_end, _beyond(table, at + 8, z2))
    excess = fused(per_cosine / per_square, -of(ROUNDING), least(first, other))
    if any_above(lost, known):
        q = q[0] * per_length, q[1] * per_length, q[2] * per_length, q[3] * per_length
        excess_of_lost, angles = euler_excess(q, _three(table, 6 * row), _three(table, 6 * row + 3))
        excess, clamped = where_below(known, lost, excess_of_lost, excess), from_euler(angles)
    if any_above(excess, of(TOLERANCE)):
        is_other = broadcast(ZERO)
        if any_above(first, other):
            x, y, z = _pick(other, first, x2, x), _pick(other, first, y2, y), _pick(other, first, z2, z)
            x_end, y_end, z_end = _beyond(table, at, x), _beyond(table, at + 4, y), _beyond(table, at + 8, z)
            is_other = where_below(other, first, broadcast(ONE), is_other)
        squares = p_square, m_square
        s, d = _within(table, at + 4, y, y_end, is_other, (s, d), squares, per_length)
        of_known = _turned(s, d, _turn_back(table, at, x, x_end), _turn_back(table, at + 8, z, z_end))
        clamped = where4_below(known, lost, clamped, of_known)
    return excess, clamped


@inlined
def _turned(s: Any, d: Any, x_back: Any, z_back: Any) -> Any:
    """The rotations of p S and m D after turns by half of what X and Z are turned back."""
    s, d, half = _sum(s, _sum(x_back, z_back)), _sum(d, _difference(x_back, z_back)), broadcast(HALF)
    return (s[0] + d[0]) * half, (d[1] - s[1]) * half, (s[0] - d[0]) * half, (d[1] + s[1]) * half


@inlined
def _within(
    table: Any, at: int, y: Any, y_end: Any, is_other: Any, turns: Any, squares: Any, per_length: Any
) -> Any:
    """p S and m D with Y clamped; of Y from the middle and beyond its end, p S and m D, p² and m². In lanes
    of the other triple p S are p and S with their signs changed.
    """
    middle = (spread(table.sines, at + 8), spread(table.sines, at + 9))
    end = _sum(middle, (with_sign(spread(table.sines, at + 10), y[0]), spread(table.sines, at + 11)))
    p, m = end[1] - end[0], end[1] + end[0]
    p = where_below(broadcast(ZERO), is_other, -p, p) * per_root(squares[0])
    m, excess, zero = m * per_root(squares[1]), _excess(table, at, y_end), broadcast(ZERO)
    p, m = where_below(zero, excess, p, per_length), where_below(zero, excess, m, per_length)
    return _scaled(turns[0], p), _scaled(turns[1], m)


@inlined
def _largest_excess(table: Any, at: int, x_end: Any, y_end: Any, z_end: Any) -> Any:
    y_excess, z_excess = _excess(table, at + 4, y_end), _excess(table, at + 8, z_end)
    return most(_excess(table, at, x_end), most(y_excess, z_excess))


@inlined
def _excess(table: Any, at: int, beyond: Any) -> Any:
    """How far a turn beyond the end of the range is: its sine up to a quarter turn, 2 − the sine from there
    on.
    """
    sine, cosine = beyond
    is_small = most(cosine, -spread(table.sines, at + 3))
    return where_below(is_small, broadcast(ZERO), of(2.0) - sine, sine)


@inlined
def _beyond(table: Any, at: int, turn: Any) -> Any:
    """The turn from the end of the range to a turn from the middle, in the direction of this."""
    return _difference((size(turn[0]), turn[1]), (spread(table.sines, at + 2), spread(table.sines, at + 3)))


@inlined
def _turn_back(table: Any, at: int, turn: Any, beyond: Any) -> Any:
    """Half the turn that brings a turn from the middle, so far beyond the end, back into the range."""
    zero, excess = broadcast(ZERO), _excess(table, at, beyond)
    sine, cosine = half_turn(beyond[1], beyond[0])
    return where_below(zero, excess, with_sign(sine, -turn[0]), zero), where_below(
        zero, excess, cosine, broadcast(ONE)
    )


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


@inlined
def _scaled(turn: Any, factor: Any) -> Any:
    return turn[0] * factor, turn[1] * factor
