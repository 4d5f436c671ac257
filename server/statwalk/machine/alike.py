"""Those who are alike: actors whose turn must go the same way, as they are in the same state with the same events at hand.

What is not in a situation (times within a motion, values that conditions ask for, chance) is looked at afterwards: whoever differs there
takes a turn of its own.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.advance import NEARLY, Advance
from statwalk.machine.given import Given
from statwalk.machine.runform import Machine
from statwalk.machine.state import MOMENT, NEW, OWED, MachineState

At = tuple[NDArray[np.intp], NDArray[np.intp]]
"""actor and layer of each turn, (T,) each"""
Members = NDArray[np.intp]
"""turns, by their places in At"""
WORTH = 12
"""from so many turns on it costs less to find out who is alike"""
MOST_MARKERS = 62
"""of a motion; with more of them turns are taken one by one"""
MOST_INPUTS = 16
"""of an actor in a tick; the same"""


def alike(machine: Machine, state: MachineState, moved: Advance, tick: int, given: Given, at: At) -> list[Members]:
    """The turns of each situation, by their first."""
    count = len(at[0])
    if count < WORTH or machine.marker_seconds.shape[1] > MOST_MARKERS or given.most > MOST_INPUTS:
        return list(np.arange(count).reshape(-1, 1))
    table = np.concatenate(
        [
            np.stack([state.state[at], moved.ended[at], moved.at_end[at], state.ended[at] == OWED, state.goal[at[0]]], 1),
            given.table(at[0]),
            queues(state, tick, at),
            markers(machine, state, moved, at),
            state.held[at[0]],
            state.last[at[0]],
        ],
        axis=1,
    ).astype(np.int64)
    _, first, group = np.unique(words(table), return_index=True, return_inverse=True)
    if (table != table[first[group]]).any():  # two situations with the same word: once in the life of the universe
        return list(np.arange(count).reshape(-1, 1))
    order = group.argsort(kind="stable")
    return np.split(order, np.bincount(group).cumsum()[:-1])


def words(table: NDArray[np.int64]) -> NDArray[np.uint64]:
    """A 64-bit word for each row (T, W), the same for the same rows."""
    found = np.zeros(len(table), np.uint64)
    for column in table.T.view(np.uint64):
        found = (found ^ column) * np.uint64(0x9E3779B97F4A7C15)
        found ^= found >> np.uint64(29)
    return found


def queues(state: MachineState, tick: int, at: At) -> NDArray[np.int64]:
    """(T, 4 q) what waits: event, until when (of the ticks only whether it has come), held, other; q of the longest queue."""
    event = state.waiting_event[at]
    longest = int((event >= 0).sum(1).max())
    until = state.waiting_until[at][:, :longest]
    kind = np.where(until >= MOMENT, until - MOMENT + 3, np.where(until > tick, 2, until > NEW))
    parts = (event[:, :longest], kind, state.waiting_held[at][:, :longest], state.waiting_other[at][:, :longest])
    return np.concatenate(parts, axis=1).astype(np.int64)


def markers(machine: Machine, state: MachineState, moved: Advance, at: At) -> NDArray[np.int64]:
    """(T, 3) which markers of the motion lie after where it was, which before where it is, and how often it began anew (at most 2)."""
    early = machine.marker_seconds[state.state[at]] - NEARLY
    bits = np.left_shift(1, np.arange(early.shape[1]))
    after = np.where(state.passed[at][:, None] < early, bits, 0).sum(1)
    before = np.where(early <= moved.time[at][:, None], bits, 0).sum(1)
    return np.stack([after, before, np.minimum(moved.wraps[at], 2)], 1)
