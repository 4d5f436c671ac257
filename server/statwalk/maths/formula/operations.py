"""The fixed list of operations of formulas, each defined for all numbers.

Undefined results have a value here: x/0 and x%0 are 0, sqrt below 0 is 0, log of 0 and below is 0, pow
without a real value is 0, asin and acos beyond ±1 are those of ±1, and results beyond ±1e300 are ±1e300. So
no formula raises an error, and no result is NaN or infinite. `scalar_operations` computes them.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

LARGEST = 1e300
LARGEST_EXPONENT = 690.0
"""e to this power is just below LARGEST"""
LARGEST_ANGLE = 1e6
"""radians up to which sines keep their accuracy; larger angles are reduced first"""
MOST_FACTORS = 64
"""largest whole exponent that is multiplied out"""
NUMBER, VARIABLE, FIRST_OPERATION = 0, 1, 2
"""opcodes: a number, the value of a variable; from FIRST_OPERATION on the operators, then the functions"""


@dataclass(frozen=True)
class Operation:
    """One operation: its opcode, and the number of its operands."""

    name: str
    takes: int
    opcode: int


_ONE = (
    *("not", "minus", "abs", "floor", "ceil", "sign", "sqrt", "sin", "cos", "tan", "exp", "log"),
    *("asin", "acos", "atan"),
)
_THREE = ("clamp", "lerp", "if")
_OPERATORS = ("or", "and", "not", "<", "<=", ">", ">=", "==", "!=", "+", "-", "*", "/", "%", "minus")
_FUNCTIONS = (
    *("min", "max", "abs", "floor", "ceil", "sign", "sqrt", "sin", "cos", "tan", "exp", "log"),
    *("atan2", "pow", "clamp", "lerp", "if", "asin", "acos", "atan"),
)


def _operations(names: tuple[str, ...], first: int) -> dict[str, Operation]:
    return {
        name: Operation(name, 1 if name in _ONE else 3 if name in _THREE else 2, opcode)
        for opcode, name in enumerate(names, first)
    }


OPERATORS = _operations(_OPERATORS, FIRST_OPERATION)
FUNCTIONS = _operations(_FUNCTIONS, FIRST_OPERATION + len(_OPERATORS))
CONSTANTS = {"true": 1.0, "false": 0.0, "pi": math.pi}
