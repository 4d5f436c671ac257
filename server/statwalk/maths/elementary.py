"""sin, cos, atan2, acos, exp, log from + − × ÷ √ and exact bit operations alone.

NumPy chooses its own sine by the CPU, so its last bits differ between machines; these functions give the same
bits everywhere, and so does the replay of a log. float64 results are within 1e-14 (relative); float32 input
is computed in float64 and rounded once, so it is right to the last bit or two. The coefficients are minimax
(Chebyshev) fits over the ranges named beside them. Arguments are finite; sin and cos keep their accuracy up
to 1e6 radians.
"""

from __future__ import annotations

from typing import Any, cast

import numpy as np
from numpy.typing import ArrayLike

from statwalk.maths.arrays import Floats, floats

# sin(sqrt q) / sqrt q for q in 0..(pi/2)^2; relative error 2e-19 before rounding; the short one 2e-11
SINE = (
    1.0, -0.16666666666666666, 0.008333333333333186, -0.00019841269841208638, 2.7557319211223257e-06,
    -2.505210688997513e-08, 1.6058940847832492e-10, -7.643025738964345e-13, 2.7215660921125597e-15,
)  # fmt: skip
_SINE_SHORT = (
    0.9999999999829089, -0.16666666616790812, 0.008333330973271878, -0.00019840861058037127,
    2.752526349541792e-06, -2.3889104032675583e-08,
)  # fmt: skip
# atan(sqrt z) / sqrt z for z in 0..tan(pi/8)^2
ATAN = (
    1.0, -0.33333333333328435, 0.19999999998854168, -0.14285714180900647, 0.11111106177375227,
    -0.09090773003240828, 0.07689952488233016, -0.066402251735395, 0.0568830340363325, -0.04347919839046537,
    0.021133752033748364,
)  # fmt: skip
_ATAN_SHORT = (
    0.9999999999783846, -0.33333332096926027, 0.19999883803853233, -0.1428158730709012, 0.11040471009581072,
    -0.0845608946699897, 0.04707129655257451,
)  # fmt: skip
# exp r for |r| <= ln 2 / 2
EXP = (
    1.0, 1.0, 0.5000000000000019, 0.1666666666666668, 0.04166666666648795, 0.008333333333319589,
    0.0013888888952352863, 0.00019841269890076403, 2.4801485441561313e-05, 2.755724088722987e-06,
    2.763265472252779e-07, 2.5110049204818658e-08,
)  # fmt: skip
# atanh(sqrt q) / sqrt q for q in 0..(3 - sqrt 8)^2: its series, whose next term is below 1e-18
LOG = tuple(1.0 / (2 * k + 1) for k in range(12))
ROOT_HALF = 0.7071067811865476
# pi and ln 2 in pieces with few bits, so that whole multiples of the first pieces are exact (Cody and Waite)
PI = (3.141592651605606, 1.9841871583270443e-09, 1.034036596358821e-18)
LN2 = (0.6931471796706319, 8.893134238886677e-10)
DOUBLINGS_PER_E = 1.4426950408889634
_HALF_SHIFT = np.array([0.0, 0.5])


def polynomial(x: Floats, coefficients: tuple[float, ...]) -> Floats:
    """Returns c0 + c1 x + c2 x² + … by Horner's rule, in the precision of x."""
    result = x * coefficients[-1]
    for coefficient in coefficients[-2:0:-1]:
        result += coefficient
        result *= x
    result += coefficients[0]
    return result


def _wide(x: ArrayLike) -> tuple[Floats, np.dtype[Any]]:
    """`x` in float64, and the dtype of the result."""
    values = floats(x)
    return values.astype(np.float64, copy=False), values.dtype


def _sine_of_shifted(x: Floats, shift: Floats | float, short: bool) -> Floats:
    """sin(x + shift·π), shift 0 or ½: the nearest multiple of π is subtracted, and its parity is the sign."""
    turns = np.rint(x * (1 / np.pi) + shift)
    half_turns = turns - shift
    rest = x - half_turns * PI[0] - half_turns * PI[1]
    if not short:
        rest = rest - half_turns * PI[2]
    sign = 1.0 - 2.0 * (turns - 2.0 * np.floor(turns * 0.5))
    return cast("Floats", sign * rest * polynomial(rest * rest, _SINE_SHORT if short else SINE))


def sin(x: ArrayLike) -> Floats:
    """Returns the sine of `x` radians."""
    wide, dtype = _wide(x)
    return _sine_of_shifted(wide, 0.0, dtype != np.float64).astype(dtype, copy=False)


def cos(x: ArrayLike) -> Floats:
    """Returns the cosine of `x` radians."""
    wide, dtype = _wide(x)
    return _sine_of_shifted(wide, 0.5, dtype != np.float64).astype(dtype, copy=False)


def sincos(x: ArrayLike) -> tuple[Floats, Floats]:
    """Returns sine and cosine of `x` radians in one pass."""
    wide, dtype = _wide(x)
    both = _sine_of_shifted(wide[None], _HALF_SHIFT.reshape(2, *(1,) * wide.ndim), dtype != np.float64)
    both = both.astype(dtype, copy=False)
    return both[0], both[1]


def atan2(y: ArrayLike, x: ArrayLike) -> Floats:
    """Returns the angle of the point (x, y) in radians, −π…π; 0 for the origin with x = +0."""
    tall, y_dtype = _wide(y)
    wide, x_dtype = _wide(x)
    dtype = np.result_type(y_dtype, x_dtype)
    rise, run = np.abs(tall), np.abs(wide)
    ratio = np.minimum(rise, run) / np.maximum(np.maximum(rise, run), 1e-300)
    half = ratio / (1.0 + np.sqrt(1.0 + ratio * ratio))  # the tangent of half the angle: at most tan(pi/8)
    angle = 2.0 * half * polynomial(half * half, ATAN if dtype == np.float64 else _ATAN_SHORT)
    angle = np.where(rise > run, np.pi / 2 - angle, angle)
    angle = np.where(np.signbit(wide), np.pi - angle, angle)
    return np.copysign(angle, tall).astype(dtype, copy=False)


def acos(x: ArrayLike) -> Floats:
    """Returns the angle 0…π whose cosine is `x`; `x` is clamped to −1…1."""
    wide, dtype = _wide(x)
    return atan2(np.sqrt(np.maximum((1.0 - wide) * (1.0 + wide), 0.0)), wide).astype(dtype, copy=False)


def exp(x: ArrayLike) -> Floats:
    """Returns e to the power `x`."""
    wide, dtype = _wide(x)
    doublings = np.rint(wide * DOUBLINGS_PER_E)
    rest = wide - doublings * LN2[0] - doublings * LN2[1]
    power: Floats = np.ldexp(polynomial(rest, EXP), doublings.astype(np.int32))
    return power.astype(dtype, copy=False)


def log(x: ArrayLike) -> Floats:
    """Returns the natural logarithm of `x` > 0."""
    wide, dtype = _wide(x)
    mantissa, doublings = np.frexp(wide)
    is_small = mantissa < ROOT_HALF
    mantissa = np.where(is_small, 2.0 * mantissa, mantissa)
    doublings = doublings - is_small
    part = (mantissa - 1.0) / (mantissa + 1.0)
    logarithm = doublings * LN2[0] + (doublings * LN2[1] + 2.0 * part * polynomial(part * part, LOG))
    return np.asarray(logarithm, dtype)
