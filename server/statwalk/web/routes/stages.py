"""/api/stages: open and close stages, and move them through time."""

from __future__ import annotations

import math
from dataclasses import asdict
from typing import Annotated, Any

from fastapi import APIRouter, Depends, Query, Response

from statwalk.machine.definition.framing import Framing
from statwalk.services.cancel import CancelToken
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.hosting.stage_replies import ActorFacts, StageFacts
from statwalk.services.hosting.store.records import MAIN
from statwalk.skin.skinning import Skinning
from statwalk.web.bounded_json import RoomyRoute
from statwalk.web.dependencies import DoerDep, LongWorkToken, registry_of, stage_of, token_of
from statwalk.web.errors import Problem
from statwalk.web.schemas.actor import ActorView, ClampedView, ReachedView
from statwalk.web.schemas.base import Tick
from statwalk.web.schemas.stage import (
    NewFork,
    NewStage,
    PauseBody,
    SeekBody,
    Speed,
    StageNameBody,
    StageView,
    StepBody,
)

LOG: dict[int | str, dict[str, Any]] = {
    200: {
        "description": "a LogHeader, then a LogLine for each command",
        "content": {"application/jsonl": {"schema": {"$ref": "#/components/schemas/LogLine"}}},
    }
}
router = APIRouter(prefix="/api/stages", tags=["stages"], route_class=RoomyRoute)
HostDep = Annotated[StageHost, Depends(stage_of)]
RegistryDep = Annotated[Registry, Depends(registry_of)]
Token = Annotated[CancelToken, Depends(token_of)]
GLB: dict[int | str, dict[str, Any]] = {200: {"content": {"model/gltf-binary": {}}}}


def view_actor(actor: ActorFacts) -> ActorView:
    """Returns the API's view of an actor."""
    return ActorView(
        id=actor.id,
        name=actor.name,
        machine=actor.machine,
        state=actor.state,
        states=list(actor.states),
        time=actor.time,
        position=list(actor.position),
        heading_deg=math.degrees(actor.heading),
        hash=actor.hash,
        variables=dict(actor.variables),
        channels=dict(actor.channels),
        parameters={
            name: list(value) if isinstance(value, tuple) else value
            for name, value in actor.parameters.items()
        },
        clamped=[
            ClampedView(
                joint=clamped.joint,
                angle_deg=math.degrees(clamped.angle),
                distance=clamped.distance,
                by=clamped.by,
            )
            for clamped in actor.clamped
        ],
        reached=[ReachedView(**found._asdict()) for found in actor.reached],
    )


def _view_stage(host: StageHost) -> StageView:
    return view_stage(host, host.handle(ask.Describe()))


def view_stage(host: StageHost, facts: StageFacts) -> StageView:
    """Returns the API's view of a stage."""
    place = asdict(facts.place)
    return StageView(
        id=facts.id,
        machines=list(place.pop("machines")),
        unclaimed=host.is_unclaimed,
        clock=facts.clock,
        rate=facts.rate,
        seed=facts.seed,
        seconds=facts.seconds,
        hash=facts.hash,
        asleep=facts.asleep,
        full=host.audience.is_full,
        actors=[view_actor(actor) for actor in facts.actors],
        **place,
        **asdict(facts.status),
    )


@router.get("")
def list_stages(registry: RegistryDep) -> list[StageView]:
    """Lists the stages; wakes none."""
    return [view_stage(host, host.look(ask.Describe())) for host in registry.all()]


@router.post("", status_code=201)
def open_stage(new: NewStage, registry: RegistryDep, response: Response, token: Token) -> StageView:
    """Opens a stage. With `clock: manual` only `step` moves it, as tests need."""
    host = registry.open(new.setup(), token)
    response.headers["Location"] = f"/api/stages/{host.id}"
    return _view_stage(host)


@router.get("/{stage_id}")
def get_stage(host: HostDep) -> StageView:
    """Returns a stage and its actors."""
    return _view_stage(host)


@router.patch("/{stage_id}")
def rename_stage(host: HostDep, body: StageNameBody) -> StageView:
    """Says what people call a stage; an empty name is none."""
    host.handle(ask.Rename(body.name.strip()))
    return _view_stage(host)


@router.delete("/{stage_id}", status_code=204)
def close_stage(stage_id: str, registry: RegistryDep) -> None:
    """Closes a stage, and disconnects its viewers with code 4404. You cannot close `main`."""
    if stage_id == MAIN:
        raise Problem(409, f"{MAIN!r} cannot be deleted: the page shows it first")
    registry.close(stage_id)


@router.post("/{stage_id}/step")
def step(host: HostDep, body: StepBody, token: LongWorkToken, doer: DoerDep) -> StageView:
    """Steps the stage by `ticks`, with any clock; stops early if the client disconnects."""
    host.handle(ask.Step(body.ticks, doer), token)
    return _view_stage(host)


@router.post("/{stage_id}/seek")
def seek(host: HostDep, body: SeekBody, token: LongWorkToken, doer: DoerDep) -> StageView:
    """Moves the playhead to a past tick; an input that you post there goes to a fork."""
    host.handle(ask.Seek(body.tick, doer), token)
    return _view_stage(host)


@router.post("/{stage_id}/pause")
def pause(host: HostDep, body: PauseBody, doer: DoerDep) -> StageView:
    """Stops or starts the clock."""
    host.handle(ask.Pause(body.paused, doer))
    return _view_stage(host)


@router.post("/{stage_id}/speed")
def speed(host: HostDep, body: Speed, doer: DoerDep) -> StageView:
    """Makes the clock run faster or slower."""
    host.handle(ask.SetSpeed(body.speed, doer))
    return _view_stage(host)


@router.post("/{stage_id}/fork", status_code=201)
def fork(
    host: HostDep,
    registry: RegistryDep,
    response: Response,
    token: LongWorkToken,
    body: NewFork | None = None,
) -> StageView:
    """Opens a new stage with the same past that continues from a tick, by default from the playhead."""
    new = body or NewFork()
    branch = registry.find(host.handle(ask.Fork(new.tick, new.name.strip()), token))
    response.headers["Location"] = f"/api/stages/{branch.id}"
    return _view_stage(branch)


@router.get("/{stage_id}/log", response_class=Response, responses=LOG)
def get_log(host: HostDep, token: LongWorkToken) -> Response:
    """Returns the log as JSON lines: a header, then every input. `replay` makes the same stage from it."""
    return Response("\n".join(host.handle(ask.Log(), token)) + "\n", media_type="application/jsonl")


@router.get("/{stage_id}/frame.glb", response_class=Response, responses=GLB)
def get_frame(
    host: HostDep,
    token: LongWorkToken,
    tick: Annotated[Tick | None, Query()] = None,
    skinning: Annotated[Skinning | None, Query()] = None,
) -> Response:
    """Returns the posed, skinned actors at a tick (by default the playhead) as a .glb with its images;
    `skinning` chooses a way of skinning for all of them.
    """
    data = host.handle(ask.FrameFile(tick, skinning), token)
    return Response(data, media_type="model/gltf-binary", headers={"Cache-Control": "no-cache"})


@router.get("/{stage_id}/recording.glb", response_class=Response, responses=GLB)
def get_recording(
    host: HostDep,
    token: LongWorkToken,
    start: Annotated[Tick, Query(alias="from")] = 0,
    end: Annotated[Tick | None, Query(alias="to")] = None,
    framing: Annotated[Framing | None, Query()] = None,
    actor: Annotated[int | None, Query()] = None,
) -> Response:
    """Returns the ticks `from` … `to` (by default the playhead) as one .glb with an animation, a key at each
    tick. With a `framing` it has a camera that follows the actor, by default the first.
    """
    data = host.handle(ask.Recording(start, end, (framing, actor) if framing else None), token)
    return Response(data, media_type="model/gltf-binary", headers={"Cache-Control": "no-cache"})
