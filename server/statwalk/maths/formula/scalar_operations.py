"""The operations of formulas on single numbers, compiled."""

from __future__ import annotations

import math

import numpy as np

from statwalk.maths import scalar
from statwalk.maths.formula.operations import (
    FUNCTIONS,
    LARGEST,
    LARGEST_ANGLE,
    LARGEST_EXPONENT,
    MOST_FACTORS,
    OPERATORS,
)
from statwalk.maths.reference import inlined

(OR, AND, NOT, LESS, AT_MOST, MORE, AT_LEAST, EQUAL, UNEQUAL, PLUS, LESS_BY, TIMES, OVER, MODULO, MINUS) = (
    operation.opcode for operation in OPERATORS.values()
)
(
    MIN, MAX, ABS, FLOOR, CEIL, SIGN, SQRT, SIN, COS, TAN, EXP, LOG, ATAN2, POW, CLAMP, LERP, IF, ASIN, ACOS,
    ATAN,
) = (operation.opcode for operation in FUNCTIONS.values())  # fmt: skip
_WHOLE_TURN = 2 * math.pi


@inlined
def _bounded(x: float) -> float:
    """Within ±1e300."""
    return min(max(x, -LARGEST), LARGEST)


@inlined
def number(value: float) -> float:
    """Returns a value as conditions use it: NaN becomes 0, and values are clamped to ±1e300."""
    return 0.0 if math.isnan(value) else _bounded(value)


@inlined
def takes(code: int) -> int:
    """Returns the number of operands of an operation."""
    if code in (CLAMP, LERP, IF):
        return 3
    if code in (NOT, MINUS, ABS, FLOOR, CEIL, SIGN, SQRT, SIN, COS, TAN, EXP, LOG, ASIN, ACOS, ATAN):
        return 1
    return 2


@inlined
def of_one(code: int, a: float) -> float:
    """Returns the result of an operation on one number."""
    if code == NOT:
        return 1.0 if a == 0 else 0.0
    if code == MINUS:
        return -a
    if code == ABS:
        return abs(a)
    if code == FLOOR:
        return float(np.floor(a))
    if code == CEIL:
        return float(np.ceil(a))
    if code == SIGN:
        return 1.0 if a > 0 else -1.0 if a < 0 else 0.0
    if code == SQRT:
        return math.sqrt(max(a, 0.0))
    if code == EXP:
        return _power_of_e(a)
    if code == LOG:
        return _logarithm(a)
    return _angle(code, a) if code >= ASIN else _trigonometric(code, a)


@inlined
def of_two(code: int, a: float, b: float) -> float:
    """Returns the result of an operation on two numbers."""
    if code <= UNEQUAL:
        return 1.0 if _compared(code, a, b) else 0.0
    if code == PLUS:
        return _bounded(a + b)
    if code == LESS_BY:
        return _bounded(a - b)
    if code == TIMES:
        return _bounded(a * b)
    if code == OVER:
        return _divided(a, b)
    if code == MODULO:
        return scalar.modulo(a, b) if b != 0 else 0.0
    if code == MIN:
        return min(a, b)
    if code == MAX:
        return max(a, b)
    if code == ATAN2:
        return scalar.atan2(a, b)
    return _power(a, b)


@inlined
def of_three(code: int, a: float, b: float, c: float) -> float:
    """Returns the result of an operation on three numbers."""
    if code == CLAMP:
        return min(max(a, b), c)
    if code == LERP:
        return _bounded(a + _bounded(_bounded(b - a) * c))
    return b if a != 0 else c


@inlined
def _compared(code: int, a: float, b: float) -> bool:
    if code == OR:
        return a != 0 or b != 0
    if code == AND:
        return a != 0 and b != 0
    if code == LESS:
        return a < b
    if code == AT_MOST:
        return a <= b
    if code == MORE:
        return a > b
    if code == AT_LEAST:
        return a >= b
    return a == b if code == EQUAL else a != b


@inlined
def _divided(a: float, b: float) -> float:
    return _bounded(a / b) if b != 0 else 0.0


@inlined
def _angle(code: int, a: float) -> float:
    if code == ATAN:
        return scalar.atan2(a, 1.0)
    return scalar.atan2(a, _other_leg(a)) if code == ASIN else scalar.atan2(_other_leg(a), a)


@inlined
def _other_leg(leg: float) -> float:
    """The other leg of a right triangle whose longest side is 1; 0 if `leg` is longer."""
    return math.sqrt((1.0 - leg) * (1.0 + leg)) if abs(leg) < 1.0 else 0.0


@inlined
def _trigonometric(code: int, a: float) -> float:
    x = float(np.fmod(a, _WHOLE_TURN)) if abs(a) > LARGEST_ANGLE else a
    if code == SIN:
        return scalar.sin(x)
    if code == COS:
        return scalar.cos(x)
    return _divided(scalar.sin(x), scalar.cos(x))


@inlined
def _power_of_e(x: float) -> float:
    return _bounded(scalar.exp(min(max(x, -LARGEST_EXPONENT), LARGEST_EXPONENT + 1)))


@inlined
def _logarithm(x: float) -> float:
    return scalar.log(x) if x > 0 else 0.0


@inlined
def _power(base: float, exponent: float) -> float:
    """`base` to the power `exponent`; 0 if the result is no real number, or for 0 to a negative power."""
    size = abs(exponent)
    if size > MOST_FACTORS or np.floor(exponent) != exponent:
        return _power_of_e(_bounded(exponent * _logarithm(base))) if base > 0 else 0.0
    left, square, product = int(size), base, 1.0
    while left > 0:
        if left % 2 == 1:
            product = _bounded(product * square)
        left, square = left // 2, _bounded(square * square)
    return _divided(1.0, product) if exponent < 0 else product
