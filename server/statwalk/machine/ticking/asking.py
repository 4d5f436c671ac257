"""What conditions ask for, as shown at the tick before, and what they answer: each is worked out once a tick, for all who may need it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.built.runform import Machine
from statwalk.machine.conditions.program import Program
from statwalk.machine.ticking.state import MachineState
from statwalk.maths.arrays import Bools, Floats

Asked = tuple[tuple[str, float], ...]
"""name and value of all that conditions asked for"""


@dataclass(eq=False)
class Answers:
    """The conditions of some actors in one layer."""

    machine: Machine
    state: MachineState
    """at the tick before, but with parameters as smoothed by now"""
    measured: Floats
    """(3, N) see `Surroundings`"""
    dt: float
    layer: int
    rows: NDArray[np.intp]
    """(n,) the actors"""
    _truths: dict[int, Bools] = field(default_factory=dict)
    _lists: dict[int, list[bool]] = field(default_factory=dict)

    @cached_property
    def values(self) -> Floats:
        """(V, n) float64 in the order of `Machine.variables`."""
        machine, state, at = self.machine, self.state, (self.rows, self.layer)
        duration = machine.duration[state.state[at]]
        found = dict(zip(("speed", "turning", "height"), self.measured[:, self.rows], strict=True))
        found["phase"] = state.time[at] / np.where(duration > 0, duration, 1.0)
        found["time"] = state.age[at] * self.dt
        return np.array([*state.smoothed[self.rows].T, *(found[name] for name in machine.variables[len(machine.parameters) :])])

    def truths(self, condition: Program) -> Bools:
        """(n,) whether it is true."""
        if id(condition) not in self._truths:  # conditions live as long as their machine
            self._truths[id(condition)] = np.asarray(condition.evaluate(self.values) != 0)
        return self._truths[id(condition)]

    def is_true(self, condition: Program, index: int) -> bool:
        """Whether it is true of the actor at `index` in `rows`."""
        if id(condition) not in self._lists:
            self._lists[id(condition)] = self.truths(condition).tolist()
        return self._lists[id(condition)][index]

    def asked(self, conditions: Iterable[Program], index: int) -> Asked:
        """Name and value of all that the conditions asked for, of the actor at `index`."""
        return self.values_of(dict.fromkeys(name for condition in conditions for name in condition.variables), index)

    def values_of(self, names: Iterable[str], index: int) -> Asked:
        """Name and value of variables, of the actor at `index`."""
        return tuple((name, float(self.values[self.machine.variables.index(name), index])) for name in names)
