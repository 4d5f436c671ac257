"""Applies commands to a stage; each command makes one entry in the stage's log for each actor it
addresses.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import groupby

from statwalk.character.role import Role
from statwalk.errors import ConflictError, LimitError, UnknownNameError
from statwalk.machine.settings import parameter_indices
from statwalk.machine.travel import Plan
from statwalk.services.hosting.actor_facts import columns_of, facts_in
from statwalk.services.hosting.commands import (
    AddActor,
    Command,
    RemoveActor,
    SendEvent,
    SetParameter,
    TravelTo,
)
from statwalk.services.hosting.stage_replies import ActorFacts
from statwalk.stage.stage import Actor, Stage

Outcome = ActorFacts | Plan | None


def apply_commands(
    stage: Stage, commands: Iterable[Command], roles: Mapping[str, Role], most_actors: int
) -> Iterator[Outcome]:
    """Applies the commands in order; yields the outcome of each entry that they make in the log.

    Actors of one machine that follow one another are added together. `roles`: the role of each machine that
    the commands add an actor of.

    :raises UnknownNameError: when no actor has the event, parameter or state that a command names.
    :raises ConflictError: when the stage has no actors, or when it is full.
    :raises StageError: when the stage cannot do it.
    """
    for machine, group in groupby(commands, _machine_to_add):
        if machine is None:
            for command in group:
                yield from _apply_command(stage, command)
        else:
            new = [command for command in group if isinstance(command, AddActor)]
            yield from _add(stage, machine, new, roles[machine], most_actors)


def roles_to_add(commands: Iterable[Command], role_of: Callable[[str], Role]) -> dict[str, Role]:
    """Returns the role of each machine that the commands add an actor of.

    :raises UnknownNameError: when there is no such machine.
    """
    machines = {command.machine for command in commands if isinstance(command, AddActor)}
    return {machine: packed(role_of(machine)) for machine in machines}


def packed(role: Role) -> Role:
    """Returns the role once the arrays that ticks read are made, without the lock of a stage."""
    role.packed  # noqa: B018 - kept in the role
    return role


def _machine_to_add(command: Command) -> str | None:
    return command.machine if isinstance(command, AddActor) else None


def _apply_command(stage: Stage, command: Command) -> Iterator[Outcome]:
    match command:
        case RemoveActor():
            stage.remove(stage.actor(command.actor))
            yield None
        case SendEvent(event=event):
            log = {"press": stage.send, "hold": stage.hold, "release": stage.release}[command.kind]
            for actor in _actors_with(_actors(stage, command.actor), "event", event, _event_names):
                log(actor, event)
                yield None
        case SetParameter(parameter=parameter):
            actors = _actors(stage, command.actor)
            for actor in _actors_with(actors, "parameter", parameter, _parameter_names):
                stage.set(actor, parameter, command.value)
                yield from (None for _ in parameter_indices(actor.role.machine, parameter))
        case TravelTo(state=""):
            stage.cancel_travel(stage.actor(command.actor))
            yield None
        case TravelTo():
            yield stage.travel(stage.actor(command.actor), command.state)


def check_room(actors: int, most_actors: int) -> None:
    """Checks the number of actors on one stage.

    :raises LimitError: when there are more than `most_actors`.
    """
    if actors > most_actors:
        raise LimitError(
            f"a stage holds at most {most_actors} actors; this would make {actors}", limit="actors"
        )


def _add(
    stage: Stage, machine: str, new: Sequence[AddActor], role: Role, most_actors: int
) -> Iterator[ActorFacts]:
    check_room(len(stage.state.ids) + len(new), most_actors)
    if machine in stage.roles:
        role = stage.role(machine)  # this stage may play another version than the catalogue's
    places = [(command.position, command.heading) for command in new]
    added = stage.add_many(role, places, [command.name for command in new])
    yield from facts_in(columns_of(stage, [actor.id for actor in added]))


def _actors(stage: Stage, actor: int | None) -> Sequence[Actor]:
    actors = stage.actors if actor is None else [stage.actor(actor)]
    if not actors:
        raise ConflictError("the stage has no actors; add one first", field="actor")
    return actors


def _event_names(actor: Actor) -> Iterable[str]:
    return actor.role.machine.events[:-1]  # without END, the last event: no input may send END


def _parameter_names(actor: Actor) -> Iterable[str]:
    parameters = actor.role.machine.parameters
    return dict.fromkeys(name for part in parameters for name in (part.vector, part.name) if name)


def _actors_with(
    actors: Sequence[Actor], kind: str, name: str, names_of: Callable[[Actor], Iterable[str]]
) -> list[Actor]:
    """Returns the actors whose `names_of` hold the name.

    :raises UnknownNameError: when no actor has it.
    """
    matching = [actor for actor in actors if name in names_of(actor)]
    if not matching:
        known_names = {known_name for actor in actors for known_name in names_of(actor)}
        raise UnknownNameError(kind, name, sorted(known_names))
    return matching
