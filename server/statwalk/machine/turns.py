"""The turns of all who have something to decide: out of the arrays of a batch, one by one, and back into the arrays."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.advance import Advance
from statwalk.machine.asking import Answers
from statwalk.machine.moments import crossed
from statwalk.machine.record import Record, Waiting
from statwalk.machine.runform import Machine
from statwalk.machine.runparts import MIXED
from statwalk.machine.state import FOREVER, MOMENT, NEW, OWED, MachineState
from statwalk.machine.turn import Turn
from statwalk.maths.arrays import Bools, Floats

At = tuple[NDArray[np.intp], NDArray[np.intp]]
"""actor and layer of each turn, (T,) each"""


@dataclass(eq=False)
class Given:
    """What comes to each actor (row of the batch) in a tick."""

    sensed: dict[int, list[int]] = field(default_factory=dict)
    """rows of the senses that raise their events"""
    inputs: dict[int, list[tuple[int, int, int]]] = field(default_factory=dict)
    """event, kind and other of each input"""


@dataclass(eq=False)
class Batch:
    """N actors in a tick."""

    machine: Machine
    state: MachineState
    """at the tick before, with parameters as smoothed by now"""
    moved: Advance
    measured: Floats
    """(3, N) see `Surroundings`"""
    key: NDArray[np.uint64]
    """(N,)"""
    tick: int
    dt: float
    record: Record = field(default_factory=Record)


def run(batch: Batch, some: Bools, given: Given, after: MachineState) -> MachineState:
    """The state after the turns of `some` (N, L); `after` is the state of those who have none."""
    actors, layers = some.nonzero()
    taken = turns_of(batch, (actors, layers))
    for turn in taken:
        turn.run(given.sensed.get(turn.actor, ()), given.inputs.get(turn.actor, ()))
    return finished(batch, taken, (actors, layers), after)


def turns_of(batch: Batch, at: At) -> list[Turn]:
    """The turns, before they are run."""
    machine, state, moved = batch.machine, batch.state, batch.moved
    answers, index = answers_of(batch, at)
    columns = (
        *(part.tolist() for part in (*at, index, batch.key[at[0]], state.state[at], moved.time[at], state.passed[at], moved.wraps[at])),
        markers_of(batch, at),
        *(part.tolist() for part in (moved.ended[at], moved.at_end[at], state.ended[at] == OWED, moved.carry[at])),
        queues_of(state, at),
        state.held[at[0]].tolist(),
        lasts_of(state, at),
        state.goal[at[0]].tolist(),
    )
    return [
        Turn(machine, batch.record, answers[layer], batch.tick, batch.dt, actor, layer, *others)
        for actor, layer, *others in zip(*columns, strict=True)
    ]


def answers_of(batch: Batch, at: At) -> tuple[list[Answers], NDArray[np.intp]]:
    """What conditions say in each layer, and each turn's (T,) place among the actors of its layer."""
    index = np.zeros(len(at[0]), np.intp)
    found = []
    for layer in range(len(batch.machine.layers)):
        there = np.flatnonzero(at[1] == layer)
        index[there] = np.arange(len(there))
        found.append(Answers(batch.machine, batch.state, batch.measured, batch.dt, layer, at[0][there]))
    return found, index


def markers_of(batch: Batch, at: At) -> list[tuple[str, ...]]:
    """The markers that each turn's motion has crossed."""
    machine, state, moved = batch.machine, batch.state, batch.moved
    if not any(machine.markers):
        return [()] * len(at[0])
    here = state.state[at]
    columns = (here, machine.duration[here], state.passed[at], moved.time[at], moved.wraps[at])
    return [crossed(machine.markers[one], *rest) for one, *rest in zip(*(column.tolist() for column in columns), strict=True)]


def lasts_of(state: MachineState, at: At) -> list[list[int]]:
    """What each turn's actor has left last; the turns of one actor share it, as each layer has outer states of its own."""
    actors = at[0].tolist()
    if not state.last.shape[1]:
        return [[]] * len(actors)
    shared = dict(zip(actors, state.last[at[0]].tolist(), strict=True))
    return [shared[actor] for actor in actors]


def queues_of(state: MachineState, at: At) -> list[list[Waiting]]:
    """What waits for each turn, by arrival."""
    event = state.waiting_event[at]
    queues: list[list[Waiting]] = [[] for _ in event]
    for row in np.flatnonzero(event[:, 0] >= 0).tolist():
        where = at[0][row], at[1][row]
        parts = (state.waiting_event, state.waiting_until, state.waiting_held, state.waiting_other)
        entries = zip(*(part[where].tolist() for part in parts), strict=True)
        queues[row] = [Waiting(*entry) for entry in entries if entry[0] >= 0]
    return queues


def finished(batch: Batch, taken: list[Turn], at: At, after: MachineState) -> MachineState:
    """The turns, back in arrays of their own."""
    state = batch.state
    age = after.age.copy()
    age[at] = np.where([turn.entered for turn in taken], 0, age[at])
    after = after._replace(
        state=put(state.state, at, [turn.state for turn in taken]),
        time=put(after.time, at, [turn.time for turn in taken]),
        passed=put(after.passed, at, [turn.passed if turn.changes else turn.time for turn in taken]),
        ended=put(after.ended, at, [turn.ended for turn in taken]),
        age=age,
        wake=put(state.wake, at, [wake_of(turn) for turn in taken]),
        held=put(state.held, at[0], [turn.held for turn in taken]),
        last=put(state.last, at[0], [turn.last for turn in taken]) if batch.machine.histories else state.last,
        goal=put(state.goal, at[0][at[1] == 0], [turn.goal for turn in taken if turn.layer == 0]),
    )
    queued = [turn for turn in taken if turn.queue or state.waiting_event[turn.actor, turn.layer, 0] >= 0]
    return with_queues(after, queued) if queued else after


def put(array: NDArray[Any], at: Any, values: list[Any]) -> NDArray[Any]:
    """A copy of the array with values in some places."""
    changed = array.copy()
    changed[at] = values
    return changed


def wake_of(turn: Turn) -> int:
    """The tick in which the queue must be looked at; what waits is looked up in a new state, whenever that came about."""
    return NEW if turn.queue and turn.changes else min((one.until for one in turn.queue), default=FOREVER)


def with_queues(after: MachineState, taken: list[Turn]) -> MachineState:
    """The state with the queues of some turns."""
    event, until, held = after.waiting_event.copy(), after.waiting_until.copy(), after.waiting_held.copy()
    other, alert = after.waiting_other.copy(), after.alert.copy()
    for turn in taken:
        at, count = (turn.actor, turn.layer), len(turn.queue)
        event[at], until[at], held[at], other[at] = -1, 0, False, -1
        event[at][:count] = [one.event for one in turn.queue]
        until[at][:count] = [one.until for one in turn.queue]
        held[at][:count] = [one.held for one in turn.queue]
        other[at][:count] = [one.other for one in turn.queue]
        alert[at] = any(is_alert(turn, one) for one in turn.queue)
    return after._replace(waiting_event=event, waiting_until=until, waiting_held=held, waiting_other=other, alert=alert)


def is_alert(turn: Turn, waiting: Waiting) -> bool:
    """Whether an event waits for a marker, a window or a condition."""
    timed = NEW < waiting.until < MOMENT
    return waiting.until == MOMENT or (timed and turn.machine.targets[turn.state][waiting.event] == MIXED)
