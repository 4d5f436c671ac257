"""A stage as a pure fold: the state after a tick from the state before it and the entries of the log that count in it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from statwalk.machine.step import HOLD, PRESS, RELEASE, Inputs, StepResult
from statwalk.stage.cast import Cast, enter
from statwalk.stage.frame import Action, CastFrame, Frame, Verdict
from statwalk.stage.hash import combine, text
from statwalk.stage.log import LogEntry
from statwalk.stage.role import Role
from statwalk.stage.tick import tick

KINDS = {"press": PRESS, "hold": HOLD, "release": RELEASE}


@dataclass(frozen=True, eq=False)
class StageState:
    """All that a stage is at a tick, and what happened in it. Never changed."""

    tick: int = 0
    casts: tuple[Cast, ...] = ()
    next_id: int = 1
    action_count: int = 0
    actions: tuple[Action, ...] = ()
    verdicts: tuple[Verdict, ...] = ()

    def find(self, actor: int) -> tuple[Cast, int] | None:
        """The cast and row of an actor, or None."""
        for cast in self.casts:
            if (row := cast.row(actor)) >= 0:
                return cast, row
        return None

    @property
    def hash(self) -> str:
        """16 hexadecimal digits over the tick and the hashes of all actors, in the order of their ids."""
        pairs = sorted((int(actor), int(value)) for cast in self.casts for actor, value in zip(cast.ids, cast.hash, strict=True))
        return text(combine([self.tick, *(value for pair in pairs for value in pair)]))

    def frame(self) -> Frame:
        """What this tick shows."""
        casts = tuple(_cast_frame(cast) for cast in self.casts)
        return Frame(self.tick, self.hash, casts, self.actions, self.verdicts)


def forward(state: StageState, entries: Sequence[LogEntry], dt: float) -> StageState:
    """One tick on: inputs count in its step, in the order of the log; who comes or goes is there, or gone, after it."""
    now = state.tick + 1
    stepped = [tick(*_given(cast, entries), dt, now) for cast in state.casts]
    actions = _actions(stepped, state.action_count, now)
    return StageState(
        now,
        tuple(cast for cast, _ in stepped),
        state.next_id,
        state.action_count + len(actions),
        actions,
        tuple(verdict for cast, done in stepped for verdict in _verdicts(cast, done)),
    )


def recast(state: StageState, entries: Iterable[LogEntry], roles: Mapping[str, Role]) -> StageState:
    """With the actors who come and go by `entries`."""
    for entry in entries:
        if entry.kind == "add":
            state = _added(state, entry, roles[entry.value["role"]])
        elif entry.kind == "remove":
            state = _removed(state, entry.actor)
    return state


def _added(state: StageState, entry: LogEntry, role: Role) -> StageState:
    position, heading = np.array(entry.value["position"], np.float64), float(entry.value["heading"])
    new = enter(role, entry.actor, entry.name, position, heading)
    casts = tuple(cast.joined(new) if cast.role.name == role.name else cast for cast in state.casts)
    if all(cast.role.name != role.name for cast in state.casts):
        casts = (*casts, new)
    return replace(state, casts=casts, next_id=entry.actor + 1)


def _removed(state: StageState, actor: int) -> StageState:
    casts = (cast.without(row) if (row := cast.row(actor)) >= 0 else cast for cast in state.casts)
    return replace(state, casts=tuple(cast for cast in casts if len(cast.ids)))


def _given(cast: Cast, entries: Sequence[LogEntry]) -> tuple[Cast, Inputs]:
    """The cast with its parameters set, and its inputs."""
    rows: list[tuple[int, int, int]] = []
    parameters: list[tuple[int, int, float]] = []
    for entry in entries:
        row = cast.row(entry.actor)
        if row >= 0 and entry.kind == "set":
            parameters.append((row, cast.role.parameter(entry.name), float(entry.value)))
        elif row >= 0 and entry.kind in KINDS:
            rows.append((row, cast.role.event(entry.name), KINDS[entry.kind]))
    actor, event, kind = np.array(rows, np.int64).reshape(-1, 3).T
    return cast.with_parameters(parameters) if parameters else cast, Inputs(actor, event, kind)


def _actions(stepped: Iterable[tuple[Cast, StepResult]], count: int, now: int) -> tuple[Action, ...]:
    """The actions of a tick, numbered on; the actors' ids in place of their rows."""
    taken = [(int(cast.ids[action.actor]), action.name) for cast, done in stepped for action in done.actions]
    return tuple(Action(count + number, now, actor, name) for number, (actor, name) in enumerate(taken, 1))


def _verdicts(cast: Cast, done: StepResult) -> Iterable[Verdict]:
    states, events = cast.role.machine.states, cast.role.machine.events
    for verdict in done.verdicts:
        to = states[verdict.to_state] if verdict.to_state >= 0 else ""
        actor, event = int(cast.ids[verdict.actor]), events[verdict.event]
        yield Verdict(verdict.tick, actor, verdict.layer, event, verdict.verdict, verdict.reason, states[verdict.from_state], to)


def _cast_frame(cast: Cast) -> CastFrame:
    return CastFrame(cast.role, cast.ids, cast.shown, cast.position, cast.heading, cast.machine.state, cast.phase, cast.fading.left)
