"""What a machine remembers between ticks, for N actors and L layers: arrays that are never written into once they are made."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.built.runform import Machine

MOST_WAITING = 16
RUNNING, ENDED, OWED = 0, 1, 2
NEW = 0
"""in `waiting_until`: to be looked up in the next tick"""
FOREVER = 1 << 62
"""in `waiting_until`: waits for END; in `wake`: nothing to do until something happens"""
MOMENT = FOREVER - 1
"""in `waiting_until`: waits for a marker or a window of the motion"""

BEGINNING = -2e-6
"""in `passed`: before all markers, those of phase 0 as well"""


class MachineState(NamedTuple):
    """All actors' machines: N actors, L layers, E events, P parameters, K senses, H outer states that are resumed. Seconds and ticks."""

    state: NDArray[np.int16]
    """(N, L) rows of the table"""
    time: NDArray[np.float64]
    """(N, L) seconds into the motion"""
    passed: NDArray[np.float64]
    """(N, L) seconds into the motion up to which its markers have been met; less than `time` where it began in this tick"""
    age: NDArray[np.int32]
    """(N, L) ticks since the state was entered"""
    ended: NDArray[np.uint8]
    """(N, L) RUNNING; ENDED: a motion that does not loop has raised its END and holds the last pose; OWED: a stay has put its END off"""
    waiting_event: NDArray[np.int16]
    """(N, L, 16) by arrival, -1 where nothing waits"""
    waiting_until: NDArray[np.int64]
    """(N, L, 16) the tick in which its buffer has run out, NEW, MOMENT or FOREVER"""
    waiting_held: NDArray[np.bool_]
    """(N, L, 16) waits because it is held down, not because it was pressed"""
    waiting_other: NDArray[np.int64]
    """(N, L, 16) id of the actor that was touched, or raised the event; -1 none"""
    wake: NDArray[np.int64]
    """(N, L) the tick in which the queue must be looked at"""
    alert: NDArray[np.bool_]
    """(N, L) something in the queue waits for a marker, a window or a condition"""
    held: NDArray[np.int32]
    """(N, E) 0 where it is up, else in which order the inputs went down"""
    parameters: NDArray[np.float64]
    """(N, P) as set"""
    smoothed: NDArray[np.float64]
    """(N, P) on their way there: what speeds, blends and conditions see"""
    smoothed_rate: NDArray[np.float64]
    """(N, P) per second"""
    sensing: NDArray[np.bool_]
    """(N, K) which senses have raised their event and were not released since"""
    last: NDArray[np.int16]
    """(N, H) the inner state that was left last, -1 none"""
    goal: NDArray[np.int16]
    """(N,) the state of the base that the actor travels to, -1 none"""

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
    """`n` actors in the initial states, at the beginning of their motions, with nothing waiting."""
    layers = len(machine.layers)
    parameters = np.tile(np.array([one.default for one in machine.parameters], np.float64), (n, 1))
    return MachineState(
        state=np.tile(np.array(machine.initials, np.int16), (n, 1)),
        time=np.zeros((n, layers)),
        passed=np.full((n, layers), BEGINNING),
        age=np.zeros((n, layers), np.int32),
        ended=np.full((n, layers), RUNNING, np.uint8),
        waiting_event=np.full((n, layers, MOST_WAITING), -1, np.int16),
        waiting_until=np.zeros((n, layers, MOST_WAITING), np.int64),
        waiting_held=np.zeros((n, layers, MOST_WAITING), bool),
        waiting_other=np.full((n, layers, MOST_WAITING), -1, np.int64),
        wake=np.full((n, layers), FOREVER, np.int64),
        alert=np.zeros((n, layers), bool),
        held=np.zeros((n, len(machine.events)), np.int32),
        parameters=parameters,
        smoothed=parameters,
        smoothed_rate=np.zeros(parameters.shape),
        sensing=np.zeros((n, len(machine.senses)), bool),
        last=np.full((n, len(machine.histories)), -1, np.int16),
        goal=np.full(n, -1, np.int16),
    )
