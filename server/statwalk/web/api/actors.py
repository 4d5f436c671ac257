"""/api/stages/{id}/actors, events, parameters: who is there, and what reaches them."""

from __future__ import annotations

from typing import Annotated

from fastapi import APIRouter, Depends, Response

from statwalk.errors import UnknownNameError
from statwalk.stage.stage import Actor, Stage
from statwalk.web.api.stages import view_actor
from statwalk.web.door import registry_of, stage_of
from statwalk.web.jsonbody import BoundedRoute
from statwalk.web.keeping.hosted import HostedStage
from statwalk.web.keeping.registry import Registry
from statwalk.web.problem import Problem
from statwalk.web.schemas import Accepted, ActorView, NewActor, NewEvent, NewParameter, Pose

router = APIRouter(prefix="/api/stages/{stage_id}", tags=["actors"], route_class=BoundedRoute)
Held = Annotated[HostedStage, Depends(stage_of)]
Stages = Annotated[Registry, Depends(registry_of)]


def find(stage: Stage, actor_id: int) -> Actor:
    """The actor of a path.

    :raises Problem: 404, if there is none.
    """
    try:
        return stage.actor(actor_id)
    except UnknownNameError as error:
        raise Problem(404, str(error), field="actor", known=error.known) from None


@router.get("/actors")
def list_actors(hosted: Held) -> list[ActorView]:
    """The actors of a stage."""
    with hosted.turn() as stage:
        return [view_actor(actor) for actor in stage.actors]


@router.post("/actors", status_code=201)
def add_actor(hosted: Held, new: NewActor, registry: Stages, response: Response) -> ActorView:
    """Adds an actor; viewers get a new hello."""
    with hosted.turn():
        actor = registry.place(hosted, new)
        response.headers["Location"] = f"/api/stages/{hosted.id}/actors/{actor.id}"
        return view_actor(actor)


@router.get("/actors/{actor_id}")
def get_actor(hosted: Held, actor_id: int) -> ActorView:
    """One actor."""
    with hosted.turn() as stage:
        return view_actor(find(stage, actor_id))


@router.delete("/actors/{actor_id}", status_code=204)
def remove_actor(hosted: Held, actor_id: int) -> None:
    """Takes an actor off the stage; its past stays in the log."""
    with hosted.turn() as stage:
        hosted.remove(find(stage, actor_id))


@router.get("/actors/{actor_id}/pose")
def get_pose(hosted: Held, actor_id: int) -> Pose:
    """The pose at the playhead, as numbers."""
    with hosted.turn() as stage:
        actor = find(stage, actor_id)
        pose, (position, heading) = actor.pose, actor.root
        return Pose(
            tick=stage.tick,
            state=actor.state,
            names=list(actor.role.character.skeleton.names),
            translation=pose.translation.tolist(),
            rotation=pose.rotation.tolist(),
            scale=pose.scale.tolist(),
            weights=pose.weights.tolist(),
            world=actor.world.tolist(),
            root={"position": [float(metres) for metres in position], "heading": float(heading)},
        )


@router.post("/events", status_code=202)
def post_event(hosted: Held, event: NewEvent, registry: Stages) -> Accepted:
    """An event for one actor or all; it counts in the next tick. Where the playhead is in the past, it goes to a fork."""
    return registry.post(hosted, event)


@router.post("/parameters", status_code=202)
def post_parameter(hosted: Held, parameter: NewParameter, registry: Stages) -> Accepted:
    """A parameter's value for one actor or all; it counts in the next tick."""
    return registry.set_parameter(hosted, parameter)
