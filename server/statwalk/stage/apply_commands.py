"""Commands that count at the end of their tick: actors are added and removed, and roles get new versions."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from itertools import groupby

import numpy as np

from statwalk.character.role import Role
from statwalk.stage.migrate.migrate import edited
from statwalk.stage.state.cast import Cast
from statwalk.stage.state.commands import Add, Command, Edit, Remove
from statwalk.stage.state.stage_state import StageState
from statwalk.stage.steps.enter import enter


def apply_commands(
    roles: Mapping[str, Role], state: StageState, commands: Iterable[Command], dt: float
) -> StageState:
    """Returns the state after the Add, Remove and Edit among the commands; inputs are ignored."""
    for role, group in groupby(commands, lambda command: command.role if isinstance(command, Add) else None):
        if role is not None:
            state = _added(roles, state, [command for command in group if isinstance(command, Add)], role, dt)
            continue
        for command in group:
            if isinstance(command, Remove):
                state = _removed(state, command.actor)
            elif isinstance(command, Edit):
                state = _edited(roles, state, command, dt)
    return state


def _added(
    roles: Mapping[str, Role], state: StageState, adds: Sequence[Add], key: str, dt: float
) -> StageState:
    """The state with new actors of one role, in one copy; they play the version of their role in force."""
    versions = {roles[key].name: key, **state.versions}
    key = versions[roles[key].name]
    places = np.array([[*add.position, add.heading] for add in adds], np.float64)
    clock = state.tick, dt
    new = enter(roles[key], [add.actor for add in adds], places[:, :3], places[:, 3], clock)
    cast = state.casts[key].append(new) if key in state.casts else new
    names = {**state.names, **{add.actor: add.name for add in adds}}
    state = replace(state, next_id=adds[-1].actor + 1, versions=versions, names=names)
    return state.with_casts({**state.casts, key: cast})


def _removed(state: StageState, actor: int) -> StageState:
    place = state.find(actor)
    if place is None:
        return state
    key, row = place
    names = {number: name for number, name in state.names.items() if number != actor}
    return replace(state, names=names).with_casts({**state.casts, key: state.casts[key].without(row)})


def _edited(roles: Mapping[str, Role], state: StageState, edit: Edit, dt: float) -> StageState:
    """The state with all actors of a role in another version of the role."""
    old = state.versions.get(edit.name, edit.name)
    state = replace(state, versions={**state.versions, edit.name: edit.role})
    if old not in state.casts:
        return state
    cast, notices = edited(Cast.of(roles[old], state.casts[old]), roles[edit.role], dt)
    casts = {key: other_cast for key, other_cast in state.casts.items() if key != old}
    return replace(state, notices=(*state.notices, *notices)).with_casts({**casts, edit.role: cast.state})
