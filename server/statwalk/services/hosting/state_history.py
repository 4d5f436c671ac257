"""Lists which state every actor was in, and since when, from the verdicts that a stage still holds."""

from __future__ import annotations

from collections.abc import Iterator

from statwalk.services.hosting.stage_replies import StateChange
from statwalk.stage.stage import LONGEST_HISTORY, Stage
from statwalk.stage.state.commands import Add
from statwalk.stage.state.frame import Verdict

MOST_CHANGES = 10_000


def state_changes(stage: Stage) -> list[StateChange]:
    """Returns the changes of state that a stage still holds, by tick; the first of each actor is the state in
    which it entered the stage.
    """
    later = [
        StateChange(verdict.tick, verdict.actor, verdict.layer, verdict.to_state)
        for verdict in stage.verdicts
        if verdict.verdict == "taken" and verdict.to_state
    ]
    return sorted([*_beginnings(stage), *later], key=lambda change: change.tick)


def _beginnings(stage: Stage) -> Iterator[StateChange]:
    """Yields the first state of each layer of each actor: at the actor's arrival, or at the oldest tick whose
    verdicts the stage still holds.
    """
    oldest = stage.verdicts[0].tick if len(stage.verdicts) == LONGEST_HISTORY else 0
    first: dict[tuple[int, int], Verdict] = {}
    for verdict in stage.verdicts:
        first.setdefault((verdict.actor, verdict.layer), verdict)
    arrivals = {entry.actor: entry for entry in stage.log if isinstance(entry.command, Add)}
    for entry in arrivals.values():
        if entry.tick >= oldest and isinstance(entry.command, Add):
            for layer, state in enumerate(_initial_states(stage, entry.command.role)):
                yield StateChange(entry.tick, entry.actor, layer, state)
    for (actor, layer), verdict in first.items():
        if arrivals[actor].tick < oldest:
            yield StateChange(oldest, actor, layer, verdict.from_state)
    for present in stage.actors if stage.tick >= oldest else ():
        for layer, state in enumerate(present.states):  # without a verdict since then, the state is the same
            if arrivals[present.id].tick < oldest and (present.id, layer) not in first:
                yield StateChange(oldest, present.id, layer, state)


def _initial_states(stage: Stage, role: str) -> list[str]:
    """Returns the initial state of each layer."""
    machine = stage.roles[role].machine
    return [machine.states[state] for state in machine.initials]
