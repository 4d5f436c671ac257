"""The state space of an actor, as arrays that a kernel fills: every node (what its machine is in after a
tick) that it can come to, and every tick from one node to the next.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numba import types
from numpy.typing import NDArray

from statwalk.maths.compiling import write

NOTHING = -1
"""no event comes from outside"""
MOST_WAITING = 4
"""events that may wait in a node: one from outside, the others by markers"""
MOST_GUESSES = 256
"""sets of truths and draws that may be left to try in a tick"""
STATE, TIME, BEGUN, ENDED, IS_FIRST, WAITING, QUEUE = range(7)
"""columns of a node; BEGUN: the tick into the motion at which it began, if that was in this tick, else
NOT_BEGUN; IS_FIRST: the event that is asked about comes now; after QUEUE event, kind and ticks left for each
place, then the inner states that were left last
"""
NOT_BEGUN = -(1 << 30)
OF_NODES, OF_TICKS, OF_TAKEN, OF_EXPANDED, OF_WORK = range(5)
"""places in `StateSpace.counts`"""


class StateSpace(NamedTuple):
    """Nodes M and ticks T, in the order in which they were found: those that take the least time first."""

    counts: NDArray[np.int64]
    """(5,) nodes, ticks, events taken, nodes whose ticks are all there, steps of an actor"""
    node: NDArray[np.int32]
    """(M, C)"""
    place: NDArray[np.int32]
    """(2^k,) the node by the hash of its numbers, -1 none"""
    found_by: NDArray[np.int32]
    """(M,) the tick that came to it first, -1 where it is a start"""
    start: NDArray[np.int32]
    """(T,)"""
    end: NDArray[np.int32]
    """(T,)"""
    press: NDArray[np.int16]
    """(T,) the event that came from outside, or NOTHING"""
    is_free: NDArray[np.uint8]
    """(T,) whether conditions or chance have decided"""
    past: NDArray[np.int32]
    """(T,) where its events end in `taken`"""
    taken: NDArray[np.int16]
    """(K, 3) event, state, new state (-1: the state stays and its motion goes on)"""


class Guesses(NamedTuple):
    """Truths of C conditions and draws that are still to be tried in a tick, a stack."""

    truths: NDArray[np.uint8]
    """(256, C)"""
    draws: NDArray[np.float64]
    """(256, 32)"""
    now: NDArray[np.int32]
    """(C,) the numbers of the node at hand"""


STATE_SPACE = types.BaseTuple.from_types(
    (
        *(
            write(types.int64, 1),
            write(types.int32, 2),
            write(types.int32, 1),
            write(types.int32, 1),
            write(types.int32, 1),
        ),
        *(
            write(types.int32, 1),
            write(types.int16, 1),
            write(types.uint8, 1),
            write(types.int32, 1),
            write(types.int16, 2),
        ),
    ),
    StateSpace,
)
GUESSES = types.BaseTuple.from_types(
    (write(types.uint8, 2), write(types.float64, 2), write(types.int32, 1)), Guesses
)
"""the types, for kernels"""


def columns(histories: int) -> int:
    """How many numbers a node has."""
    return QUEUE + 3 * MOST_WAITING + histories


def empty_state_space(histories: int, room: int = 1 << 12) -> StateSpace:
    """Room for so many nodes, and some ticks for each."""
    ticks = 4 * room
    return StateSpace(
        np.zeros(5, np.int64),
        np.zeros((room, columns(histories)), np.int32),
        np.full(2 * room, -1, np.int32),
        np.full(room, -1, np.int32),
        np.zeros(ticks, np.int32),
        np.zeros(ticks, np.int32),
        np.zeros(ticks, np.int16),
        np.zeros(ticks, np.uint8),
        np.zeros(ticks, np.int32),
        np.zeros((ticks, 3), np.int16),
    )


NODE_ARRAYS, TICK_ARRAYS, TAKEN_ARRAYS = (
    ("node", "place", "found_by"),
    ("start", "end", "press", "is_free", "past"),
    ("taken",),
)


def doubled(space: StateSpace, names: Sequence[str]) -> StateSpace:
    """The same with twice the room in some of the arrays."""
    arrays = {name: getattr(space, name) for name in names}
    return space._replace(
        **{name: np.concatenate([array, np.zeros_like(array)]) for name, array in arrays.items()}
    )


def trimmed(space: StateSpace) -> StateSpace:
    """The same without the room that is left."""
    some, ticks, taken, _, _ = space.counts.tolist()
    ends = {"node": some, "found_by": some, "taken": taken} | dict.fromkeys(TICK_ARRAYS, ticks)
    return space._replace(**{name: getattr(space, name)[:end] for name, end in ends.items()})
