"""A stage as a pure fold: the state after a tick from the state before it and the entries of the log that count in it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import groupby

import numpy as np

from statwalk.machine.ticking.step import StepResult
from statwalk.stage.cast import Cast, enter
from statwalk.stage.editing.edit import edited
from statwalk.stage.explaining.cells import cells_of
from statwalk.stage.frame import Action, CastFrame, Frame, Verdict
from statwalk.stage.given import Given, given
from statwalk.stage.hash import combine, text
from statwalk.stage.meeting.contacts import Contacts
from statwalk.stage.meeting.flocking import Flights, flocks
from statwalk.stage.meeting.raised import Notice, Raised, raised_by
from statwalk.stage.meeting.touch import touched
from statwalk.stage.past.log import LogEntry
from statwalk.stage.role import Role
from statwalk.stage.tick import tick


@dataclass(frozen=True, eq=False)
class StageState:
    """All that a stage is at a tick, and what happened in it. Never changed."""

    tick: int = 0
    casts: tuple[Cast, ...] = ()
    next_id: int = 1
    action_count: int = 0
    actions: tuple[Action, ...] = ()
    verdicts: tuple[Verdict, ...] = ()
    raised: tuple[Raised, ...] = ()
    """what was touched or raised, and counts in the next tick"""
    notices: tuple[Notice, ...] = ()
    """what an edit did to actors, told in the next tick"""
    contacts: Contacts = field(default_factory=Contacts)
    """who touches whom"""
    flights: Flights = ()
    """how the flocks fly"""
    versions: Mapping[str, str] = field(default_factory=dict)
    """for the name of each role that was ever here the version in force, by its name in the log"""

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


def forward(state: StageState, entries: Sequence[LogEntry], dt: float, seed: int) -> StageState:
    """One tick on: inputs count in its step, in the order of the log; who comes or goes is there, or gone, after it."""
    now = state.tick + 1
    told, stepped = stepping(state, entries, dt, seed)
    flights, casts = flocks(state.flights, state.casts, [cast for cast, _ in stepped], (dt, now, seed))
    contacts, touching = touched(state.contacts, casts)
    actions = _actions(stepped, state.action_count, now)
    raised, unheard = raised_by(actions, casts)
    notices = (*state.notices, *(one for each in told for one in each.notices), *unheard)
    after = replace(
        state,
        tick=now,
        casts=casts,
        action_count=state.action_count + len(actions),
        actions=actions,
        raised=(*touching, *raised),
        notices=(),
        contacts=contacts,
        flights=flights,
    )
    where = {one[:3]: one.where for one in state.raised if one.point}
    verdicts = [verdict for cast, done in stepped for verdict in _verdicts(cast, done, where)]
    return replace(after, verdicts=(*_notices(after, notices), *verdicts))


def stepping(state: StageState, entries: Sequence[LogEntry], dt: float, seed: int) -> tuple[list[Given], list[tuple[Cast, StepResult]]]:
    """For each cast what it is given in the next tick, and what comes of it."""
    told = [given(cast, state.raised, entries, dt) for cast in state.casts]
    return told, [tick(one.cast, one.inputs, dt, state.tick + 1, seed) for one in told]


def recast(state: StageState, entries: Iterable[LogEntry], roles: Mapping[str, Role], dt: float) -> StageState:
    """With the actors who come and go by `entries`, and with the versions of their roles that edits bring."""
    for (kind, key), group in groupby(entries, lambda entry: (entry.kind, entry.value["role"] if entry.kind == "add" else "")):
        if kind == "add":
            state = _added(state, list(group), key, roles)
            continue
        for entry in group:
            if kind == "remove":
                state = _removed(state, entry.actor)
            elif kind == "edit":
                state = _edited(state, entry, roles, dt)
    return state


def _added(state: StageState, entries: Sequence[LogEntry], key: str, roles: Mapping[str, Role]) -> StageState:
    """With actors who come one after the other, all in one copy."""
    name = roles[key].name
    versions = {name: key, **state.versions}  # whoever comes plays by the version in force
    places = np.array([[*entry.value["position"], entry.value["heading"]] for entry in entries], np.float64)
    ids, names = [entry.actor for entry in entries], [entry.name for entry in entries]
    new = enter(roles[versions[name]], ids, names, places[:, :3], places[:, 3])
    casts = tuple(cast.joined(new) if cast.role.name == name else cast for cast in state.casts)
    if all(cast.role.name != name for cast in state.casts):
        casts = (*casts, new)
    return replace(state, casts=casts, next_id=ids[-1] + 1, versions=versions)


def _removed(state: StageState, actor: int) -> StageState:
    casts = (cast.without(row) if (row := cast.row(actor)) >= 0 else cast for cast in state.casts)
    return replace(state, casts=tuple(cast for cast in casts if len(cast.ids)))


def _edited(state: StageState, entry: LogEntry, roles: Mapping[str, Role], dt: float) -> StageState:
    """With all actors of a role in another version of it."""
    role = roles[entry.value["role"]]
    casts, notices = list(state.casts), list(state.notices)
    for place, cast in enumerate(casts):
        if cast.role.name == role.name:
            casts[place], found = edited(cast, role, dt)
            notices += found
    versions = {**state.versions, role.name: entry.value["role"]}
    return replace(state, casts=tuple(casts), notices=tuple(notices), versions=versions)


def _actions(stepped: Iterable[tuple[Cast, StepResult]], count: int, now: int) -> tuple[Action, ...]:
    """The actions of a tick, numbered on; the actors' ids in place of their rows."""
    taken = [(int(cast.ids[action.actor]), action) for cast, done in stepped for action in done.actions]
    return tuple(
        Action(count + number, now, actor, action.name, action.arguments, action.other) for number, (actor, action) in enumerate(taken, 1)
    )


def _verdicts(cast: Cast, done: StepResult, where: Mapping[tuple[int, str, int], str]) -> Iterable[Verdict]:
    """The ids and names of actors, states and events in place of their rows; of touches also where they came about."""
    states, events, cells = cast.role.machine.states, cast.role.machine.events, cells_of(cast.role)
    for one in done.verdicts:
        here, event = states[one.from_state], events[one.event]
        to = states[one.to_state] if one.to_state >= 0 else ""
        cell = cells.get((one.layer, here, event)) if any(one.cell) else None
        said = Verdict(one.tick, int(cast.ids[one.actor]), one.layer, event, one.verdict, one.reason, here, to)
        touch = where.get((said.actor, event, one.other), "")
        said = said._replace(values=one.values, other=one.other, reason="; ".join(filter(None, (touch, one.reason))))
        yield said._replace(cell=cell.written, source=cell.source, line=cell.line) if cell else said


def _notices(state: StageState, notices: Iterable[Notice]) -> Iterable[Verdict]:
    """Verdicts on what no machine could give one on."""
    for one in notices:
        if found := state.find(one.actor):
            cast, row = found
            here = one.from_state or cast.role.machine.states[cast.machine.state[row, one.layer]]
            became = "taken" if one.to_state else "dropped"
            yield Verdict(state.tick, one.actor, one.layer, one.event, became, one.reason, here, one.to_state, other=one.other)


def _cast_frame(cast: Cast) -> CastFrame:
    return CastFrame(cast.role, cast.ids, cast.shown, cast.position, cast.heading, cast.machine.state, cast.phase, cast.fading.left)
