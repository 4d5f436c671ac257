"""Encodes the text messages from the server to a viewer as JSON."""

from __future__ import annotations

from dataclasses import asdict

from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.hosting.stage_messages import Status
from statwalk.services.hosting.stage_replies import Camera, Posted, Present, StageStatus
from statwalk.services.publish.layout import CastLayout, FrameLayout
from statwalk.services.publish.outbox import Ending, FrameForm
from statwalk.stage.state.frame import Action, Verdict
from statwalk.web.errors import Problem
from statwalk.web.schemas.base import Ref
from statwalk.web.schemas.server_messages import (
    AcceptedMessage,
    ActionMessage,
    CameraMessage,
    CastView,
    ErrorMessage,
    Forked,
    Hello,
    Pong,
    ServerMessage,
    StatusMessage,
    VerdictMessage,
    ViewersMessage,
)

VERSION = "statwalk.v1"
CLOSE_CODES: dict[Ending, int] = {
    "access ended": 4001,
    "slow": 4008,
    "too large": 4013,
    "too many messages": 4029,
    "deleted": 4404,
}


def _encoded(message: ServerMessage) -> bytes:
    return message.model_dump_json().encode()


def hello(host: StageHost, layout: FrameLayout, form: FrameForm, viewer: int) -> bytes:
    """Encodes the hello, which a viewer gets before the first frame of a layout."""
    return _encoded(
        Hello(
            version=VERSION,
            stage=host.id,
            viewer=viewer,
            epoch=layout.epoch,
            rate=host.rate,
            clock=host.clock_kind,
            frames=form.kind,
            skinning=form.skinning,
            casts=tuple(_cast(cast) for cast in layout.casts),
            **asdict(host.handle(Status())),
        )
    )


def _cast(cast: CastLayout) -> CastView:
    return CastView(**asdict(cast), machine=cast.role, model=f"/api/characters/{cast.character}/model.glb")


def fact(fact: Action | Verdict | StageStatus | Present | Camera) -> bytes:
    """Encodes an action, a verdict, a status, the viewers or a camera for viewers of a stage."""
    match fact:
        case Action():
            return _encoded(ActionMessage.model_validate(fact))
        case Verdict():
            return _encoded(VerdictMessage.model_validate(fact))
        case StageStatus():
            return _encoded(StatusMessage.model_validate(fact))
        case Present():
            return _encoded(ViewersMessage.model_validate(fact))
        case Camera():
            return _encoded(CameraMessage.model_validate(fact))


def accepted(ref: Ref, posted: Posted) -> bytes:
    """Encodes the answer to an accepted input."""
    return _encoded(AcceptedMessage(ref=ref, tick=posted.tick, seq=posted.seq, stage=posted.stage))


def forked(stage: str) -> bytes:
    """Encodes the message that an input went to a new stage."""
    return _encoded(Forked(stage=stage))


def pong(ref: Ref, tick: int) -> bytes:
    """Encodes the answer to a ping."""
    return _encoded(Pong(ref=ref, tick=tick))


def error(ref: Ref, problem: Problem) -> bytes:
    """Encodes the answer to a refused message."""
    return _encoded(ErrorMessage(**problem.body() | {"type": "error", "ref": ref}))
