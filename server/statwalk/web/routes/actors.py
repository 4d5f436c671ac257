"""/api/stages/{id}/actors, /events, /parameters: the actors of a stage, and their inputs."""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Depends, Header, Query, Response

from statwalk.files.film_strip import MOST_PICTURES
from statwalk.files.skeleton_svg import Side
from statwalk.services.cancel import CancelToken
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import RemoveActor, SendEvent, SetParameter
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.hosting.stage_replies import ActorFacts
from statwalk.web.bounded_json import BoundedRoute
from statwalk.web.dependencies import LongWorkToken, stage_of
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
from statwalk.web.schemas.base import IdempotencyKey, Tick

router = APIRouter(prefix="/api/stages/{stage_id}", tags=["actors"], route_class=BoundedRoute)
HostDep = Annotated[StageHost, Depends(stage_of)]
Key = Annotated[IdempotencyKey, Header(alias="Idempotency-Key")]


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


@router.get(
    "/actors/{actor_id}/skeleton.svg",
    response_class=Response,
    responses={200: {"content": {"image/svg+xml": {}}}},
)
def get_actor_skeleton(
    host: HostDep,
    actor_id: int,
    token: LongWorkToken,
    tick: Annotated[list[Tick] | None, Query(max_length=MOST_PICTURES)] = None,
    side: Side = "right",
) -> Response:
    """Draws an actor as a stick figure at each `tick`, by default at the playhead."""
    drawn = host.handle(ask.StickFigures(actor_id, tuple(tick or ()), side), token)
    return Response(drawn, media_type="image/svg+xml", headers={"Cache-Control": "no-cache"})


@router.post("/events", status_code=202)
def post_event(host: HostDep, event: NewEvent, token: Token, key: Key = "") -> Accepted:
    """Sends an event to one actor or to all; the event counts in the next tick.

    If the playhead is in the past, the event goes to a fork of the stage. A second request with the same
    Idempotency-Key does nothing, and gets the first answer.
    """
    return accepted(host, event.command(), key, token)


@router.post("/parameters", status_code=202)
def post_parameter(host: HostDep, parameter: NewParameter, token: Token, key: Key = "") -> Accepted:
    """Sets a parameter of one actor or of all; the value counts in the next tick.

    A second request with the same Idempotency-Key does nothing, and gets the first answer.
    """
    return accepted(host, parameter.command(), key, token)


def accepted(host: StageHost, command: SendEvent | SetParameter, key: str, token: CancelToken) -> Accepted:
    """Posts an input at the playhead."""
    posted = host.handle(ask.Post((command,), key=key), token)
    return Accepted(tick=posted.tick, seq=posted.seq, stage=posted.stage)
