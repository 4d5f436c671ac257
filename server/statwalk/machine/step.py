"""One tick of N machines: motions advance, events are looked up, actions come out. Pure; the meaning is that of "One tick", rules 0 to 5.

Whoever has nothing to decide is stepped in a few array operations; the others take their `Turn`, one by one.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.record import Action, Change, Record, Verdict, Waiting
from statwalk.machine.runform import Machine
from statwalk.machine.state import ENDED, FOREVER, NEW, OWED, RUNNING, MachineState
from statwalk.machine.turn import HOLD, PRESS, RAISED, RELEASE, TOUCH, TRAVEL, Turn
from statwalk.maths.arrays import Bools, Floats, Ints

__all__ = [
    "HOLD",
    "NOTHING",
    "PRESS",
    "RAISED",
    "RELEASE",
    "TOUCH",
    "TRAVEL",
    "Action",
    "Changes",
    "Inputs",
    "StepResult",
    "Surroundings",
    "Verdict",
    "step",
]


NEARLY = 1e-6
"""seconds by which a motion may miss its end: durations are float32 in most files, and sixty sixtieths are hardly ever one"""


class Inputs(NamedTuple):
    """What came from outside for this tick, (M,) each: what was touched, what others raised, then the log's, in its order."""

    actor: Ints
    """row of the batch"""
    event: Ints
    """column; of TRAVEL the state of the base to go to, -1 to go nowhere"""
    kind: Ints
    """PRESS, HOLD, RELEASE, TOUCH, RAISED or TRAVEL"""
    other: Ints | None = None
    """id of the actor that was touched, or raised the event; -1, or None for all: none"""


class Surroundings(NamedTuple):
    """What is not the machine's own, of N actors and L layers."""

    rate: Floats
    """(N, L) factor of time of each motion, beside its speed: what a blend of clips of several durations needs, else 1"""
    measured: Floats
    """(3, N) as shown at the tick before: metres per second along the ground, radians per second (left positive), height in metres"""
    key: NDArray[np.uint64]
    """(N,) of each actor's chance"""

    @classmethod
    def none(cls, actors: int, layers: int) -> Surroundings:
        """Standing still."""
        return cls(np.ones((actors, layers)), np.zeros((3, actors)), np.zeros(actors, np.uint64))


NOTHING = Inputs(*(np.zeros(0, np.int64) for _ in range(3)))


class Changes(NamedTuple):
    """The motions that start in a tick, (C,) each, in the order in which they came about; an actor may stand there several times."""

    actor: NDArray[np.int64]
    layer: NDArray[np.int64]
    from_state: NDArray[np.int16]
    to_state: NDArray[np.int16]
    event: NDArray[np.int16]
    action: NDArray[np.int16]
    """row of the machine's actions, -1 none"""
    blend: NDArray[np.float32]
    """seconds"""
    restart: NDArray[np.bool_]
    """the same state began its motion again"""
    time: NDArray[np.float64]
    """seconds into the new motion"""
    curve: NDArray[np.uint8]
    """row of CURVES"""


class StepResult(NamedTuple):
    """The state after the tick, and what happened in it."""

    state: MachineState
    changes: Changes
    verdicts: list[Verdict]
    actions: list[Action]
    time_before: NDArray[np.float64]
    """(N, L) seconds into the old motion at the end of the tick before"""
    time_reached: NDArray[np.float64]
    """(N, L) seconds into the old motion that it got to, before any change"""
    wraps: NDArray[np.int64]
    """(N, L) how often it began anew on the way"""


class Advance(NamedTuple):
    """Rule 0, (N, L) each: motions after one step. `carry`: the seconds left after END, where END came."""

    time: NDArray[np.float64]
    ended: NDArray[np.uint8]
    at_end: Bools
    carry: Floats
    wraps: NDArray[np.int64]


def step(
    machine: Machine, state: MachineState, dt: float, tick: int, inputs: Inputs = NOTHING, surroundings: Surroundings | None = None
) -> StepResult:
    """All actors after `dt` seconds, in the tick that `tick` names; `state` is left as it is."""
    state = state._replace(smoothed=state.parameters)
    around = surroundings or Surroundings.none(*state.state.shape)
    moved = advance(machine, state, dt, around.rate)
    after = state._replace(time=moved.time, passed=moved.time, ended=moved.ended)
    by_actor: dict[int, list[tuple[int, int]]] = {}
    for actor, event, kind in zip(inputs.actor.tolist(), inputs.event.tolist(), inputs.kind.tolist(), strict=True):
        by_actor.setdefault(actor, []).append((event, kind))
    record = Record()
    rows = deciding(machine, state, moved, tick, by_actor)
    if rows:
        after = after.copy()
    for actor, layer in rows:
        turn = begin(machine, state, moved, record, (tick, dt, actor, layer))
        turn.run(by_actor.get(actor, ()))
        finish(turn, after)
    return StepResult(after, changes_of(record.changes), record.verdicts, record.actions, state.time, moved.time, moved.wraps)


def advance(machine: Machine, state: MachineState, dt: float, rate: Floats) -> Advance:
    """Rule 0: motions advance by one step; END is raised at the end of a motion and at each wrap of one that loops."""
    factor = speeds(machine, state) * rate
    time: NDArray[np.float64] = state.time + dt * factor
    over = np.asarray(time >= machine.duration[state.state] - NEARLY)
    at_end, ended = over, state.ended
    carry, wraps = np.zeros_like(time), np.zeros(time.shape, np.int64)
    if over.any():
        at_end, ended, time = over.copy(), ended.copy(), time.copy()
        here = state.state[over]
        loop, duration, reached = machine.loop[here], machine.duration[here], time[over]
        turns = np.where(loop & (duration > 0), np.floor((reached + NEARLY) / np.where(duration > 0, duration, 1.0)), 0.0)
        wrapped = np.where(duration > 0, np.maximum(reached - turns * duration, 0.0), 0.0)
        seconds = np.where(loop, wrapped, np.maximum(reached - duration, 0.0))
        wraps[over] = turns
        carry[over] = np.divide(seconds, factor[over], out=np.zeros_like(seconds), where=factor[over] > 0)
        at_end[over] = loop | (ended[over] != ENDED)
        time[over] = np.where(loop, wrapped, duration)
        ended[over] = np.where(loop, RUNNING, ENDED)
    return Advance(time, ended, at_end, carry, wraps)


def speeds(machine: Machine, state: MachineState) -> Floats:
    """(N, L) factor of time of each motion."""
    factor: Floats = machine.speed[state.state]
    if machine.parameters:
        row = machine.speed_parameter[state.state]
        given = np.take_along_axis(state.smoothed, np.maximum(row, 0).astype(np.intp), axis=1)
        factor = np.where(row >= 0, given, factor)
    return factor


def deciding(
    machine: Machine, state: MachineState, moved: Advance, tick: int, inputs: dict[int, list[tuple[int, int]]]
) -> list[tuple[int, int]]:
    """(actor, layer) of all that have an input, something in the queue that is due, or an END that somebody may answer."""
    some = np.asarray(state.wake <= tick)
    if moved.at_end.any():
        waits = (state.waiting_event[:, :, 0] >= 0) | (state.held.max(axis=1, keepdims=True) > 0)
        some[moved.at_end & (waits | machine.end_matters[state.state])] = True
    some[list(inputs)] = True
    return [(actor, layer) for actor, layer in np.argwhere(some).tolist()] if some.any() else []


def begin(machine: Machine, state: MachineState, moved: Advance, record: Record, place: tuple[int, float, int, int]) -> Turn:
    """An actor's turn, from the arrays; `place` is tick, dt, actor, layer."""
    tick, dt, actor, layer = place
    at = actor, layer
    waiting = zip(state.waiting_event[at].tolist(), state.waiting_until[at].tolist(), state.waiting_held[at].tolist(), strict=True)
    return Turn(
        machine=machine,
        record=record,
        tick=tick,
        dt=dt,
        actor=actor,
        layer=layer,
        state=int(state.state[at]),
        time=float(moved.time[at]),
        ended=int(moved.ended[at]),
        at_end=bool(moved.at_end[at]),
        owed=bool(state.ended[at] == OWED),
        carry=float(moved.carry[at]),
        queue=[Waiting(event, until, held) for event, until, held in waiting if event >= 0],
        held=state.held[actor].tolist(),
        parameters=state.smoothed[actor].tolist(),
    )


def finish(turn: Turn, after: MachineState) -> None:
    """An actor's turn, back into the arrays of the new state."""
    at = turn.actor, turn.layer
    after.state[at], after.time[at], after.ended[at] = turn.state, turn.time, turn.ended
    count = len(turn.queue)
    after.waiting_event[at], after.waiting_until[at], after.waiting_held[at] = -1, 0, False
    if count:
        after.waiting_event[at][:count] = [one.event for one in turn.queue]
        after.waiting_until[at][:count] = [one.until for one in turn.queue]
        after.waiting_held[at][:count] = [one.held for one in turn.queue]
    soonest = min((one.until for one in turn.queue), default=FOREVER)
    after.wake[at] = NEW if turn.queue and turn.changes else soonest  # what waits is looked up in the new state, whenever it came about
    after.held[turn.actor] = turn.held


def changes_of(changes: Sequence[Change]) -> Changes:
    """The changes as arrays."""
    columns: list[tuple[Any, ...]] = list(zip(*changes, strict=True)) if changes else [()] * len(CHANGE_KINDS)
    return Changes._make(np.array(column, kind) for column, kind in zip(columns, CHANGE_KINDS, strict=True))


CHANGE_KINDS = (np.int64, np.int64, np.int16, np.int16, np.int16, np.int16, np.float32, np.bool_, np.float64, np.uint8)
