"""Quaternions of sixteen actors at a time: tuples x y z w of lanes, unit length; vectors are tuples x y z
(`maths.quat` in lanes).
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import inlined
from statwalk.maths.simd.lane_elementary import cosine, of, sine
from statwalk.maths.simd.lane_functions import any_above, fused, root, size, where_below, with_sign
from statwalk.maths.simd.lanes import broadcast

HALF, ONE = np.float32(0.5), np.float32(1)
SMALLEST = np.float32(1e-36)
"""squared length below which a quaternion counts as zero"""
TURN_SQUARED = float(4 * np.pi**2)
"""the square of a whole turn"""


@inlined
def mul(a: Any, b: Any) -> Any:
    """Returns the product a b: the rotation b first, then a."""
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return (
        fused(-az, by, fused(ay, bz, fused(ax, bw, aw * bx))),
        fused(az, bx, fused(-ax, bz, fused(ay, bw, aw * by))),
        fused(ay, -bx, fused(ax, by, fused(az, bw, aw * bz))),
        fused(-az, bz, fused(-ay, by, fused(-ax, bx, aw * bw))),
    )


@inlined
def conjugate(q: Any) -> Any:
    """Returns the inverse rotation."""
    return -q[0], -q[1], -q[2], q[3]


@inlined
def _dot(a: Any, b: Any) -> Any:
    return fused(a[3], b[3], fused(a[2], b[2], fused(a[1], b[1], a[0] * b[0])))


@inlined
def vector_square(v: Any) -> Any:
    """Returns |v|² of a vector."""
    return fused(v[2], v[2], fused(v[1], v[1], v[0] * v[0]))


@inlined
def scaled(v: Any, factor: Any) -> Any:
    """Returns a vector times a number."""
    return v[0] * factor, v[1] * factor, v[2] * factor


@inlined
def plus(a: Any, b: Any) -> Any:
    """Returns a + b of vectors."""
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


@inlined
def minus(a: Any, b: Any) -> Any:
    """Returns a - b of vectors."""
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


@inlined
def rotated(q: Any, v: Any) -> Any:
    """Returns the vector v rotated by q: v + 2w(u x v) + 2u x (u x v)."""
    x, y, z, w = q
    twice_x, twice_y, twice_z = x + x, y + y, z + z  # q is often known before v: then nothing waits for it
    across = (
        fused(twice_y, v[2], -(twice_z * v[1])),
        fused(twice_z, v[0], -(twice_x * v[2])),
        fused(twice_x, v[1], -(twice_y * v[0])),
    )
    again = (
        fused(y, across[2], -(z * across[1])),
        fused(z, across[0], -(x * across[2])),
        fused(x, across[1], -(y * across[0])),
    )
    return (
        fused(across[0], w, v[0]) + again[0],
        fused(across[1], w, v[1]) + again[1],
        fused(across[2], w, v[2]) + again[2],
    )


@inlined
def rotated_back(q: Any, v: Any) -> Any:
    """Returns the vector v rotated by the inverse of q."""
    return rotated((q[0], q[1], q[2], -q[3]), v)  # as a rotation, -q* is q*


@inlined
def normalized(q: Any) -> Any:
    """Returns q at unit length; zero becomes the identity."""
    square, one = _dot(q, q), broadcast(ONE)
    is_zero = broadcast(SMALLEST)
    factor = one / root(where_below(square, is_zero, one, square))
    w = where_below(square, is_zero, one, q[3] * factor)
    return q[0] * factor, q[1] * factor, q[2] * factor, w


@inlined
def renormalized(q: Any) -> Any:
    """Returns q, whose length is 1 but for rounding, at unit length: one step of Newton's method."""
    factor = fused(_dot(q, q), of(-0.5), of(1.5))
    return q[0] * factor, q[1] * factor, q[2] * factor, q[3] * factor


@inlined
def _half_sine(square: Any) -> Any:
    """sin(t/2) / t of t², t up to a whole turn."""
    value = fused(square, of(1.661755234130506e-14), of(-1.2074615078469135e-11))
    value = fused(square, value, of(5.378095693708522e-09))
    value = fused(square, value, of(-1.550041725721338e-06))
    value = fused(square, value, of(0.0002604162904580997))
    value = fused(square, value, of(-0.02083333240857988))
    return fused(square, value, of(0.5))


@inlined
def _half_cosine(square: Any) -> Any:
    """cos(t/2) of t², t up to a whole turn."""
    value = fused(square, of(-5.934184807566256e-16), of(5.030180270607981e-13))
    value = fused(square, value, of(-2.688945957152493e-10))
    value = fused(square, value, of(9.687716393227319e-08))
    value = fused(square, value, of(-2.170134853891383e-05))
    value = fused(square, value, of(0.0026041664682931887))
    value = fused(square, value, of(-0.12499999962811985))
    return fused(square, value, of(1.0))


@inlined
def from_rotation_vector(v: Any) -> Any:
    """Returns the rotation about v by |v| radians (exponential map)."""
    square, turn = vector_square(v), of(TURN_SQUARED)
    part, w = _half_sine(square), _half_cosine(square)
    if any_above(square, turn):  # more than a whole turn: lanes within a turn keep their values
        length = root(square)
        half = length * broadcast(HALF)
        part, w = (
            where_below(turn, square, sine(half) / length, part),
            where_below(turn, square, cosine(half), w),
        )
    return v[0] * part, v[1] * part, v[2] * part, w


@inlined
def to_rotation_vector(q: Any) -> Any:
    """Returns axis times angle, radians, along the shorter arc: at most pi long (logarithm)."""
    lack = broadcast(ONE) - size(q[3])
    value = fused(
        lack, of(0.01498555922894813), of(-0.051987604473382826)
    )  # angle / sin(angle/2) of 1 - cos(angle/2)
    value = fused(lack, value, of(0.09129804010165496))
    value = fused(lack, value, of(-0.08028290153943815))
    value = fused(lack, value, of(0.060984439533804786))
    value = fused(lack, value, of(0.004477768497957512))
    value = fused(lack, value, of(0.05501478359989406))
    value = fused(lack, value, of(0.11373341376919525))
    value = fused(lack, value, of(0.2667034270260644))
    value = fused(lack, value, of(0.6666657182057077))
    value = fused(lack, value, of(2.0))
    return scaled(q, with_sign(value, q[3]))


@inlined
def _sine_short(square: Any) -> Any:
    """sin(x) / x of the square of x, |x| up to pi/2, to seven digits (`quat._SINE`)."""
    value = fused(square, of(2.605092957769762e-06), of(-0.0001980901106705217))
    value = fused(square, value, of(0.008333050086778936))
    value = fused(square, value, of(-0.16666657944392216))
    return fused(square, value, of(1.0))


@inlined
def arc_weights(alike: Any, f: Any) -> Any:
    """Returns sin((1-f)t)/sin t and sin(ft)/sin t for cos t = `alike` in 0...1: polynomials in t², smooth at
    t = 0 (`quat._arc_weights`).
    """
    one, half = broadcast(ONE), broadcast(HALF)
    lack = one - root(fused(half, alike, half))
    value = fused(lack, of(0.05443013518985956), of(0.11052687316026907))
    value = fused(lack, value, of(0.35595968596575156))
    value = fused(lack, value, of(1.3333183519785923))
    square = lack * fused(lack, value, of(8.000000087973428))
    rest = one - f
    whole = one / _sine_short(square)
    return rest * _sine_short(rest * rest * square) * whole, f * _sine_short(f * f * square) * whole


@inlined
def slerp(a: Any, b: Any, f: Any) -> Any:
    """Interpolates from a (f = 0) to b (f = 1) along the shorter arc at constant angular speed; f
    in 0...1.
    """
    cosine_of_arc = _dot(a, b)
    first, second = arc_weights(size(cosine_of_arc), f)
    second = with_sign(second, cosine_of_arc)
    return (
        fused(b[0], second, a[0] * first),
        fused(b[1], second, a[1] * first),
        fused(b[2], second, a[2] * first),
        fused(b[3], second, a[3] * first),
    )
