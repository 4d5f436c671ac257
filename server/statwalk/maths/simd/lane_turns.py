"""Rotations of sixteen actors at a time that take directions to directions (`maths.quat` in lanes)."""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import inlined
from statwalk.maths.simd.lane_functions import any_above, fused, root, size, where_below
from statwalk.maths.simd.lane_quat import vector_square
from statwalk.maths.simd.lane_vector import cross, dot, perpendicular
from statwalk.maths.simd.lanes import broadcast

ZERO, ONE = np.float32(0), np.float32(1)
WIDE = np.float32(0.3)
"""1 + the cosine of the angle from which a turn between frames is found from a matrix: 134 degrees"""
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
def half_way(u: Any, v: Any, sizes: Any) -> Any:
    """Returns the shortest rotation from the direction of u to that of v, and the square of its length, which
    is not 1; vectors of any length; `sizes` is |u|·|v|.

    Opposite directions rotate about any axis at right angles; a zero vector gives the identity.
    """
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
    turn, square = half_way(u, v, root(vector_square(u) * vector_square(v)))
    factor = broadcast(ONE) / root(square)
    return turn[0] * factor, turn[1] * factor, turn[2] * factor, turn[3] * factor


@inlined
def between_frames(old_x: Any, old_z: Any, new_x: Any, new_z: Any) -> Any:
    """Returns the rotation that takes the unit vector old_x to new_x and old_z to new_z, each pair at right
    angles.
    """
    new_y, above, wide = cross(new_z, new_x), broadcast(ONE) + dot(old_x, new_x), broadcast(WIDE)
    # the shortest turn from x to x, then a turn about x: of its angle, cosine and sine times `above`
    aside = dot(new_x, old_z)
    cosine = above * dot(old_z, new_z) - aside * dot(old_x, new_z)
    sine = above * dot(old_z, new_y) - aside * dot(old_x, new_y)
    larger = above + size(cosine)
    half_sine = where_below(cosine, broadcast(ZERO), larger, sine)
    half_cosine = where_below(cosine, broadcast(ZERO), sine, larger)
    axis = cross(old_x, new_x)
    q = (
        fused(half_cosine, axis[0], half_sine * (old_x[0] + new_x[0])),
        fused(half_cosine, axis[1], half_sine * (old_x[1] + new_x[1])),
        fused(half_cosine, axis[2], half_sine * (old_x[2] + new_x[2])),
        half_cosine * above,
    )
    if any_above(wide, above):  # `above` is small, and rounding counts
        q = where4_below(above, wide, _by_matrix(old_x, old_z, new_x, new_y, new_z), q)
    factor = broadcast(ONE) / root(fused(q[3], q[3], vector_square(q)))
    return q[0] * factor, q[1] * factor, q[2] * factor, q[3] * factor


@inlined
def _by_matrix(old_x: Any, old_z: Any, new_x: Any, new_y: Any, new_z: Any) -> Any:
    """`between_frames`, of any length."""
    old_y = cross(old_z, old_x)
    m = (
        _row(new_x[0], new_y[0], new_z[0], old_x, old_y, old_z),
        _row(new_x[1], new_y[1], new_z[1], old_x, old_y, old_z),
        _row(new_x[2], new_y[2], new_z[2], old_x, old_y, old_z),
    )
    w = broadcast(ONE) + m[0][0] + m[1][1] + m[2][2]
    return _by_largest(m, (m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1], w))


@inlined
def _row(x: Any, y: Any, z: Any, old_x: Any, old_y: Any, old_z: Any) -> Any:
    return (
        fused(z, old_z[0], fused(y, old_y[0], x * old_x[0])),
        fused(z, old_z[1], fused(y, old_y[1], x * old_x[1])),
        fused(z, old_z[2], fused(y, old_y[2], x * old_x[2])),
    )


@inlined
def _by_largest(m: Any, q: Any) -> Any:
    """The quaternion of a rotation matrix, of any length, by the largest of its four components (Shepperd);
    `q` is the one by the last component.
    """
    one, (xx, yy, zz) = broadcast(ONE), (m[0][0], m[1][1], m[2][2])
    xy, xz, yz, (xw, yw, zw, w) = m[0][1] + m[1][0], m[0][2] + m[2][0], m[1][2] + m[2][1], q
    x, y, z = one + xx - yy - zz, one - xx + yy - zz, one - xx - yy + zz
    q, most = where4_below(w, x, (x, xy, xz, xw), q), where_below(w, x, x, w)
    q, most = where4_below(most, y, (xy, y, yz, yw), q), where_below(most, y, y, most)
    return where4_below(most, z, (xz, yz, z, zw), q)


@inlined
def half_turn(cosine: Any, sine: Any) -> Any:
    """Returns sine and cosine of half an angle, of its cosine and sine."""
    zero, one = broadcast(ZERO), broadcast(ONE)
    larger = one + size(cosine)
    half_sine = where_below(cosine, zero, larger, sine)
    half_cosine = where_below(cosine, zero, sine, larger)
    factor = one / root(fused(larger, larger, sine * sine))
    return half_sine * factor, half_cosine * factor
