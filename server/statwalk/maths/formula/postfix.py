"""A parsed formula: an immutable postfix program, evaluated in one pass over its steps."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from statwalk.maths.arrays import Floats
from statwalk.maths.formula.evaluate import evaluate_rows
from statwalk.maths.formula.operations import NUMBER, VARIABLE, Operation

Step = Operation | float | str
"""an operation, a number, or the name of a variable"""


@dataclass(frozen=True)
class Formula:
    """Steps over a stack of numbers; the last number on the stack is the result."""

    text: str
    scope: tuple[str, ...]
    """the names that it may ask for, in the order of the rows of `values`"""
    steps: tuple[Step, ...]

    @cached_property
    def variables(self) -> tuple[str, ...]:
        """Returns the names that it asks for, in the order of the text."""
        return tuple(dict.fromkeys(step for step in self.steps if isinstance(step, str)))

    def code(self, variables: Sequence[str]) -> list[tuple[int, float]]:
        """Returns the opcode and operand of each step; the operand of a variable is its index in
        `variables`.
        """
        return [_coded(step, variables) for step in self.steps]

    def evaluate(self, values: Floats) -> Floats:
        """Returns (N,) float64 results for `values` (V, N), a row for each of `scope`; finite, and
        independent of N. Any result but 0 is true.
        """
        opcodes, operands = zip(*self.code(self.scope), strict=True)
        rows = np.ascontiguousarray(np.asarray(values, np.float64).T)
        results, own, stack = np.empty(len(rows)), np.empty(rows.shape[1]), np.empty(len(self.steps))
        evaluate_rows(np.array(opcodes, np.uint8), np.array(operands), rows, own, stack, results)
        return results


def _coded(step: Step, variables: Sequence[str]) -> tuple[int, float]:
    if isinstance(step, str):
        return VARIABLE, float(variables.index(step))
    return (step.opcode, 0.0) if isinstance(step, Operation) else (NUMBER, step)
