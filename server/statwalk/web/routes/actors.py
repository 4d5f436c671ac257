"""/api/stages/{id}/actors, /events, /parameters: the actors of a stage, and their inputs."""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Depends, Response

from statwalk.services.cancel import CancelToken
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import RemoveActor, SendEvent, SetParameter
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.hosting.stage_replies import ActorFacts
from statwalk.web.bounded_json import BoundedRoute
from statwalk.web.dependencies import stage_of
from statwalk.web.routes.stages import Token, view_actor
from statwalk.web.schemas.actor import (
    Accepted,
    ActorView,
    NewActor,
    NewEvent,
    NewParameter,
    PoseAnswer,
    RootView,
)

router = APIRouter(prefix="/api/stages/{stage_id}", tags=["actors"], route_class=BoundedRoute)
HostDep = Annotated[StageHost, Depends(stage_of)]


@router.get("/actors")
def list_actors(host: HostDep) -> list[ActorView]:
    """Lists the actors of a stage."""
    return [view_actor(actor) for actor in host.handle(ask.DescribeActors())]


@router.post("/actors", status_code=201)
def add_actor(host: HostDep, new: NewActor, response: Response) -> ActorView:
    """Adds an actor; the viewers of the stage get a new hello."""
    (actor,) = host.handle(ask.Post((new.command(),), forks=False)).outcomes
    assert isinstance(actor, ActorFacts)
    response.headers["Location"] = f"/api/stages/{host.id}/actors/{actor.id}"
    return view_actor(actor)


@router.get("/actors/{actor_id}")
def get_actor(host: HostDep, actor_id: int) -> ActorView:
    """Returns one actor."""
    (actor,) = host.handle(ask.DescribeActors(actor_id))
    return view_actor(actor)


@router.delete("/actors/{actor_id}", status_code=204)
def remove_actor(host: HostDep, actor_id: int) -> None:
    """Removes an actor from the stage; its past stays in the log."""
    host.handle(ask.Post((RemoveActor(actor_id),), forks=False))


@router.get("/actors/{actor_id}/pose")
def get_pose(host: HostDep, actor_id: int) -> PoseAnswer:
    """Returns the pose of an actor at the playhead."""
    pose = host.handle(ask.PoseOf(actor_id))
    return PoseAnswer(
        tick=pose.tick,
        state=pose.state,
        names=list(pose.joints),
        translation=pose.local.translation.tolist(),
        rotation=pose.local.rotation.tolist(),
        scale=pose.local.scale.tolist(),
        weights=pose.local.weights.tolist(),
        world=pose.world.tolist(),
        root=RootView(position=pose.position.tolist(), heading=pose.heading),
    )


@router.post("/events", status_code=202)
def post_event(host: HostDep, event: NewEvent, token: Token) -> Accepted:
    """Sends an event to one actor or to all; the event counts in the next tick.

    If the playhead is in the past, the event goes to a fork of the stage.
    """
    return accepted(host, event.command(), None, token)


@router.post("/parameters", status_code=202)
def post_parameter(host: HostDep, parameter: NewParameter, token: Token) -> Accepted:
    """Sets a parameter of one actor or of all; the value counts in the next tick."""
    return accepted(host, parameter.command(), None, token)


def accepted(
    host: StageHost, command: SendEvent | SetParameter, at: int | None, token: CancelToken
) -> Accepted:
    """Posts an input at tick `at` (None: the playhead)."""
    posted = host.handle(ask.Post((command,), at), token)
    return Accepted(tick=posted.tick, seq=posted.seq, stage=posted.stage)
