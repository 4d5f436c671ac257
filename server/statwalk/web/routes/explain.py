"""GET …/why, GET …/whynot, POST and DELETE …/travel: explanations of events, and travel to a state."""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Depends, Query

from statwalk.machine.travel import Plan
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import TravelTo
from statwalk.services.hosting.stage_host import StageHost
from statwalk.web.bounded_json import BoundedRoute
from statwalk.web.dependencies import LongWorkToken, stage_of
from statwalk.web.routes.stages import Token
from statwalk.web.schemas.base import Name, Tick
from statwalk.web.schemas.explanation import NewTravel, PlanView, StepView, WhyNotView, WhyView

router = APIRouter(prefix="/api/stages/{stage_id}/actors/{actor_id}", tags=["why"], route_class=BoundedRoute)
HostDep = Annotated[StageHost, Depends(stage_of)]
At = Annotated[Tick, Query()]


@router.get("/why")
def get_why(host: HostDep, actor_id: int, tick: At, token: LongWorkToken) -> WhyView:
    """Returns the verdict on every event of a tick: its cell, the values that its condition read, the blend,
    and the joints that it moves most.
    """
    return WhyView.model_validate(host.handle(ask.Why(actor_id, tick), token))


@router.get("/whynot")
def get_whynot(
    host: HostDep, actor_id: int, event: Annotated[Name, Query()], tick: At, token: LongWorkToken
) -> WhyNotView:
    """Returns why an event did not fire in a tick, and single changes that make it fire; each change was
    tried in a fork.
    """
    return WhyNotView.model_validate(host.handle(ask.WhyNot(actor_id, event, tick), token))


@router.post("/travel", status_code=202)
def travel(host: HostDep, actor_id: int, body: NewTravel, token: Token) -> PlanView:
    """Sends an actor to a state by the fastest path of events; 409 if no path leads there.

    If the playhead is in the past, the actor of a fork travels.
    """
    posted = host.handle(ask.Post((TravelTo(actor_id, body.state),)), token)
    (plan,) = posted.outcomes
    assert isinstance(plan, Plan)
    steps = [StepView.model_validate(step) for step in plan.steps]
    return PlanView(goal=plan.goal, tick=posted.tick, seconds=plan.seconds, steps=steps, stage=posted.stage)


@router.delete("/travel", status_code=204)
def cancel_travel(host: HostDep, actor_id: int) -> None:
    """Cancels the actor's travel."""
    host.handle(ask.Post((TravelTo(actor_id, ""),), forks=False))
