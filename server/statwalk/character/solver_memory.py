"""What the solvers of a role keep from tick to tick: a row of float64 numbers for each actor."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import accumulate

import numpy as np

from statwalk.maths.arrays import Floats


@dataclass(frozen=True)
class SolverMemory:
    """Where each solver keeps its numbers.

    beginning  the numbers of each solver in a new actor, by the solver's name
    """

    beginning: Mapping[str, tuple[float, ...]]

    @property
    def size(self) -> int:
        """Returns K, the numbers of all solvers."""
        return sum(map(len, self.beginning.values()))

    def first(self, solver: str) -> int:
        """Returns the column of a solver's first number."""
        return self._firsts()[solver]

    def fresh(self, count: int) -> Floats:
        """Returns (N, K) the memory of `count` new actors."""
        row = [number for numbers in self.beginning.values() for number in numbers]
        return np.tile(np.array(row, np.float64), (count, 1))

    def migrated(self, old: SolverMemory, values: Floats) -> Floats:
        """Returns the memory (N, K) of actors whose solvers were `old`, with `values` (N, K of `old`); a
        solver that has the same name and as many numbers keeps them.
        """
        if self.beginning == old.beginning:
            return values
        kept, own, theirs = self.fresh(len(values)), self._firsts(), old._firsts()
        for solver, numbers in self.beginning.items():
            if len(old.beginning.get(solver, ())) == len(numbers):
                columns = np.arange(len(numbers))
                kept[:, own[solver] + columns] = values[:, theirs[solver] + columns]
        return kept

    def _firsts(self) -> dict[str, int]:
        counts = accumulate(map(len, self.beginning.values()), initial=0)
        return dict(zip(self.beginning, counts, strict=False))
