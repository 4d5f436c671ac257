"""Evaluates sixteen channels of a clip between two edges, compiled: each kind of segment from one row of its
group.

`segments` defines the kinds, `lane_rows` makes the rows; `part` is the fraction of the segment that has
passed.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import inlined
from statwalk.maths.quat import SINE
from statwalk.maths.simd.lane_functions import fused, root
from statwalk.maths.simd.lanes import LANES, broadcast, load
from statwalk.maths.simd.pose_lanes import load3, load4, store4
from statwalk.maths.simd.transpose import chosen

S0, S1, S2, S3, S4 = (np.float32(value) for value in SINE["f"])
QUARTER, HALF, ONE, THREE, SIXTH = (np.float32(value) for value in (0.25, 0.5, 1, 3, 1 / 6))


@inlined
def fraction(values: Any, row: int, since: Any) -> Any:
    """Returns the fraction of each lane's own segment, `since` seconds after the edge; the row begins with
    the fraction at the edge, and its rate.
    """
    return fused(since, load(values, row + LANES), load(values, row))


@inlined
def _sine_over_angle(square: Any) -> Any:
    """sin x / x for x² in 0…(π/2)²."""
    high = fused(fused(broadcast(S4), square, broadcast(S3)), square, broadcast(S2))
    return fused(fused(high, square, broadcast(S1)), square, broadcast(S0))


@inlined
def line(values: Any, row: int, part: Any) -> Any:
    """Returns start + part · difference."""
    return fused(part, load(values, row + LANES), load(values, row))


@inlined
def cubic(values: Any, row: int, part: Any, stride: int) -> Any:
    """Returns a cubic by Horner's rule: four coefficients `stride` apart."""
    high = fused(part, load(values, row + 3 * stride), load(values, row + 2 * stride))
    return fused(part, fused(part, high, load(values, row + stride)), load(values, row))


@inlined
def arc(values: Any, row: int, part: Any) -> Any:
    """Returns the slerp, from θ² and both quaternions times θ / sin θ."""
    square, left = load(values, row), broadcast(ONE) - part
    first = left * _sine_over_angle(left * left * square)
    second = part * _sine_over_angle(part * part * square)
    start, end = load4(values, row + LANES), load4(values, row + 5 * LANES)
    return (
        fused(end[0], second, start[0] * first),
        fused(end[1], second, start[1] * first),
        fused(end[2], second, start[2] * first),
        fused(end[3], second, start[3] * first),
    )


@inlined
def unit(x: Any, y: Any, z: Any, w: Any) -> Any:
    """Returns quaternions at unit length; zero becomes the identity."""
    size, one = root(fused(w, w, fused(z, z, fused(y, y, x * x)))), broadcast(ONE)
    whole = chosen(size, size, one)
    return x / whole, y / whole, z / whole, chosen(size, w / whole, one)


@inlined
def cubic_turn(values: Any, row: int, part: Any) -> Any:
    """Returns the cubic of the four components, at unit length."""
    return unit(
        cubic(values, row, part, 4 * LANES),
        cubic(values, row + LANES, part, 4 * LANES),
        cubic(values, row + 2 * LANES, part, 4 * LANES),
        cubic(values, row + 3 * LANES, part, 4 * LANES),
    )


@inlined
def product(a: Any, b: Any) -> Any:
    """Returns the rotation b first, then a."""
    x, y, z, w = a
    u, v, t, s = b
    return (
        fused(w, u, fused(x, s, fused(y, t, -(z * v)))),
        fused(w, v, fused(y, s, fused(z, u, -(x * t)))),
        fused(w, t, fused(z, s, fused(x, v, -(y * u)))),
        fused(w, s, -fused(x, u, fused(y, v, z * t))),
    )


@inlined
def turn(values: Any, row: int, weight: Any) -> Any:
    """Returns the rotation by `weight` times a rotation vector: sine and cosine of half its length are
    polynomials of the square.
    """
    x, y, z = load3(values, row)
    x, y, z = x * weight, y * weight, z * weight
    square = fused(z, z, fused(y, y, x * x)) * broadcast(QUARTER)
    half, small = broadcast(HALF) * _sine_over_angle(square), _sine_over_angle(square * broadcast(QUARTER))
    return x * half, y * half, z * half, broadcast(ONE) - broadcast(HALF) * square * small * small


@inlined
def spline_turn(values: Any, row: int, part: Any) -> Any:
    """Returns the cumulative quaternion B-spline: its first control, then the turns to the other three."""
    left, sixth = broadcast(ONE) - part, broadcast(SIXTH)
    third = part * part * part * sixth
    first = broadcast(ONE) - left * left * left * sixth
    # the second and the last weight of the basis: 3 (f + f² − f³) + 1, f³
    second = third + fused(broadcast(THREE), fused(part * part, left, part), broadcast(ONE)) * sixth
    turned = product(load4(values, row), turn(values, row + 4 * LANES, first))
    turned = product(turned, turn(values, row + 7 * LANES, second))
    x, y, z, w = product(turned, turn(values, row + 10 * LANES, third))
    return unit(x, y, z, w)


@inlined
def rational(values: Any, row: int, part: Any) -> Any:
    """Returns one cubic divided by another."""
    return cubic(values, row, part, LANES) / cubic(values, row + 4 * LANES, part, LANES)


@inlined
def rational_turn(values: Any, row: int, part: Any) -> Any:
    """Returns the cumulative quaternion NURBS: its first control, then the turns to the other three."""
    whole = broadcast(ONE) / cubic(values, row + 13 * LANES, part, LANES)
    first = cubic(values, row + 17 * LANES, part, LANES) * whole
    second = cubic(values, row + 21 * LANES, part, LANES) * whole
    third = cubic(values, row + 25 * LANES, part, LANES) * whole
    turned = product(load4(values, row), turn(values, row + 4 * LANES, first))
    turned = product(turned, turn(values, row + 7 * LANES, second))
    x, y, z, w = product(turned, turn(values, row + 10 * LANES, third))
    return unit(x, y, z, w)


@inlined
def put_some(out: Any, at: int, turned: Any, mask: Any) -> None:
    """Writes sixteen rotations into a packed row, in the lanes whose mask is not 0."""
    x, y, z, w = turned
    a, b, c, d = load4(out, at)
    store4(out, at, (chosen(mask, x, a), chosen(mask, y, b), chosen(mask, z, c), chosen(mask, w, d)))
