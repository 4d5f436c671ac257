"""GET /api/stages/{id}/history: which state every actor was in, and since when."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from fastapi import APIRouter, Depends
from pydantic import BaseModel, ConfigDict

from statwalk.stage.frame import Verdict
from statwalk.stage.past.log import LogEntry
from statwalk.stage.stage import LONGEST_HISTORY, Stage
from statwalk.web.door import stage_of
from statwalk.web.jsonbody import BoundedRoute
from statwalk.web.keeping.hosted import HostedStage

router = APIRouter(prefix="/api/stages", tags=["stages"], route_class=BoundedRoute)
MOST_CHANGES = 10_000


class Change(BaseModel):
    """From `tick` on the actor is in `state`."""

    model_config = ConfigDict(strict=True, extra="forbid", frozen=True)

    tick: int
    actor: int
    layer: int
    state: str


class HistoryView(BaseModel):
    """The changes up to `head`, oldest first."""

    model_config = ConfigDict(strict=True, extra="forbid", frozen=True)

    head: int
    changes: list[Change]


@router.get("/{stage_id}/history")
def get_history(hosted: Annotated[HostedStage, Depends(stage_of)]) -> HistoryView:
    """The changes of state, 10,000 at most, the newest ones; each actor's first is the state it came in."""
    with hosted.turn() as stage:
        return HistoryView(head=stage.head, changes=changes(stage)[-MOST_CHANGES:])


def changes(stage: Stage) -> list[Change]:
    """All changes that a stage remembers, by tick."""
    later = [
        Change(tick=verdict.tick, actor=verdict.actor, layer=verdict.layer, state=verdict.to_state)
        for verdict in stage.verdicts
        if verdict.verdict == "taken" and verdict.to_state
    ]
    return sorted([*beginnings(stage), *later], key=lambda change: change.tick)


def beginnings(stage: Stage) -> Iterator[Change]:
    """Where each actor's story begins: with its arrival, or where the stage's memory does."""
    oldest = stage.verdicts[0].tick if len(stage.verdicts) == LONGEST_HISTORY else 0
    first: dict[tuple[int, int], Verdict] = {}
    for verdict in stage.verdicts:
        first.setdefault((verdict.actor, verdict.layer), verdict)
    came = {entry.actor: entry for entry in stage.log if entry.kind == "add"}
    for entry in came.values():
        if entry.tick >= oldest:
            for layer, state in enumerate(initials(stage, entry)):
                yield Change(tick=entry.tick, actor=entry.actor, layer=layer, state=state)
    for (actor, layer), verdict in first.items():
        if came[actor].tick < oldest:
            yield Change(tick=oldest, actor=actor, layer=layer, state=verdict.from_state)
    for quiet in stage.actors if stage.tick >= oldest else ():
        for layer, state in enumerate(quiet.states):  # nothing happened to it since then
            if came[quiet.id].tick < oldest and (quiet.id, layer) not in first:
                yield Change(tick=oldest, actor=quiet.id, layer=layer, state=state)


def initials(stage: Stage, entry: LogEntry) -> list[str]:
    """The states in which an actor comes, one for each layer."""
    machine = stage.roles[entry.value["role"]].machine
    return [machine.states[state] for state in machine.initials]
