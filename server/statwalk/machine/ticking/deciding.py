"""Who has something to decide in a tick; all others are stepped in a few array operations."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.built.runform import Machine
from statwalk.machine.built.runparts import AT_MARKER, IN_WINDOW, MIXED, NOW
from statwalk.machine.ticking.advance import NEARLY, Advance
from statwalk.machine.ticking.asking import Answers
from statwalk.machine.ticking.moments import any_crossed
from statwalk.machine.ticking.state import MOMENT, NEW, MachineState
from statwalk.maths.arrays import Bools, Floats

Rows = NDArray[np.integer[Any]]


def deciding(machine: Machine, state: MachineState, moved: Advance, tick: int, measured: Floats, dt: float) -> Bools:
    """(N, L) who has something in the queue that is due, crosses a marker that matters, or has an END that somebody may answer."""
    some: Bools = state.wake <= tick
    if moved.at_end.any():
        waits = (state.waiting_event[:, :, 0] >= 0) | (state.held.max(axis=1, keepdims=True) > 0)
        some[moved.at_end & (waits | machine.end_matters[state.state])] = True
    if machine.heard.shape[1]:
        some = np.logical_or(some, marked(machine.heard[state.state], state, moved))
    if state.alert.any():
        for layer in range(len(machine.layers)):
            rows = np.flatnonzero(state.alert[:, layer] & ~some[:, layer])
            if len(rows):
                answers = Answers(machine, state, measured, dt, layer, rows)
                some[rows, layer] = come(machine, state, moved, answers)
    return some


def marked(places: Floats, state: MachineState, moved: Advance) -> Bools:
    """(N, L) whose motion has crossed one of the markers at `places` (N, L, K) seconds."""
    return np.asarray(any_crossed(places, state.passed[..., None], moved.time[..., None], moved.wraps[..., None]).any(-1))


def come(machine: Machine, state: MachineState, moved: Advance, answers: Answers) -> Bools:
    """(n,) for whom, of the actors of `answers`, a marker, a window or a condition that something waits for may have come."""
    at = answers.rows, answers.layer
    here, queue, until = state.state[at], state.waiting_event[at], state.waiting_until[at]
    passed, time, wraps = (array[at][:, None] for array in (state.passed, moved.time, moved.wraps))
    waits = (queue >= 0) & (until == MOMENT)
    when = machine.when[here[:, None], queue]
    found: Bools = np.zeros(len(here), bool)
    markers = (waits & (when == AT_MARKER)).any(1)
    if markers.any():
        found |= markers & any_crossed(machine.marker_seconds[here], passed, time, wraps).any(1)
    windows = waits & (when == IN_WINDOW)
    if windows.any():
        opens, closes = (edge[here[:, None], queue] for edge in machine.windows)
        found |= (windows & open_window(opens, closes, passed, time, wraps)).any(1)
    blank = (queue >= 0) & (until > NEW) & (until < MOMENT) & (machine.target[here[:, None], queue] == MIXED)
    found |= (blank & (when != NOW)).any(1)  # nothing was true at its moment: it waits for the next
    return found | true_now(machine, here, queue, blank, answers)


def open_window(opens: Floats, closes: Floats, passed: Floats, time: Floats, wraps: Rows) -> Bools:
    """The array form of `moments.in_window`; it may say yes too often, never too seldom."""
    reached, before = time >= opens - NEARLY, passed < closes + NEARLY
    return np.where((wraps > 0) | (opens > closes), reached | before | (wraps > 1) | (wraps > 0) & (opens > closes), reached & before)


def true_now(machine: Machine, here: Rows, queue: Rows, blank: Bools, answers: Answers) -> Bools:
    """(n,) for whom a cell in which nothing was true has something true by now; `blank` (n, 16) marks such cells in the queue."""
    found: Bools = np.zeros(len(here), bool)
    index, slot = blank.nonzero()
    places = np.stack([here[index], queue[index, slot]])
    for state, event in np.unique(places, axis=1).T.tolist():
        rows = index[(places[0] == state) & (places[1] == event)]
        for one in machine.outcomes[state, event]:
            found[rows] |= True if one.condition is None else answers.truths(one.condition)[rows]
    return found
