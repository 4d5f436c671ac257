"""Clamps rotations and translations of sixteen actors to the limits of one joint (`maths.clamp` in lanes).

`table` is a ClampTable, `row` a row of it. Lanes inside the limits keep their bits.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.clamp_kinds import EULER, FREE, HINGE, RANGE, TOLERANCE
from statwalk.maths.compiling import inlined
from statwalk.maths.simd.euler_clamp import clamp_angles
from statwalk.maths.simd.lane_elementary import angle, of, sine_cosine
from statwalk.maths.simd.lane_functions import (
    any_above,
    fused,
    least,
    most,
    root,
    size,
    turned,
    where_below,
    with_sign,
)
from statwalk.maths.simd.lane_quat import conjugate, minus, mul, plus, renormalized, rotated, rotated_back
from statwalk.maths.simd.lanes import broadcast, spread
from statwalk.maths.simd.pose_lanes import either3, either4

ZERO, ONE = np.float32(0), np.float32(1)
SMALLEST_SINE = 1e-30
STEPS = 9
"""of Newton's method, to the nearest point of an ellipse"""


@inlined
def spread4(values: Any, at: int) -> Any:
    """Returns four numbers of an array, each in all lanes."""
    return spread(values, at), spread(values, at + 1), spread(values, at + 2), spread(values, at + 3)


@inlined
def spread3(values: Any, at: int) -> Any:
    """Returns three numbers of an array, each in all lanes."""
    return spread(values, at), spread(values, at + 1), spread(values, at + 2)


@inlined
def clamp_rotation(table: Any, row: int, q: Any, per_length: Any) -> Any:
    """Returns the local rotation q (x y z w, rest pose included) of the row's joint, clamped, at unit length;
    q may have any length, `per_length` is 1 / that.

    Roots and divisions take long: those of the clamp do not wait for those of `per_length`.
    """
    unit = q[0] * per_length, q[1] * per_length, q[2] * per_length, q[3] * per_length
    if table.kind[row] == FREE:
        return unit
    if table.kind[row] == EULER:
        excess, clamped = clamp_angles(table, row, _relative(table, row, q), per_length)
        if not any_above(excess, of(TOLERANCE)):
            return unit
        clamped = same_sign(renormalized(_back(table, row, clamped)), unit)
    else:
        excess, clamped = clamp_swing_twist(table, row, _relative(table, row, q), per_length)
        if not any_above(excess, of(TOLERANCE)):
            return unit
        clamped = _back(table, row, clamped)
    return either4(excess - of(TOLERANCE), clamped, unit)


@inlined
def _relative(table: Any, row: int, q: Any) -> Any:
    """A local rotation relative to the rest pose, in the frame of the row's joint."""
    if table.into[row, 3] != ONE:
        q = mul(spread4(table.into, 4 * row), q)
    if table.frame[row, 3] != ONE:
        q = mul(q, spread4(table.frame, 4 * row))
    return q


@inlined
def _back(table: Any, row: int, relative: Any) -> Any:
    """The local rotation of one that is relative to the rest pose."""
    if table.into[row, 3] != ONE:
        relative = mul(conjugate(spread4(table.into, 4 * row)), relative)
    if table.frame[row, 3] != ONE:
        relative = mul(relative, conjugate(spread4(table.frame, 4 * row)))
    return relative


@inlined
def clamp_translation(table: Any, row: int, t: Any) -> Any:
    """Returns the local translation t (x y z, rest pose included) of the row's joint, clamped."""
    if not table.has_slide[row]:
        return t
    into, rest = spread4(table.into, 4 * row), spread3(table.rest, 3 * row)
    way = rotated(into, minus(t, rest))
    low, high = spread3(table.slide, 6 * row), spread3(table.slide, 6 * row + 3)
    within = (
        between(way[0], low[0], high[0]),
        between(way[1], low[1], high[1]),
        between(way[2], low[2], high[2]),
    )
    lack = minus(way, within)
    excess = most(size(lack[0]), most(size(lack[1]), size(lack[2])))
    if not any_above(excess, of(TOLERANCE)):
        return t
    return either3(excess - of(TOLERANCE), plus(rest, rotated_back(into, within)), t)


@inlined
def same_sign(q: Any, to: Any) -> Any:
    """Returns q or -q, the same rotation, whichever is nearer to another."""
    sign = fused(q[3], to[3], fused(q[2], to[2], fused(q[1], to[1], q[0] * to[0])))
    return turned(q[0], sign), turned(q[1], sign), turned(q[2], sign), turned(q[3], sign)


@inlined
def between(x: Any, low: Any, high: Any) -> Any:
    """Returns x, at least low and at most high."""
    return least(most(x, low), high)


@inlined
def clamp_swing_twist(table: Any, row: int, q: Any, per_length: Any) -> Any:
    """Returns the excess in radians, and the rotation with swing (about axes in the XZ plane, last)
    and twist (about Y, first) clamped; q may have any length, `per_length` is 1 / that.
    """
    x, y, z, w = q
    one, zero, nothing = broadcast(ONE), broadcast(ZERO), of(1e-36)
    swing_sine, swing_cosine = root(fused(x, x, z * z)), root(fused(w, w, y * y))  # times the length
    factor = one / most(swing_cosine, nothing)
    sine, cosine = y * factor, w * factor
    cosine_of_unit, turned_over = swing_cosine * per_length, of(3e-7)  # swing by half a turn: no twist
    sine = where_below(cosine_of_unit, turned_over, zero, sine)
    cosine = where_below(cosine_of_unit, turned_over, one, cosine)
    swing = fused(x, cosine, z * sine), fused(z, cosine, -(x * sine)), swing_sine, swing_cosine
    swing_excess, swing_x, swing_z, swing_w = _clamp_swing(table, row, swing, per_length)
    twist_excess, sine, cosine = _clamp_twist(table, row, sine, cosine)
    whole = (
        fused(swing_x, cosine, -(swing_z * sine)),
        swing_w * sine,
        fused(swing_z, cosine, swing_x * sine),
        swing_w * cosine,
    )
    return most(swing_excess, twist_excess), whole


@inlined
def _clamp_twist(table: Any, row: int, sine: Any, cosine: Any) -> Any:
    """The excess of a twist, and sine and cosine of half the clamped twist."""
    middle_sine, middle_cosine, end_sine, end_cosine = spread4(table.twist, 4 * row)
    from_middle = fused(sine, middle_cosine, -(cosine * middle_sine))
    along = fused(cosine, middle_cosine, sine * middle_sine)
    half = fused(size(from_middle), end_cosine, -(size(along) * end_sine))  # the sine of half the excess
    excess = half * of(2.0)
    end_sine, end_cosine = with_sign(end_sine, from_middle), with_sign(end_cosine, along)
    inside = of(TOLERANCE)
    return (
        excess,
        where_below(inside, excess, fused(end_sine, middle_cosine, end_cosine * middle_sine), sine),
        where_below(inside, excess, fused(end_cosine, middle_cosine, -(end_sine * middle_sine)), cosine),
    )


@inlined
def _clamp_swing(table: Any, row: int, swing: Any, per_length: Any) -> Any:
    """The excess of a swing, and the clamped swing's quaternion x z w at unit length; `swing` is of any
    length: x z, √(x² + z²) and w.
    """
    if table.round[row, 1] > ZERO:
        return _clamp_round(table, row, swing, per_length)
    x, z, sine, w = swing[0] * per_length, swing[1] * per_length, swing[2] * per_length, swing[3] * per_length
    if table.kind[row] == HINGE:
        zero = broadcast(ZERO)
        return sine * of(2.0), zero, zero, broadcast(ONE)
    tiny = of(1e-7)
    factor = where_below(sine, tiny, of(2.0), angle(sine, w) * of(2.0) / where_below(sine, tiny, tiny, sine))
    u, v = x * factor, z * factor
    excess, new_u, new_v = _nearest_swing(table, row, u, v)
    if not any_above(excess, of(TOLERANCE)):
        return excess, x, z, w
    turn = root(fused(new_u, new_u, new_v * new_v))
    half_sine, half_cosine = sine_cosine(turn * of(0.5))
    factor = where_below(turn, tiny, of(0.5), half_sine / where_below(turn, tiny, tiny, turn))
    inside = of(TOLERANCE)
    return (
        excess,
        where_below(inside, excess, new_u * factor, x),
        where_below(inside, excess, new_v * factor, z),
        where_below(inside, excess, half_cosine, w),
    )


@inlined
def _clamp_round(table: Any, row: int, swing: Any, per_length: Any) -> Any:
    """`_clamp_swing` of a cone as wide along X as along Z: without angles. The excess is twice the sine of
    half the angle.
    """
    x, z, sine, w = swing
    end_sine, end_cosine = spread(table.round, 2 * row), spread(table.round, 2 * row + 1)
    excess = fused(sine, end_cosine, -(w * end_sine)) * per_length
    inside = of(0.5 * TOLERANCE)
    factor = where_below(inside, excess, end_sine / most(sine, of(SMALLEST_SINE)), per_length)
    return excess * of(2.0), x * factor, z * factor, where_below(inside, excess, end_cosine, w * per_length)


@inlined
def _nearest_swing(table: Any, row: int, u: Any, v: Any) -> Any:
    """The distance of a swing's rotation vector from the limits, and the nearest vector inside them."""
    low_u, low_v, high_u, high_v = spread4(table.swing, 4 * row)
    if table.kind[row] == RANGE:
        new_u, new_v = between(u, low_u, high_u), between(v, low_v, high_v)
        return most(size(u - new_u), size(v - new_v)), new_u, new_v
    zero, one = broadcast(ZERO), broadcast(ONE)
    a, b = where_below(u, zero, low_u, high_u), where_below(v, zero, low_v, high_v)
    is_outside = fused(u / a, u / a, v / b * (v / b))
    if not any_above(is_outside, one):
        return zero, u, v
    new_u, new_v = _nearest_of_ellipse(size(u), size(v), a, b)
    new_u, new_v = with_sign(new_u, u), with_sign(new_v, v)
    far = root(fused(u - new_u, u - new_u, (v - new_v) * (v - new_v)))
    return where_below(one, is_outside, far, zero), new_u, new_v


@inlined
def _nearest_of_ellipse(x: Any, y: Any, a: Any, b: Any) -> Any:
    """The point of the ellipse with half axes a and b nearest to a point (x, y) outside it, x and y at least
    0 (Eberly, "Distance from a point to an ellipse": Newton's method from below the root).
    """
    smaller = least(a, b)
    beyond_a, beyond_b = a * a - smaller * smaller, b * b - smaller * smaller
    ax, by = a * x, b * y
    t = most(smaller * smaller, most(ax - beyond_a, by - beyond_b))
    for _ in range(STEPS):
        to_a, to_b = of(1.0) / (t + beyond_a), of(1.0) / (t + beyond_b)
        p, q = ax * to_a, by * to_b
        slope = fused(p * p, to_a, q * q * to_b)
        t = t + of(0.5) * (fused(p, p, q * q) - of(1.0)) / most(slope, of(1e-30))
    return a * (ax / (t + beyond_a)), b * (by / (t + beyond_b))
