"""/api/stages: open, close, and move through time."""

from __future__ import annotations

import math
from typing import Annotated, Any

from fastapi import APIRouter, Depends, Query, Response

from statwalk.stage.stage import Actor
from statwalk.web.door import registry_of, stage_of
from statwalk.web.jsonbody import BoundedRoute
from statwalk.web.keeping.hosted import HostedStage
from statwalk.web.keeping.recordings import recorded
from statwalk.web.keeping.registry import MAIN, Registry
from statwalk.web.problem import Problem
from statwalk.web.schemas import ActorView, NewStage, Pause, Seek, Speed, StageView, Step, Tick
from statwalk.web.streaming.glbframes import whole

router = APIRouter(prefix="/api/stages", tags=["stages"], route_class=BoundedRoute)
Held = Annotated[HostedStage, Depends(stage_of)]
Stages = Annotated[Registry, Depends(registry_of)]
GLB: dict[int | str, dict[str, Any]] = {200: {"content": {"model/gltf-binary": {}}}}


def view_actor(actor: Actor) -> ActorView:
    """An actor as the API shows it."""
    position, heading = actor.root
    return ActorView(
        id=actor.id,
        name=actor.name,
        machine=actor.role.name,
        state=actor.state,
        states=list(actor.states),
        time=float(actor.time),
        position=[float(metres) for metres in position],
        heading_deg=math.degrees(heading),
        hash=actor.hash,
    )


def view_stage(hosted: HostedStage) -> StageView:
    """A stage as the API shows it."""
    with hosted.turn() as stage:
        return StageView(
            id=hosted.id,
            clock=hosted.clock_kind,
            rate=stage.rate,
            seed=stage.seed,
            seconds=stage.seconds,
            hash=stage.hash,
            actors=[view_actor(actor) for actor in stage.actors],
            **hosted.status(),
        )


@router.get("")
def list_stages(registry: Stages) -> list[StageView]:
    """The stages that the server holds."""
    return [view_stage(hosted) for hosted in registry.all()]


@router.post("", status_code=201)
def open_stage(new: NewStage, registry: Stages, response: Response) -> StageView:
    """Opens a stage. With `clock: manual` it moves only when `step` says so: the way of tests."""
    hosted = registry.open(new)
    response.headers["Location"] = f"/api/stages/{hosted.id}"
    return view_stage(hosted)


@router.get("/{stage_id}")
def get_stage(hosted: Held) -> StageView:
    """A stage and its actors."""
    return view_stage(hosted)


@router.delete("/{stage_id}", status_code=204)
def close_stage(stage_id: str, registry: Stages) -> None:
    """Closes a stage; its viewers are sent away with code 4404. `main`, which the page opens on, stays."""
    if stage_id == MAIN:
        raise Problem(409, f"{MAIN!r} is the stage that the page opens on; it stays")
    registry.close(stage_id)


@router.post("/{stage_id}/step")
def step(hosted: Held, asked: Step) -> StageView:
    """So many ticks forward, whatever the clock."""
    hosted.step(asked.ticks)
    return view_stage(hosted)


@router.post("/{stage_id}/seek")
def seek(hosted: Held, asked: Seek) -> StageView:
    """Moves the playhead to a tick that was; what is posted there goes to a fork."""
    hosted.seek(asked.tick)
    return view_stage(hosted)


@router.post("/{stage_id}/pause")
def pause(hosted: Held, asked: Pause, registry: Stages) -> StageView:
    """Stops or starts the clock."""
    hosted.pause(asked.paused)
    registry.wake()
    return view_stage(hosted)


@router.post("/{stage_id}/speed")
def speed(hosted: Held, asked: Speed, registry: Stages) -> StageView:
    """Makes the clock run faster or slower."""
    hosted.set_speed(asked.speed)
    registry.wake()
    return view_stage(hosted)


@router.post("/{stage_id}/fork", status_code=201)
def fork(hosted: Held, registry: Stages, response: Response) -> StageView:
    """A new stage with the same past, from the playhead on its own."""
    branch = registry.fork(hosted)
    response.headers["Location"] = f"/api/stages/{branch.id}"
    return view_stage(branch)


@router.get("/{stage_id}/log", response_class=Response, responses={200: {"content": {"application/jsonl": {}}}})
def get_log(hosted: Held) -> Response:
    """The log as JSON lines: a header, then every input; `replay` makes the same stage of it."""
    with hosted.turn() as stage:
        return Response("\n".join(stage.dump()) + "\n", media_type="application/jsonl")


@router.get("/{stage_id}/frame.glb", response_class=Response, responses=GLB)
def get_frame(hosted: Held, tick: Annotated[Tick | None, Query()] = None) -> Response:
    """The posed, skinned stage at a tick (the playhead's, if none is given) as a complete .glb with its images."""
    stage = hosted.copy()
    if tick is not None:
        stage.seek(tick)
    return Response(whole(stage.frame), media_type="model/gltf-binary", headers={"Cache-Control": "no-cache"})


@router.get("/{stage_id}/recording.glb", response_class=Response, responses=GLB)
def get_recording(
    hosted: Held, start: Annotated[Tick, Query(alias="from")] = 0, end: Annotated[Tick | None, Query(alias="to")] = None
) -> Response:
    """The ticks `from` … `to` (the playhead's, if none is given) as one .glb with an animation, keyed at the stage's ticks."""
    stage = hosted.copy()
    last = stage.tick if end is None else end
    return Response(recorded(stage, start, last), media_type="model/gltf-binary", headers={"Cache-Control": "no-cache"})
