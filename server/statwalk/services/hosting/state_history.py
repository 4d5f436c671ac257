"""Lists which state every actor was in, and since when, from the verdicts that a stage still holds."""

from __future__ import annotations

from collections.abc import Iterator

from statwalk.services.hosting.stage_replies import StateChange
from statwalk.stage.stage import LONGEST_HISTORY, Stage
from statwalk.stage.state.frame import Verdict

MOST_CHANGES = 10_000


def state_changes(stage: Stage) -> list[StateChange]:
    """Returns the changes of state that a stage still holds, by tick; the first of each actor is the state in
    which it entered the stage.
    """
    later = [
        StateChange(verdict.tick, verdict.actor, verdict.layer, verdict.to_state)
        for verdict in stage.verdicts
        if verdict.verdict == "taken" and verdict.to_state and verdict.tick >= oldest_verdicts(stage)
    ]
    return sorted([*_beginnings(stage), *later], key=lambda change: change.tick)


def _beginnings(stage: Stage) -> Iterator[StateChange]:
    """Yields the first state of each layer of each actor: at the actor's arrival, or at the oldest tick whose
    verdicts the stage still holds.
    """
    oldest = oldest_verdicts(stage)
    first: dict[tuple[int, int], Verdict] = {}
    for verdict in stage.verdicts:
        if verdict.tick >= oldest:
            first.setdefault((verdict.actor, verdict.layer), verdict)
    came_later = set()
    for change in _arrivals(stage, oldest):
        came_later.add(change.actor)
        yield change
    for (actor, layer), verdict in first.items():
        if actor not in came_later:
            yield StateChange(oldest, actor, layer, verdict.from_state)
    for present in stage.actors if stage.tick >= oldest else ():
        for layer, state in enumerate(present.states):  # without a verdict since then, the state is the same
            if present.id not in came_later and (present.id, layer) not in first:
                yield StateChange(oldest, present.id, layer, state)


def oldest_verdicts(stage: Stage) -> int:
    """Returns the oldest tick whose verdicts the stage still holds."""
    known = max(stage.first, stage.remembered_from)
    return max(known, stage.verdicts[0].tick) if len(stage.verdicts) == LONGEST_HISTORY else known


def oldest_facts(stage: Stage) -> int:
    """Returns the tick after which the stage still holds all actions and verdicts."""
    oldest = oldest_verdicts(stage)
    return max(oldest, stage.actions[0].tick) if len(stage.actions) == LONGEST_HISTORY else oldest


def _arrivals(stage: Stage, oldest: int) -> Iterator[StateChange]:
    """Yields the initial states of the actors that came at tick `oldest` or later."""
    for actor, (tick, role) in stage.arrivals().items():
        if tick is not None and tick >= oldest:
            machine = stage.roles[role].machine
            for layer, state in enumerate(machine.initials):
                yield StateChange(tick, actor, layer, machine.states[state])
