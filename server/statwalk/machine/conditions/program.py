"""A condition as run: a postfix program. Immutable; to evaluate it is one pass over its steps."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from statwalk.machine.conditions.operations import Operation, bounded
from statwalk.maths.arrays import Floats

Step = Operation | float | str
"""what to do, a number, or the name of a variable"""


@dataclass(frozen=True)
class Program:
    """Steps over a stack of numbers; what is left at the end is the answer."""

    text: str
    known: tuple[str, ...]
    """the names that it might ask for, in the order of the rows of `values`"""
    steps: tuple[Step, ...]

    @cached_property
    def variables(self) -> tuple[str, ...]:
        """The names that it does ask for, in the order of the text."""
        return tuple(dict.fromkeys(step for step in self.steps if isinstance(step, str)))

    @cached_property
    def cost(self) -> int:
        """About how many additions it takes for one actor; the same for whatever values."""
        return sum(step.cost if isinstance(step, Operation) else 1 for step in self.steps)

    @cached_property
    def _rows(self) -> dict[str, int]:
        return {name: self.known.index(name) for name in self.variables}

    def evaluate(self, values: Floats) -> Floats:
        """(N,) float64 for `values` (V, N), a row for each of `known`; finite, and the same for one as among many. True is not 0."""
        stack: list[Floats] = []
        with np.errstate(all="ignore"):
            rows = {name: bounded(np.nan_to_num(values[row])) for name, row in self._rows.items()}
            for step in self.steps:
                if isinstance(step, str):
                    stack.append(rows[step])
                elif isinstance(step, Operation):
                    first = len(stack) - step.takes
                    stack[first:] = [step.apply(*stack[first:])]
                else:
                    stack.append(np.full(values.shape[1], step))
        return stack[0]
