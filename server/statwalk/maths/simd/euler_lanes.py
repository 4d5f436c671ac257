"""Angles about X, then Y, then Z (FAQ order, R = Rz·Ry·Rx) of sixteen rotations, clamped."""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import FLOAT, inlined
from statwalk.maths.simd.lane_elementary import angle, of, sine_cosine
from statwalk.maths.simd.lane_functions import fused, least, most, root, size, where_below, with_sign
from statwalk.maths.simd.lanes import broadcast

ZERO = np.float32(0)
LOCKED = 1e-5
"""size of a half's sine or cosine below which an angle counts as lost (gimbal lock)"""
ROUNDING = 5e-7
"""of float32 in the sums of which the angles are made"""


@inlined
def around(y: Any, x: Any) -> Any:
    """Returns the angle -pi...pi of points (x, y)."""
    acute = angle(size(y), size(x))
    return with_sign(where_below(x, broadcast(ZERO), broadcast(FLOAT(np.pi)) - acute, acute), y)


@inlined
def _turns(x: Any) -> Any:
    """The whole number of turns nearest to an angle."""
    big = of(1.5 * 2**23)
    return fused(x, of(0.15915494309189535), big) - big


@inlined
def _wrapped(x: Any) -> Any:
    """The angle in -pi...pi; |x| up to some turns."""
    turns = _turns(x)
    return fused(turns, of(1.7484556000744883e-07), fused(turns, of(-6.2831854820251465), x))


@inlined
def whole_turns(x: Any) -> Any:
    """Returns the nearest whole turns, in radians."""
    return _turns(x) * of(6.283185307179586)


@inlined
def _between(x: Any, half: Any) -> Any:
    return least(most(x, -half), half)


@inlined
def euler_excess(q: Any, middle: Any, half: Any) -> Any:
    """Returns by how many radians the angles of rotations leave their limits, at most, and the angles
    clamped; three angles each of middles and halves of ranges.

    Of the two triples of angles of a rotation the nearer counts; with Y at a quarter turn, the nearest of
    all.
    """
    x, y, z, w = q
    plus_sine, plus_cosine, minus_sine, minus_cosine = x + z, w - y, x - z, w + y
    plus, minus = (
        root(fused(plus_sine, plus_sine, plus_cosine * plus_cosine)),
        root(fused(minus_sine, minus_sine, minus_cosine * minus_cosine)),
    )
    y_angle = of(2.0) * around(minus - plus, minus + plus)
    half_sum, half_difference = around(plus_sine, plus_cosine), around(minus_sine, minus_cosine)
    x_angle, z_angle = _unlocked(half_sum, half_difference, plus, minus, middle, half)
    noise = of(ROUNDING) / most(least(plus, minus), of(LOCKED))
    noise = where_below(least(plus, minus), of(LOCKED), broadcast(ZERO), noise)
    pi = of(np.pi)
    first, total = _clamped((x_angle, y_angle, z_angle), middle, half)
    other, other_total = _clamped((x_angle + pi, pi - y_angle, z_angle + pi), middle, half)
    is_other, total = total - other_total, least(total, other_total)
    nearer = _pick(is_other, other, first)
    return total - noise, nearer


@inlined
def _pick(mask: Any, a: Any, b: Any) -> Any:
    zero = broadcast(ZERO)
    return (
        where_below(zero, mask, a[0], b[0]),
        where_below(zero, mask, a[1], b[1]),
        where_below(zero, mask, a[2], b[2]),
    )


@inlined
def _unlocked(half_sum: Any, half_difference: Any, plus: Any, minus: Any, middle: Any, half: Any) -> Any:
    """The angles about X and Z of half their sum and difference; if one of the two is lost, the X angle
    inside its limits with which Z comes nearest to its middle.
    """
    x_angle, z_angle = half_sum + half_difference, half_sum - half_difference
    lost = of(LOCKED)
    difference, total = half_difference + half_difference, half_sum + half_sum
    up = middle[0] + _between(_wrapped(middle[2] + difference - middle[0]), half[0])  # only X - Z is known
    down = middle[0] + _between(_wrapped(total - middle[2] - middle[0]), half[0])  # only X + Z is known
    x_angle = where_below(plus, lost, up, where_below(minus, lost, down, x_angle))
    z_angle = where_below(plus, lost, up - difference, where_below(minus, lost, total - down, z_angle))
    return x_angle, z_angle


@inlined
def _clamped(angles: Any, middle: Any, half: Any) -> Any:
    """The angles clamped, and the largest distance of one from its range."""
    x, y, z = (
        _wrapped(angles[0] - middle[0]),
        _wrapped(angles[1] - middle[1]),
        _wrapped(angles[2] - middle[2]),
    )
    new_x, new_y, new_z = _between(x, half[0]), _between(y, half[1]), _between(z, half[2])
    excess = most(size(x - new_x), most(size(y - new_y), size(z - new_z)))
    return (middle[0] + new_x, middle[1] + new_y, middle[2] + new_z), excess


@inlined
def from_euler(angles: Any) -> Any:
    """Returns the rotations about X, then Y, then Z by three angles."""
    half = of(0.5)
    sx, cx = sine_cosine(angles[0] * half)
    sy, cy = sine_cosine(angles[1] * half)
    sz, cz = sine_cosine(angles[2] * half)
    return (
        fused(sx * cy, cz, -(cx * sy * sz)),
        fused(cx * sy, cz, sx * cy * sz),
        fused(cx * cy, sz, -(sx * sy * cz)),
        fused(cx * cy, cz, sx * sy * sz),
    )
