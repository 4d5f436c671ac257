"""A slow answer to what formulas come to: each operation in NumPy over arrays, step by step."""

from __future__ import annotations

import numpy as np
from statwalk.maths import elementary
from statwalk.maths.arrays import Floats
from statwalk.maths.formula.operations import (
    LARGEST,
    LARGEST_ANGLE,
    LARGEST_EXPONENT,
    MOST_FACTORS,
    Operation,
)
from statwalk.maths.formula.postfix import Formula


def bounded(x: Floats) -> Floats:
    """Within ±1e300."""
    return np.clip(x, -LARGEST, LARGEST)


def truth(is_true: Floats) -> Floats:
    """1 for true, 0 for false."""
    return np.asarray(is_true, np.float64)


def _divided(a: Floats, b: Floats) -> Floats:
    """a / b; 0 where b is 0."""
    return bounded(np.divide(a, b, out=np.zeros_like(a), where=b != 0))


def _modulo(a: Floats, b: Floats) -> Floats:
    """What is left of a after whole multiples of b, with the sign of b; 0 where b is 0."""
    return np.asarray(np.mod(a, b, out=np.zeros_like(a), where=b != 0))


def angle(x: Floats) -> Floats:
    """The same angle where it is small enough, else one that is."""
    return np.where(np.abs(x) > LARGEST_ANGLE, np.fmod(x, 2 * np.pi), x)


def _sine(x: Floats) -> Floats:
    """sin x."""
    return elementary.sin(angle(x))


def _cosine(x: Floats) -> Floats:
    """cos x."""
    return elementary.cos(angle(x))


def _tangent(x: Floats) -> Floats:
    """sin x / cos x."""
    return _divided(_sine(x), _cosine(x))


def root(x: Floats) -> Floats:
    """√x; 0 below 0."""
    return np.sqrt(np.maximum(x, 0.0))


def _power_of_e(x: Floats) -> Floats:
    """e to the power x."""
    return bounded(elementary.exp(np.clip(x, -LARGEST_EXPONENT, LARGEST_EXPONENT + 1)))


def _logarithm(x: Floats) -> Floats:
    """ln x; 0 for 0 and less."""
    return np.where(x > 0, elementary.log(np.where(x > 0, x, 1.0)), 0.0)


def _multiplied_out(base: Floats, exponent: Floats) -> Floats:
    """base to whole exponents 0…64, by squaring."""
    left, square, product = exponent.copy(), base, np.ones_like(base)
    while (left > 0).any():
        product = np.where(np.mod(left, 2) == 1, bounded(product * square), product)
        left, square = np.floor(left / 2), bounded(square * square)
    return product


def _power(base: Floats, exponent: Floats) -> Floats:
    """base to the power exponent; 0 where that is no real number, or 0 to a power below 0."""
    size = np.abs(exponent)
    is_small = (size <= MOST_FACTORS) & (np.floor(exponent) == exponent)
    whole = _multiplied_out(base, np.where(is_small, size, 0.0))
    whole = np.where(exponent < 0, _divided(np.ones_like(base), whole), whole)
    other = np.where(base > 0, _power_of_e(bounded(exponent * _logarithm(base))), 0.0)
    return np.where(is_small, whole, other)


def _other_leg(leg: Floats) -> Floats:
    """√(1 − leg²); 0 beyond ±1."""
    short = np.clip(leg, -1.0, 1.0)
    return np.sqrt((1.0 - short) * (1.0 + short))


def _chosen(condition: Floats, a: Floats, b: Floats) -> Floats:
    """a where the condition holds, else b."""
    return np.where(condition != 0, a, b)


APPLY = {
    "or": lambda a, b: truth((a != 0) | (b != 0)),
    "and": lambda a, b: truth((a != 0) & (b != 0)),
    "not": lambda a: truth(a == 0),
    "<": lambda a, b: truth(a < b),
    "<=": lambda a, b: truth(a <= b),
    ">": lambda a, b: truth(a > b),
    ">=": lambda a, b: truth(a >= b),
    "==": lambda a, b: truth(a == b),
    "!=": lambda a, b: truth(a != b),
    "+": lambda a, b: bounded(a + b),
    "-": lambda a, b: bounded(a - b),
    "*": lambda a, b: bounded(a * b),
    "/": _divided,
    "%": _modulo,
    "minus": lambda a: -a,
    "min": np.minimum,
    "max": np.maximum,
    "abs": np.abs,
    "floor": np.floor,
    "ceil": np.ceil,
    "sign": np.sign,
    "sqrt": root,
    "sin": _sine,
    "cos": _cosine,
    "tan": _tangent,
    "exp": _power_of_e,
    "log": _logarithm,
    "atan2": elementary.atan2,
    "pow": _power,
    "clamp": lambda x, a, b: np.minimum(np.maximum(x, a), b),
    "lerp": lambda a, b, f: bounded(a + bounded(bounded(b - a) * f)),
    "if": _chosen,
    "asin": lambda a: elementary.atan2(a, _other_leg(a)),
    "acos": lambda a: elementary.atan2(_other_leg(a), a),
    "atan": lambda a: elementary.atan2(a, np.ones_like(a)),
}


def evaluate(formula: Formula, values: Floats) -> Floats:
    """What `Formula.evaluate` must return, to the bit."""
    stack: list[Floats] = []
    with np.errstate(all="ignore"):
        for step in formula.steps:
            if isinstance(step, str):
                stack.append(bounded(np.nan_to_num(values[formula.scope.index(step)])))
            elif isinstance(step, Operation):
                first = len(stack) - step.takes
                stack[first:] = [APPLY[step.name](*stack[first:])]
            else:
                stack.append(np.full(values.shape[1], step))
    return stack[0]
