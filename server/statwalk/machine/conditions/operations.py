"""All that a program can do: a fixed list of operations over float64 arrays, each total. There is no other way to do anything.

What has no value has one here: x/0 and x%0 are 0, sqrt of less than 0 is 0, log of 0 and less is 0, pow without a real value is 0, and
what would be beyond ±1e300 is ±1e300. So no program raises, and no NaN and no infinity ever comes out.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from statwalk.maths import elementary
from statwalk.maths.arrays import Floats

LARGEST = 1e300
LARGEST_EXPONENT = 690.0
"""e to this power is just below LARGEST"""
LARGEST_ANGLE = 1e6
"""radians up to which sines keep their accuracy; beyond, the angle is brought back first"""
MOST_FACTORS = 64
"""whole exponents up to this are multiplied out"""


@dataclass(frozen=True)
class Operation:
    """One opcode: how many numbers it takes, what it does, and about how many additions it costs."""

    name: str
    takes: int
    apply: Callable[..., Floats]
    cost: int = 1


def bounded(x: Floats) -> Floats:
    """Within ±1e300."""
    return np.clip(x, -LARGEST, LARGEST)


def truth(is_true: Floats) -> Floats:
    """1 for true, 0 for false."""
    return np.asarray(is_true, np.float64)


def divided(a: Floats, b: Floats) -> Floats:
    """a / b; 0 where b is 0."""
    return bounded(np.divide(a, b, out=np.zeros_like(a), where=b != 0))


def modulo(a: Floats, b: Floats) -> Floats:
    """What is left of a after whole multiples of b, with the sign of b; 0 where b is 0."""
    return np.asarray(np.mod(a, b, out=np.zeros_like(a), where=b != 0))


def angle(x: Floats) -> Floats:
    """The same angle where it is small enough, else one that is."""
    return np.where(np.abs(x) > LARGEST_ANGLE, np.fmod(x, 2 * np.pi), x)


def sine(x: Floats) -> Floats:
    """sin x."""
    return elementary.sin(angle(x))


def cosine(x: Floats) -> Floats:
    """cos x."""
    return elementary.cos(angle(x))


def tangent(x: Floats) -> Floats:
    """sin x / cos x."""
    return divided(sine(x), cosine(x))


def root(x: Floats) -> Floats:
    """√x; 0 below 0."""
    return np.sqrt(np.maximum(x, 0.0))


def power_of_e(x: Floats) -> Floats:
    """e to the power x."""
    return bounded(elementary.exp(np.clip(x, -LARGEST_EXPONENT, LARGEST_EXPONENT + 1)))


def logarithm(x: Floats) -> Floats:
    """ln x; 0 for 0 and less."""
    return np.where(x > 0, elementary.log(np.where(x > 0, x, 1.0)), 0.0)


def multiplied_out(base: Floats, exponent: Floats) -> Floats:
    """base to whole exponents 0…64, by squaring."""
    left, square, product = exponent.copy(), base, np.ones_like(base)
    while (left > 0).any():
        product = np.where(np.mod(left, 2) == 1, bounded(product * square), product)
        left, square = np.floor(left / 2), bounded(square * square)
    return product


def power(base: Floats, exponent: Floats) -> Floats:
    """base to the power exponent; 0 where that is no real number, or 0 to a power below 0."""
    size = np.abs(exponent)
    is_small = (size <= MOST_FACTORS) & (np.floor(exponent) == exponent)
    whole = multiplied_out(base, np.where(is_small, size, 0.0))
    whole = np.where(exponent < 0, divided(np.ones_like(base), whole), whole)
    other = np.where(base > 0, power_of_e(bounded(exponent * logarithm(base))), 0.0)
    return np.where(is_small, whole, other)


def chosen(condition: Floats, a: Floats, b: Floats) -> Floats:
    """a where the condition holds, else b."""
    return np.where(condition != 0, a, b)


OPERATORS = {
    "or": Operation("or", 2, lambda a, b: truth((a != 0) | (b != 0))),
    "and": Operation("and", 2, lambda a, b: truth((a != 0) & (b != 0))),
    "not": Operation("not", 1, lambda a: truth(a == 0)),
    "<": Operation("<", 2, lambda a, b: truth(a < b)),
    "<=": Operation("<=", 2, lambda a, b: truth(a <= b)),
    ">": Operation(">", 2, lambda a, b: truth(a > b)),
    ">=": Operation(">=", 2, lambda a, b: truth(a >= b)),
    "==": Operation("==", 2, lambda a, b: truth(a == b)),
    "!=": Operation("!=", 2, lambda a, b: truth(a != b)),
    "+": Operation("+", 2, lambda a, b: bounded(a + b)),
    "-": Operation("-", 2, lambda a, b: bounded(a - b)),
    "*": Operation("*", 2, lambda a, b: bounded(a * b)),
    "/": Operation("/", 2, divided, 2),
    "%": Operation("%", 2, modulo, 4),
    "minus": Operation("minus", 1, lambda a: -a),
}
FUNCTIONS = {
    "min": Operation("min", 2, np.minimum),
    "max": Operation("max", 2, np.maximum),
    "abs": Operation("abs", 1, np.abs),
    "floor": Operation("floor", 1, np.floor),
    "ceil": Operation("ceil", 1, np.ceil),
    "sign": Operation("sign", 1, np.sign),
    "sqrt": Operation("sqrt", 1, root, 4),
    "sin": Operation("sin", 1, sine, 20),
    "cos": Operation("cos", 1, cosine, 20),
    "tan": Operation("tan", 1, tangent, 40),
    "exp": Operation("exp", 1, power_of_e, 20),
    "log": Operation("log", 1, logarithm, 20),
    "atan2": Operation("atan2", 2, elementary.atan2, 30),
    "pow": Operation("pow", 2, power, 80),
    "clamp": Operation("clamp", 3, lambda x, a, b: np.minimum(np.maximum(x, a), b), 2),
    "lerp": Operation("lerp", 3, lambda a, b, f: bounded(a + bounded(bounded(b - a) * f)), 3),
    "if": Operation("if", 3, chosen),
}
CONSTANTS = {"true": 1.0, "false": 0.0, "pi": np.pi}
