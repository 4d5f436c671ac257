"""Says what a stage is among the others: its name, where it was forked, and what came since then."""

from __future__ import annotations

from collections.abc import Mapping

from statwalk.services.hosting.live_stage import LiveStage
from statwalk.services.hosting.stage_replies import InputFacts, OriginFacts, PlaceInTree
from statwalk.services.hosting.store.records import StageIdentity
from statwalk.stage.stage import Stage
from statwalk.stage.state.commands import Add, Command, Edit, Hold, Press, Release, Remove, Set, Travel

SCENE = "scene "


def place_of(live: LiveStage) -> PlaceInTree:
    """Returns the place of a stage among the others."""
    identity, stage = live.identity, live.stage
    opened, since = identity.opened, identity.origin.number if identity.origin else 0
    return PlaceInTree(
        live.name,
        opened.removeprefix(SCENE) if opened.startswith(SCENE) else None,
        tuple(dict.fromkeys(role.name for role in stage.roles.values())),
        identity.made or None,
        _origin(identity, live),
        stage.newest - since,
        _newest_input(stage, since),
    )


def _origin(identity: StageIdentity, live: LiveStage) -> OriginFacts | None:
    origin = identity.origin
    if origin is None:
        return None
    return OriginFacts(origin.stage, origin.tick, live.services.is_open(origin.stage))


def _newest_input(stage: Stage, since: int) -> InputFacts | None:
    last = stage.last
    if last is None or last.number <= since:
        return None
    return InputFacts(last.number, last.tick, words(last.command, stage.state.names))


def words(command: Command, names: Mapping[int, str]) -> str:
    """Returns a command in a few words; `names`: of the actors that are there, by id."""
    actor = "" if isinstance(command, Edit) else names.get(command.actor, f"actor {command.actor}")
    match command:
        case Press(event=event):
            return f"{event} to {actor}"
        case Hold(event=event):
            return f"hold {event} of {actor}"
        case Release(event=event):
            return f"release {event} of {actor}"
        case Set(parameter=parameter, value=value):
            return f"{parameter} = {value:g} of {actor}"
        case Travel(state=state):
            return f"{actor} travels to {state}" if state else f"{actor} travels no further"
        case Add(name=name):
            return f"{name} added"
        case Remove():
            return f"{actor} removed"
        case Edit(name=name):
            return f"{name} edited"
