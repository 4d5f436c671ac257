"""Those who are alike: actors whose turn must go the same way, as they are in the same state with the same events at hand.

What is not in a situation (times within a motion, values that conditions ask for, chance) is looked at afterwards: whoever differs there
takes a turn of its own.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.built.runform import Machine
from statwalk.machine.ticking.advance import NEARLY, Advance
from statwalk.machine.ticking.given import Given
from statwalk.machine.ticking.state import MOMENT, MOST_WAITING, NEW, OWED, MachineState

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
    columns = [
        *(part[at] for part in (state.state, moved.ended, moved.at_end)),
        state.ended[at] == OWED,
        state.goal[at[0]],
        *given.columns(at[0]),
        *queues(state, tick, at),
        *markers(machine, state, moved, at),
        *(part[at[0]] for part in state.held.T if part.any()),
        *(part[at[0]] for part in state.last.T),
    ]
    _, first, group = np.unique(words(columns), return_index=True, return_inverse=True)
    if any((column != column[first][group]).any() for column in columns):  # two situations with one word: once in the life of the universe
        return list(np.arange(count).reshape(-1, 1))
    order = group.argsort(kind="stable")
    return np.split(order, np.bincount(group).cumsum()[:-1])


def words(columns: list[NDArray[Any]]) -> NDArray[np.uint64]:
    """A 64-bit word for each row of columns (T,) of whole numbers, the same for the same rows."""
    found = np.zeros(len(columns[0]), np.uint64)
    for column in columns:
        found ^= column.astype(np.int64).view(np.uint64)
        found *= np.uint64(0x9E3779B97F4A7C15)
        found ^= found >> np.uint64(29)
    return found


def queues(state: MachineState, tick: int, at: At) -> list[NDArray[Any]]:
    """For each place in the queue (T,): the event, until when it waits (of a tick only whether it has come), held, other."""
    found: list[NDArray[Any]] = []
    for place in range(MOST_WAITING):
        event = state.waiting_event[..., place][at]
        if (event < 0).all():
            break
        until = state.waiting_until[..., place][at]
        kind = np.where(until >= MOMENT, until - MOMENT + 3, np.where(until > tick, 2, until > NEW))
        found += [event, kind, state.waiting_held[..., place][at], state.waiting_other[..., place][at]]
    return found


def markers(machine: Machine, state: MachineState, moved: Advance, at: At) -> list[NDArray[Any]]:
    """(T,) which markers of the motion lie after where it was, which before where it is, and how often it began anew (at most 2)."""
    early = machine.marker_seconds[state.state[at]] - NEARLY
    if not early.shape[1]:
        return []
    bits = np.left_shift(1, np.arange(early.shape[1]))
    after = np.where(state.passed[at][:, None] < early, bits, 0).sum(1)
    before = np.where(early <= moved.time[at][:, None], bits, 0).sum(1)
    return [after, before, np.minimum(moved.wraps[at], 2)]
