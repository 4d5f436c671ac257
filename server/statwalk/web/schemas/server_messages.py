"""The text messages that the server sends on the socket."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from statwalk.services.hosting.commands import ClockKind
from statwalk.services.publish.outbox import FrameKind
from statwalk.skin.skinning import Skinning
from statwalk.web.schemas.actor import Accepted
from statwalk.web.schemas.base import Place, Ref, ResponseModel, Values, Vector, VerdictWord
from statwalk.web.schemas.problem import ProblemView
from statwalk.web.schemas.stage import ClockChangeView
from statwalk.web.schemas.viewer import ViewerView


class ActorName(ResponseModel):
    """An actor of a cast."""

    id: int
    name: str


class CastCollider(ResponseModel):
    """A collider in metres, in the space of joint number `joint` (-1: the root's)."""

    name: str
    kind: Literal["sphere", "plane"]
    joint: int
    center: Vector
    radius: float
    normal: Vector


class CastView(ResponseModel):
    """The actors that share a character and a machine; `nodes[j]` is the model's node that joint j moves."""

    role: str
    character: str
    model: str
    machine: str
    version: int
    """the machine's version, counted by the stage"""
    joints: int
    weights: int
    names: tuple[str, ...]
    nodes: tuple[int, ...]
    parents: tuple[int, ...]
    layers: tuple[str, ...]
    states: tuple[str, ...]
    """the states of all layers"""
    state_layers: tuple[int, ...]
    """the layer of each state"""
    events: tuple[str, ...]
    colliders: tuple[CastCollider, ...]
    actors: tuple[ActorName, ...]
    skinning: Skinning
    """the character's way of skinning"""
    muscle_bones: tuple[int, ...]
    """the joints that only deform the skin"""


class Hello(ResponseModel):
    """The layout of the frames that follow, and the stage's status; `epoch` numbers the layouts
    of a stage.
    """

    type: Literal["hello"] = "hello"
    version: str
    stage: str
    viewer: int
    """your number among the viewers of the stage"""
    epoch: int
    rate: int
    clock: ClockKind
    frames: FrameKind
    skinning: Skinning | None
    """the way of skinning that the viewer chose for `glb`; null: each character's own"""
    tick: int
    head: int
    first: int
    paused: bool
    speed: float
    viewers: int
    restored: int | None
    """the tick at which the stage came back when the server started; null: it was opened since then"""
    pace: float
    """the part of the speed at which the stage runs; less than 1 while it takes more time than it may"""
    trouble: str
    """why nothing can be kept now, such as a full disk; empty while everything is kept"""
    changed: ClockChangeView | None
    """null: nobody has touched the clock since the stage was opened or came back"""
    casts: tuple[CastView, ...]


class StatusMessage(ResponseModel):
    """The status of the stage, sent on each change and once a second."""

    type: Literal["status"] = "status"
    tick: int
    head: int
    first: int
    paused: bool
    speed: float
    viewers: int
    restored: int | None
    """the tick at which the stage came back when the server started; null: it was opened since then"""
    pace: float
    """the part of the speed at which the stage runs; less than 1 while it takes more time than it may"""
    trouble: str
    """why nothing can be kept now, such as a full disk; empty while everything is kept"""
    changed: ClockChangeView | None
    """null: nobody has touched the clock since the stage was opened or came back"""


class ActionMessage(ResponseModel):
    """An action of a machine; `seq` numbers all actions of a stage from 1."""

    type: Literal["action"] = "action"
    seq: int
    tick: int
    actor: int
    name: str
    arguments: tuple[str | float, ...]
    other: int
    """the actor that was touched, or that raised the event; -1: none"""


class VerdictMessage(ResponseModel):
    """The verdict on an event, and its reason; `to` is empty if the state did not change, `cell` is null if
    the event has no cell.
    """

    type: Literal["verdict"] = "verdict"
    tick: int
    actor: int
    layer: int
    event: str
    verdict: VerdictWord
    reason: str
    from_state: Annotated[str, Field(alias="from")]
    to_state: Annotated[str, Field(alias="to")]
    cell: Place | None
    source: str
    line: int
    values: Values
    """the values that the cell's condition read"""
    other: int


class ViewersMessage(ResponseModel):
    """Who watches the stage, in the order in which they came: sent when it changes, at most once a second."""

    type: Literal["viewers"] = "viewers"
    viewers: tuple[ViewerView, ...]


class CameraMessage(ResponseModel):
    """The newest camera of the viewer that this viewer follows."""

    type: Literal["camera"] = "camera"
    viewer: int
    position: Vector
    target: Vector
    actor: int | None
    """`position` and `target` count from the root of this actor, and move with it; null: from the stage"""


class AcceptedMessage(Accepted):
    """The answer to an input with this `ref`."""

    type: Literal["accepted"] = "accepted"
    ref: Ref


class ErrorMessage(ProblemView):
    """The problem with the message that has this `ref`; `type` is "error", no problem type."""

    type: Literal["error"]
    ref: Ref


class Forked(ResponseModel):
    """An input at a past tick went to this new stage."""

    type: Literal["forked"] = "forked"
    stage: str


class Pong(ResponseModel):
    """The answer to a ping."""

    type: Literal["pong"] = "pong"
    ref: Ref
    tick: int


ServerMessage = Annotated[
    Hello
    | StatusMessage
    | ViewersMessage
    | CameraMessage
    | ActionMessage
    | VerdictMessage
    | AcceptedMessage
    | ErrorMessage
    | Forked
    | Pong,
    Field(discriminator="type"),
]
