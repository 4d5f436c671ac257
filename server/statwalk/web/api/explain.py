"""Why and why not, and the way to a state: GET …/why, GET …/whynot, POST and DELETE …/travel."""

from __future__ import annotations

from typing import Annotated, Any

from fastapi import APIRouter, Depends, Query
from pydantic import BaseModel, ConfigDict

from statwalk.stage.explaining.why import Explained, why
from statwalk.stage.explaining.whynot import whynot
from statwalk.web.api.actors import Stages, find
from statwalk.web.door import stage_of
from statwalk.web.jsonbody import BoundedRoute
from statwalk.web.keeping.hosted import HostedStage
from statwalk.web.schemas import Asked, Name, Tick

router = APIRouter(prefix="/api/stages/{stage_id}/actors/{actor_id}", tags=["why"], route_class=BoundedRoute)
Held = Annotated[HostedStage, Depends(stage_of)]
At = Annotated[Tick, Query()]


class NewTravel(Asked):
    """Where an actor is to go."""

    state: Name


class StepView(BaseModel):
    """In `state`, `event` is sent (END: the end of its motion is waited for); `seconds` as expected."""

    model_config = ConfigDict(strict=True, extra="forbid", frozen=True)

    state: str
    event: str
    seconds: float


class PlanView(BaseModel):
    """A way to `goal`; the first event counts in the tick after `tick` of `stage`: a fork, where it is sent in the past."""

    model_config = ConfigDict(strict=True, extra="forbid", frozen=True)

    goal: str
    tick: int
    seconds: float
    steps: list[StepView]
    stage: str


@router.get("/why")
def get_why(hosted: Held, actor_id: int, tick: At) -> dict[str, Any]:
    """What became of every event of a tick: its cell, what its condition saw, the blend, the joints that it set in motion."""
    stage = hosted.copy()
    find_in_past(hosted, actor_id)
    found = why(stage, actor_id, tick)
    return found._asdict() | {"events": [explained(one) for one in found.events]}


def explained(one: Explained) -> dict[str, Any]:
    """An event, with its values by name."""
    return one._asdict() | {"values": dict(one.values), "joints": [joint._asdict() for joint in one.joints]}


@router.get("/whynot")
def get_whynot(hosted: Held, actor_id: int, event: Annotated[Name, Query()], tick: At) -> dict[str, Any]:
    """What kept an event from firing in a tick, and single changes that would have made it fire; each was tried in a fork."""
    find_in_past(hosted, actor_id)
    found = whynot(hosted.copy(), actor_id, event, tick)
    return found._asdict() | {"remedies": [remedy._asdict() for remedy in found.remedies]}


def find_in_past(hosted: HostedStage, actor: int) -> None:
    """Looks whether there ever was such an actor.

    :raises Problem: 404, if there was none.
    """
    with hosted.turn() as stage:
        if all(entry.actor != actor for entry in stage.log if entry.kind == "add"):
            find(stage, actor)


@router.post("/travel", status_code=202)
def travel(hosted: Held, actor_id: int, asked: NewTravel, registry: Stages) -> PlanView:
    """Sends an actor to a state, by the events that lead there soonest; 409 where no way does. In the past it is a fork's actor."""
    with registry.writing(hosted, None) as target:
        stage = target.stage
        plan = stage.travel(find(stage, actor_id), asked.state)
        target.logged += 1
        steps = [StepView(state=step.state, event=step.event, seconds=step.seconds) for step in plan.steps]
        return PlanView(goal=plan.goal, tick=stage.tick, seconds=plan.seconds, steps=steps, stage=target.id)


@router.delete("/travel", status_code=204)
def cancel_travel(hosted: Held, actor_id: int) -> None:
    """The actor goes nowhere in particular any more."""
    with hosted.turn() as stage:
        stage.cancel_travel(find(stage, actor_id))
        hosted.logged += 1
