"""sin, cos, exp, log, atan2 and modulo of one number, for compiled code: the same bits as `maths.elementary`,
which explains the method.
"""

from __future__ import annotations

import math

import numpy as np

from statwalk.maths import elementary
from statwalk.maths.reference import inlined

_S0, _S1, _S2, _S3, _S4, _S5, _S6, _S7, _S8 = elementary.SINE
_A0, _A1, _A2, _A3, _A4, _A5, _A6, _A7, _A8, _A9, _A10 = elementary.ATAN
_E0, _E1, _E2, _E3, _E4, _E5, _E6, _E7, _E8, _E9, _E10, _E11 = elementary.EXP
_L0, _L1, _L2, _L3, _L4, _L5, _L6, _L7, _L8, _L9, _L10, _L11 = elementary.LOG
_PI0, _PI1, _PI2 = elementary.PI
_LN0, _LN1 = elementary.LN2
_ROOT_HALF, _DOUBLINGS_PER_E = elementary.ROOT_HALF, elementary.DOUBLINGS_PER_E
_OVER_PI, _HALF_PI = 1 / math.pi, math.pi / 2


@inlined
def _sine_of_shifted(x: float, shift: float) -> float:
    turns = np.rint(x * _OVER_PI + shift)
    half_turns = turns - shift
    r = x - half_turns * _PI0 - half_turns * _PI1
    r = r - half_turns * _PI2
    sign = 1.0 - 2.0 * (turns - 2.0 * np.floor(turns * 0.5))
    q = r * r
    p = ((((((((q * _S8 + _S7) * q + _S6) * q + _S5) * q + _S4) * q + _S3) * q + _S2) * q + _S1) * q) + _S0
    return float(sign * r * p)


@inlined
def sin(x: float) -> float:
    """Returns the sine of `x` radians."""
    return _sine_of_shifted(x, 0.0)


@inlined
def cos(x: float) -> float:
    """Returns the cosine of `x` radians."""
    return _sine_of_shifted(x, 0.5)


@inlined
def sincos(x: float) -> tuple[float, float]:
    """Returns sine and cosine of `x` radians."""
    return _sine_of_shifted(x, 0.0), _sine_of_shifted(x, 0.5)


@inlined
def atan2(y: float, x: float) -> float:
    """Returns the angle of the point (x, y) in radians, −π…π; 0 for the origin with x = +0."""
    rise, run = abs(y), abs(x)
    ratio = min(rise, run) / max(max(rise, run), 1e-300)
    half = ratio / (1.0 + math.sqrt(1.0 + ratio * ratio))
    z = half * half
    p = (((((z * _A10 + _A9) * z + _A8) * z + _A7) * z + _A6) * z + _A5) * z
    p = (((((p + _A4) * z + _A3) * z + _A2) * z + _A1) * z) + _A0
    angle = 2.0 * half * p
    if rise > run:
        angle = _HALF_PI - angle
    if math.copysign(1.0, x) < 0:
        angle = math.pi - angle
    return math.copysign(angle, y)


@inlined
def exp(x: float) -> float:
    """Returns e to the power `x`."""
    doublings = np.rint(x * _DOUBLINGS_PER_E)
    r = x - doublings * _LN0 - doublings * _LN1
    p = (((((r * _E11 + _E10) * r + _E9) * r + _E8) * r + _E7) * r + _E6) * r
    p = ((((((p + _E5) * r + _E4) * r + _E3) * r + _E2) * r + _E1) * r) + _E0
    return math.ldexp(p, int(doublings))


@inlined
def log(x: float) -> float:
    """Returns the natural logarithm of `x` > 0."""
    mantissa, power = math.frexp(x)
    doublings = float(power)
    if mantissa < _ROOT_HALF:
        mantissa, doublings = 2.0 * mantissa, doublings - 1.0
    part = (mantissa - 1.0) / (mantissa + 1.0)
    q = part * part
    p = (((((q * _L11 + _L10) * q + _L9) * q + _L8) * q + _L7) * q + _L6) * q
    p = ((((((p + _L5) * q + _L4) * q + _L3) * q + _L2) * q + _L1) * q) + _L0
    return doublings * _LN0 + (doublings * _LN1 + 2.0 * part * p)


@inlined
def modulo(a: float, b: float) -> float:
    """Returns the remainder of `a` after whole multiples of `b` ≠ 0, with the sign of `b`, as NumPy's mod."""
    rest = np.fmod(a, b)
    if rest == 0.0:
        return math.copysign(0.0, b)
    return rest + b if (rest < 0.0) != (b < 0.0) else rest
