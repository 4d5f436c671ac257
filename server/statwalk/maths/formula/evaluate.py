"""Evaluates postfix code over a stack of numbers, compiled."""

from __future__ import annotations

from typing import Any

from numba import types

from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.compiling import kernel, read, write
from statwalk.maths.formula.operations import FIRST_OPERATION, VARIABLE
from statwalk.maths.formula.scalar_operations import number, of_one, of_three, of_two, takes
from statwalk.maths.reference import called

__all__ = ["evaluate_rows", "number", "result"]
_DOUBLE = types.float64


@called
def result(opcode: Ints, operand: Floats, first: int, end: int, values: Floats, stack: Floats) -> float:
    """Returns the result of the steps `first` … `end` for the values (V,) of their variables, made finite by
    `number`. Any result but 0 is true.
    """
    top = 0
    for step in range(first, end):
        operation = opcode[step]
        if operation < FIRST_OPERATION:
            stack[top] = values[int(operand[step])] if operation == VARIABLE else operand[step]
            top += 1
            continue
        count = takes(operation)
        top -= count - 1
        if count == 1:
            stack[top - 1] = of_one(operation, stack[top - 1])
        elif count == 2:
            stack[top - 1] = of_two(operation, stack[top - 1], stack[top])
        else:
            stack[top - 1] = of_three(operation, stack[top - 1], stack[top], stack[top + 1])
    return float(stack[0])


@kernel(
    read(types.uint8, 1), read(_DOUBLE, 1), read(_DOUBLE, 2), write(_DOUBLE, 1), write(_DOUBLE, 1),
    write(_DOUBLE, 1),
)  # fmt: skip
def evaluate_rows(opcode: Any, operand: Any, values: Any, own: Any, stack: Any, results: Any) -> None:
    """Writes the result of all steps for each row of values (N, V); `own` (V,) and `stack` are memory to work
    in.
    """
    for row in range(len(results)):
        for variable in range(len(own)):
            own[variable] = number(values[row, variable])
        results[row] = result(opcode, operand, 0, len(opcode), own, stack)
