"""The state of machines between ticks, for N actors and L layers: arrays that a tick writes in place."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numba import types
from numpy.typing import NDArray

from statwalk.machine.compile.program import Program
from statwalk.maths.compiling import write

MOST_WAITING = 16
RUNNING, ENDED, OWED = 0, 1, 2
LOOK_UP, FOR_BUFFER, FOR_MOMENT, FOR_END = range(4)
"""what an event waits for: to be looked up in the next tick, the end of its buffer, a marker or window of the
motion, END
"""
UNSET = -1
"""in `waiting_until`: the buffer starts when the event is looked up"""

BEGINNING = -2e-6
"""in `passed`: before all markers, also before markers of phase 0"""
QUEUE = ("waiting_event", "waiting_for", "waiting_until", "waiting_held", "waiting_other")
"""the arrays of MachineState that have 16 places for pending events"""


class MachineState(NamedTuple):
    """The machines of N actors: L layers, E events, P parameters, V entry values, K senses, H composite
    states with history. Times are in seconds and ticks.
    """

    state: NDArray[np.int16]
    """(N, L) rows of the table"""
    time: NDArray[np.float64]
    """(N, L) seconds into the motion"""
    passed: NDArray[np.float64]
    """(N, L) seconds into the motion up to which markers have been handled; less than `time` if the motion
    began in this tick, by one more lap for each seam of a loop that the time left after END has crossed
    """
    age: NDArray[np.int32]
    """(N, L) ticks since the state was entered"""
    ended: NDArray[np.uint8]
    """(N, L) RUNNING; ENDED: a motion that does not loop has raised END and holds its last pose; OWED: a stay
    has put END off
    """
    waiting: NDArray[np.int8]
    """(N, L) number of pending events; further places of the next five arrays are empty"""
    waiting_event: NDArray[np.int16]
    """(N, L, 16) by arrival, -1 empty"""
    waiting_for: NDArray[np.uint8]
    """(N, L, 16) LOOK_UP, FOR_BUFFER, FOR_MOMENT or FOR_END"""
    waiting_until: NDArray[np.int64]
    """(N, L, 16) the tick in which the buffer of the event runs out, or UNSET"""
    waiting_held: NDArray[np.bool_]
    """(N, L, 16) whether the event waits because its input is held, not because it was pressed"""
    waiting_other: NDArray[np.int64]
    """(N, L, 16) id of the actor that was touched, or raised the event; -1 none"""
    held: NDArray[np.int32]
    """(N, E) 0 if the input is up, else its place in the order in which inputs went down"""
    stayed: NDArray[np.int32]
    """(N, L, E) the alternative by which a held input put END off in the tick before, -1 none"""
    parameters: NDArray[np.float64]
    """(N, P) as set"""
    smoothed: NDArray[np.float64]
    """(N, P + V) on their way to the set values: speeds, blends and conditions read these; then the values
    that states keep from their entry, see `Program.entry_state`
    """
    smoothed_rate: NDArray[np.float64]
    """(N, P) per second"""
    sensing: NDArray[np.bool_]
    """(N, K) whether a sense has raised its event and was not released since"""
    last: NDArray[np.int16]
    """(N, H) history: the inner state that was left last, -1 none"""
    goal: NDArray[np.int16]
    """(N,) the state of the base layer that the actor travels to, -1 none"""

    def arrays(self) -> list[NDArray[Any]]:
        """Returns all arrays in a fixed order, each with a leading axis of N, for hashes and snapshots."""
        arrays: list[NDArray[Any]] = [*self]
        return arrays

    def append(self, other: MachineState) -> MachineState:
        """Returns the actors of this state followed by the actors of `other`."""
        return MachineState._make(
            np.concatenate(pair) for pair in zip(self.arrays(), other.arrays(), strict=True)
        )

    def take(self, rows: NDArray[np.integer[Any]] | NDArray[np.bool_]) -> MachineState:
        """Returns the actors at some rows, given as indices or as a mask."""
        return MachineState._make(array[rows] for array in self.arrays())

    def copy(self) -> MachineState:
        """Returns a copy that shares no memory."""
        return MachineState._make(array.copy() for array in self.arrays())


def _speeds(program: Program, state: MachineState) -> NDArray[np.float64]:
    """(N, L) speed factor of each motion."""
    factor: NDArray[np.float64] = program.speed[state.state]
    if not len(program.default):
        return factor
    row = program.speed_parameter[state.state]
    from_parameter = np.take_along_axis(state.smoothed, np.maximum(row, 0).astype(np.intp), axis=1)
    return np.where(row >= 0, from_parameter, factor)


def fresh(program: Program, n: int) -> MachineState:
    """Returns `n` actors in the initial states, at the beginning of their motions, with no pending events."""
    layers, events = len(program.initials), program.target.shape[1]
    parameters = np.broadcast_to(program.default, (n, len(program.default))).copy()
    return MachineState(
        state=np.tile(program.initials, (n, 1)),
        time=np.zeros((n, layers)),
        passed=np.full((n, layers), BEGINNING),
        age=np.zeros((n, layers), np.int32),
        ended=np.full((n, layers), RUNNING, np.uint8),
        waiting=np.zeros((n, layers), np.int8),
        waiting_event=np.full((n, layers, MOST_WAITING), -1, np.int16),
        waiting_for=np.zeros((n, layers, MOST_WAITING), np.uint8),
        waiting_until=np.zeros((n, layers, MOST_WAITING), np.int64),
        waiting_held=np.zeros((n, layers, MOST_WAITING), bool),
        waiting_other=np.full((n, layers, MOST_WAITING), -1, np.int64),
        held=np.zeros((n, events), np.int32),
        stayed=np.full((n, layers, events), -1, np.int32),
        parameters=parameters,
        smoothed=np.concatenate([parameters, np.zeros((n, len(program.entry_state)))], 1),
        smoothed_rate=np.zeros(parameters.shape),
        sensing=np.zeros((n, len(program.sense_event)), bool),
        last=np.full((n, program.inside.shape[1]), -1, np.int16),
        goal=np.full(n, -1, np.int16),
    )


_INT16, _LONG, _DOUBLE, _FLAG = types.int16, types.int64, types.float64, types.boolean
STATE = types.BaseTuple.from_types(
    (
        *(
            write(_INT16, 2),
            write(_DOUBLE, 2),
            write(_DOUBLE, 2),
            write(types.int32, 2),
            write(types.uint8, 2),
            write(types.int8, 2),
        ),
        *(write(_INT16, 3), write(types.uint8, 3), write(_LONG, 3), write(_FLAG, 3), write(_LONG, 3)),
        *(
            write(types.int32, 2),
            write(types.int32, 3),
            write(_DOUBLE, 2),
            write(_DOUBLE, 2),
            write(_DOUBLE, 2),
        ),
        *(write(_FLAG, 2), write(_INT16, 2), write(_INT16, 1)),
    ),
    MachineState,
)
"""the type of MachineState in kernels"""
