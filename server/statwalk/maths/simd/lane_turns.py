"""Rotations of sixteen actors at a time that take directions to directions (`maths.quat` in lanes)."""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import inlined
from statwalk.maths.simd.lane_functions import any_above, fused, root, where_below
from statwalk.maths.simd.lane_quat import normalized, plus, vector_square
from statwalk.maths.simd.lane_vector import cross, dot, perpendicular
from statwalk.maths.simd.lanes import broadcast

ZERO, HALF, ONE = np.float32(0), np.float32(0.5), np.float32(1)
OPPOSITE = np.float32(1e-6)
"""1 + the cosine of the angle from which directions count as opposite: 0.08 degrees less than 180"""
SMALLEST = np.float32(1e-30)


@inlined
def where4_below(a: Any, b: Any, x: Any, y: Any) -> Any:
    """Returns the quaternion x in lanes with a < b, else y."""
    return (
        where_below(a, b, x[0], y[0]),
        where_below(a, b, x[1], y[1]),
        where_below(a, b, x[2], y[2]),
        where_below(a, b, x[3], y[3]),
    )


@inlined
def half_way(u: Any, v: Any) -> Any:
    """Returns the shortest rotation from the direction of u to that of v, and the square of its length, which
    is not 1; vectors of any length.

    Opposite directions rotate about any axis at right angles; a zero vector gives the identity.
    """
    sizes = root(vector_square(u) * vector_square(v))
    half = cross(u, v)
    w = sizes + dot(u, v)
    is_opposite = sizes * broadcast(OPPOSITE)
    if any_above(is_opposite, w):
        around = perpendicular(u)
        half = (
            where_below(w, is_opposite, around[0], half[0]),
            where_below(w, is_opposite, around[1], half[1]),
            where_below(w, is_opposite, around[2], half[2]),
        )
        w = where_below(w, is_opposite, broadcast(ZERO), w)
    square = fused(w, w, vector_square(half))
    one, smallest = broadcast(ONE), broadcast(SMALLEST)
    w = where_below(square, smallest, one, w)
    return (half[0], half[1], half[2], w), where_below(square, smallest, one, square)


@inlined
def between(u: Any, v: Any) -> Any:
    """Returns `half_way` at unit length."""
    turn, square = half_way(u, v)
    factor = broadcast(ONE) / root(square)
    return turn[0] * factor, turn[1] * factor, turn[2] * factor, turn[3] * factor


@inlined
def between_frames(old_x: Any, old_z: Any, new_x: Any, new_z: Any) -> Any:
    """Returns the rotation that takes the unit vector old_x to new_x and old_z to new_z, each pair at right
    angles.
    """
    old_y, new_y, one = cross(old_z, old_x), cross(new_z, new_x), broadcast(ONE)
    turned = plus(plus(cross(old_x, new_x), cross(old_y, new_y)), cross(old_z, new_z))
    w = one + dot(old_x, new_x) + dot(old_y, new_y) + dot(old_z, new_z)
    q = turned[0], turned[1], turned[2], w
    if any_above(broadcast(HALF), w):  # more than 138 degrees: w is small, and rounding counts
        rows = (
            _row(new_x[0], new_y[0], new_z[0], old_x, old_y, old_z),
            _row(new_x[1], new_y[1], new_z[1], old_x, old_y, old_z),
            _row(new_x[2], new_y[2], new_z[2], old_x, old_y, old_z),
        )
        q = where4_below(w, broadcast(HALF), _from_matrix(rows), q)
    return normalized(q)


@inlined
def _row(x: Any, y: Any, z: Any, old_x: Any, old_y: Any, old_z: Any) -> Any:
    return (
        fused(z, old_z[0], fused(y, old_y[0], x * old_x[0])),
        fused(z, old_z[1], fused(y, old_y[1], x * old_x[1])),
        fused(z, old_z[2], fused(y, old_y[2], x * old_x[2])),
    )


@inlined
def _from_matrix(m: Any) -> Any:
    """A quaternion of a rotation matrix, of any length, by the largest of the four components (Shepperd)."""
    one, (xx, yy, zz) = broadcast(ONE), (m[0][0], m[1][1], m[2][2])
    xy, xz, yz = m[0][1] + m[1][0], m[0][2] + m[2][0], m[1][2] + m[2][1]
    xw, yw, zw = m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]
    x, y = one + xx - yy - zz, one - xx + yy - zz
    z, w = one - xx - yy + zz, one + xx + yy + zz
    chosen, most = (xw, yw, zw, w), w
    chosen, most = where4_below(most, x, (x, xy, xz, xw), chosen), where_below(most, x, x, most)
    chosen, most = where4_below(most, y, (xy, y, yz, yw), chosen), where_below(most, y, y, most)
    return where4_below(most, z, (xz, yz, z, zw), chosen)


@inlined
def half_turn(cosine: Any, sine: Any) -> Any:
    """Returns sine and cosine of half an angle, of its cosine and sine."""
    zero, one = broadcast(ZERO), broadcast(ONE)
    half_sine = where_below(cosine, zero, one - cosine, sine)
    half_cosine = where_below(cosine, zero, sine, one + cosine)
    factor = one / root(half_sine * half_sine + half_cosine * half_cosine)
    return half_sine * factor, half_cosine * factor
