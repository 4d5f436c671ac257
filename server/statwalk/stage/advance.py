"""The product in one line: `advance(roles, state, commands, dt, seed) -> (state, effects)` is one tick of a
stage.

The result follows from the arguments alone. `advance` takes its state over; to keep the state, call
`state.copy()` first.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from statwalk.character.role import Role
from statwalk.machine.runtime.result import Changes, StepResult
from statwalk.stage.apply_commands import apply_commands
from statwalk.stage.effects.effects import Effects
from statwalk.stage.effects.verdicts import CastVerdicts, DeliveredNotice, TickVerdicts
from statwalk.stage.state.cast import Cast
from statwalk.stage.state.commands import Command
from statwalk.stage.state.frame import Action
from statwalk.stage.state.pending_events import Notice
from statwalk.stage.state.stage_state import StageState
from statwalk.stage.steps.contact_events import touched
from statwalk.stage.steps.flock import flocks
from statwalk.stage.steps.input_batch import input_batch
from statwalk.stage.steps.raise_events import raised_by
from statwalk.stage.tick import tick

Roles = Mapping[str, Role]
"""roles by the keys that states and commands use"""


def advance(
    roles: Roles, state: StageState, commands: Sequence[Command], dt: float, seed: int
) -> tuple[StageState, Effects]:
    """Returns the state one tick later, and the effects of the tick.

    Inputs count in the tick, in order; then actors are added and removed, and new versions of roles come into
    force.
    """
    now = state.tick + 1
    batches = [
        input_batch(Cast.of(roles[key], cast), state.inbox, commands, dt) for key, cast in state.casts.items()
    ]
    before = [_places(batch.cast) for batch in batches]
    looked_at = frozenset[str]().union(*(batch.cast.role.looks_at for batch in batches))
    stepped = [
        tick(batch.cast, batch.inputs, dt, now, seed, _is_looked_at(batch.cast.role, looked_at))
        for batch in batches
    ]
    results = [done for _, done in stepped]

    flights, casts = flocks(state.flights, before, [cast for cast, _ in stepped], (dt, now, seed))
    contacts, touching = touched(state.contacts, casts)
    actions = _actions(casts, results, state.action_count, now)
    raised, unheard = raised_by(actions, casts, state.names)

    after = StageState(
        tick=now,
        casts={key: cast.state for key, cast in zip(state.casts, casts, strict=True)},
        next_id=state.next_id,
        names=state.names,
        action_count=state.action_count + len(actions),
        inbox=(*touching, *raised),
        contacts=contacts,
        flights=flights,
        versions=state.versions,
    )
    notices = (*state.notices, *(notice for batch in batches for notice in batch.notices), *unheard)
    cast_verdicts = [
        CastVerdicts(cast.role, cast.ids, done.verdicts) for cast, done in zip(casts, results, strict=True)
    ]
    verdicts = TickVerdicts(now, _delivered(roles, after, notices), cast_verdicts, state.inbox)
    changes = [_changes_of(cast.ids, done) for cast, done in zip(casts, results, strict=True)]
    effects = Effects(actions, verdicts, dict(zip(state.casts, changes, strict=True)))
    return apply_commands(roles, after, commands, dt), effects


def _places(cast: Cast) -> Cast:
    """The cast; for a flock with copies of its places, which the flight starts from and the tick
    overwrites.
    """
    return (
        cast
        if cast.role.definition.flock is None
        else replace(cast, position=cast.position.copy(), heading=cast.heading.copy())
    )


def _is_looked_at(role: Role, names: frozenset[str]) -> bool:
    """Whether a collider of the role has one of the names."""
    return not names.isdisjoint(role.colliders.names)


def _changes_of(ids: NDArray[np.int64], done: StepResult) -> Changes:
    """The motions that start in a tick, with ids instead of rows."""
    changes = done.changes
    return changes._replace(actor=ids[changes.actor]) if len(changes.actor) else changes


def _actions(
    casts: Iterable[Cast], results: Iterable[StepResult], count: int, now: int
) -> tuple[Action, ...]:
    """The actions of a tick, numbered from `count` + 1, with ids instead of rows."""
    taken = [(cast, row) for cast, done in zip(casts, results, strict=True) for row in done.actions.tolist()]
    if not taken:
        return ()
    actions = []
    for number, (cast, (actor, _, action, other)) in enumerate(taken, count + 1):
        name, arguments = cast.role.machine.text.actions[action]
        actions.append(Action(number, now, int(cast.ids[actor]), name, arguments, other))
    return tuple(actions)


def _delivered(roles: Roles, state: StageState, notices: Iterable[Notice]) -> Iterator[DeliveredNotice]:
    """The notices to actors that exist, with role and state for their sentences."""
    for notice in notices:
        if place := state.find(notice.actor):
            key, row = place
            yield DeliveredNotice(roles[key], notice, int(state.casts[key].machine.state[row, notice.layer]))
