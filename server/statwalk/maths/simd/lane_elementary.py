"""Sine, cosine and angles of sixteen numbers at a time, from + - * / and square roots alone
(`maths.elementary` in float32).

Sums of products are rounded once (`fused`). Results are within 3e-7 of the true values; sine and cosine for
arguments up to 1e4 radians.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import FLOAT, inlined
from statwalk.maths.simd.lane_functions import fused, most, root, where_below, with_sign
from statwalk.maths.simd.lanes import broadcast

# sin(sqrt q) / sqrt q for q in 0..(pi/2)^2, and atan(sqrt z) / sqrt z for z in 0..tan(pi/8)^2, from
# `maths.elementary`
SINE = (
    0.9999999999829089,
    -0.16666666616790812,
    0.008333330973271878,
    -0.00019840861058037127,
    2.752526349541792e-06,
)
ATAN = (
    0.9999999999783846,
    -0.33333332096926027,
    0.19999883803853233,
    -0.1428158730709012,
    0.11040471009581072,
    -0.0845608946699897,
)
# pi in pieces with few bits, so that whole multiples of the first ones are exact (Cody and Waite)
PI = (3.140625, 0.0009670257568359375, 6.27832957178498e-07)
HALF_PI = np.float32(np.pi / 2)
PER_PI = np.float32(1 / np.pi)
ROUNDING = np.float32(1.5 * 2**23)
"""adding and subtracting it rounds a number to the nearest whole number"""
ZERO, HALF, ONE, TWO = np.float32(0), np.float32(0.5), np.float32(1), np.float32(2)
SMALLEST = np.float32(1e-30)


@inlined
def of(number: float) -> Any:
    """Returns a constant in all lanes."""
    return broadcast(FLOAT(number))


@inlined
def _rounded(x: Any) -> Any:
    """The nearest whole numbers, ties to even; |x| below 4e6."""
    return (x + broadcast(ROUNDING)) - broadcast(ROUNDING)


@inlined
def _sine_polynomial(square: Any) -> Any:
    """sin(x) / x of the square of x, |x| up to pi/2."""
    value = fused(square, of(-2.3889104032675583e-08), of(SINE[4]))
    value = fused(square, value, of(SINE[3]))
    value = fused(square, value, of(SINE[2]))
    value = fused(square, value, of(SINE[1]))
    return fused(square, value, of(SINE[0]))


@inlined
def _sine_of_shifted(x: Any, shift: Any) -> Any:
    """sin(x + shift pi), shift 0 or 1/2: the nearest multiple of pi is subtracted, and its parity is the
    sign.
    """
    turns = _rounded(fused(x, broadcast(PER_PI), shift))
    half_turns = turns - shift
    rest = fused(half_turns, of(-PI[0]), x)
    rest = fused(half_turns, of(-PI[1]), rest)
    rest = fused(half_turns, of(-PI[2]), rest)
    odd = turns - broadcast(TWO) * _rounded(turns * broadcast(HALF))
    sign = broadcast(ONE) - broadcast(TWO) * (odd * odd)
    return sign * (rest * _sine_polynomial(rest * rest))


@inlined
def sine(x: Any) -> Any:
    """Returns the sine of radians."""
    return _sine_of_shifted(x, broadcast(ZERO))


@inlined
def cosine(x: Any) -> Any:
    """Returns the cosine of radians."""
    return _sine_of_shifted(x, broadcast(HALF))


@inlined
def sine_cosine(x: Any) -> Any:
    """Returns sine and cosine of radians."""
    return sine(x), cosine(x)


@inlined
def angle(rise: Any, run: Any) -> Any:
    """Returns the angle 0...pi/2 of points (run, rise), neither below 0; 0 for the origin."""
    larger = most(most(rise, run), broadcast(SMALLEST))
    ratio = where_below(run, rise, run, rise) / larger
    one = broadcast(ONE)
    half = ratio / (one + root(fused(ratio, ratio, one)))  # the tangent of half the angle: at most tan(pi/8)
    square = half * half
    value = fused(square, of(0.04707129655257451), of(ATAN[5]))
    value = fused(square, value, of(ATAN[4]))
    value = fused(square, value, of(ATAN[3]))
    value = fused(square, value, of(ATAN[2]))
    value = fused(square, value, of(ATAN[1]))
    value = broadcast(TWO) * half * fused(square, value, of(ATAN[0]))
    return where_below(run, rise, broadcast(HALF_PI) - value, value)


@inlined
def arc_cosine(x: Any) -> Any:
    """Returns the angle 0...pi whose cosine is x; x is clamped to -1...1."""
    one = broadcast(ONE)
    rise, run = root(most((one - x) * (one + x), broadcast(ZERO))), with_sign(x, one)
    acute = angle(rise, run)
    return where_below(x, broadcast(ZERO), broadcast(FLOAT(np.pi)) - acute, acute)
