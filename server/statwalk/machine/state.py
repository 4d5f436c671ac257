"""What a machine remembers between ticks, for N actors and L layers: arrays that are never written into once they are made."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.build import Machine

MOST_WAITING = 16
RUNNING, ENDED, OWED = 0, 1, 2
NEW = 0
"""in `waiting_until`: to be looked up in the next tick"""
FOREVER = 1 << 62
"""in `waiting_until`: waits for END; in `wake`: nothing to do until something happens"""


class MachineState(NamedTuple):
    """All actors' machines; L is 1. Seconds and ticks."""

    state: NDArray[np.int16]
    """(N, L) rows of the table"""
    time: NDArray[np.float64]
    """(N, L) seconds into the motion"""
    ended: NDArray[np.uint8]
    """(N, L) RUNNING; ENDED: a motion that does not loop has raised its END and holds the last pose; OWED: a stay has put its END off"""
    waiting_event: NDArray[np.int16]
    """(N, L, 16) by arrival, -1 where nothing waits"""
    waiting_until: NDArray[np.int64]
    """(N, L, 16) the tick in which its buffer has run out, NEW or FOREVER"""
    waiting_held: NDArray[np.bool_]
    """(N, L, 16) waits because it is held down, not because it was pressed"""
    wake: NDArray[np.int64]
    """(N, L) the tick in which the queue must be looked at"""
    held: NDArray[np.int32]
    """(N, E) 0 where it is up, else in which order the inputs went down"""
    parameters: NDArray[np.float64]
    """(N, P)"""

    def arrays(self) -> list[NDArray[Any]]:
        """All of it in a fixed order, each with a leading axis of N, for hashes and snapshots."""
        arrays: list[NDArray[Any]] = [*self]
        return arrays

    def append(self, other: MachineState) -> MachineState:
        """These actors, then the others."""
        return MachineState._make(np.concatenate(pair) for pair in zip(self.arrays(), other.arrays(), strict=True))

    def take(self, rows: NDArray[np.integer[Any]] | NDArray[np.bool_]) -> MachineState:
        """The chosen actors, as indices or as a mask."""
        return MachineState._make(array[rows] for array in self.arrays())

    def copy(self) -> MachineState:
        """The same in memory of its own."""
        return MachineState._make(array.copy() for array in self.arrays())


def fresh(machine: Machine, n: int) -> MachineState:
    """`n` actors in the initial state, at the beginning of its motion, with nothing waiting."""
    return MachineState(
        state=np.full((n, 1), machine.initial, np.int16),
        time=np.zeros((n, 1)),
        ended=np.full((n, 1), RUNNING, np.uint8),
        waiting_event=np.full((n, 1, MOST_WAITING), -1, np.int16),
        waiting_until=np.zeros((n, 1, MOST_WAITING), np.int64),
        waiting_held=np.zeros((n, 1, MOST_WAITING), bool),
        wake=np.full((n, 1), FOREVER, np.int64),
        held=np.zeros((n, len(machine.events)), np.int32),
        parameters=np.tile(np.array([one.default for one in machine.parameters], np.float64), (n, 1)),
    )
