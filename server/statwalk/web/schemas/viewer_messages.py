"""The messages that a viewer sends on the socket."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, Strict

from statwalk.services.publish.outbox import FrameKind
from statwalk.skin.skinning import Skinning
from statwalk.web.schemas.actor import NewEvent, NewParameter
from statwalk.web.schemas.base import (
    ActorId,
    Coordinate,
    IdempotencyKey,
    Ref,
    RequestModel,
    Tick,
    ViewerName,
)
from statwalk.web.schemas.stage import SeekBody

Place3 = Annotated[tuple[Coordinate, Coordinate, Coordinate], Strict(False)]


class Ack(RequestModel):
    """Acknowledges the frame of a tick."""

    type: Literal["ack"]
    tick: Tick


class PostEvent(NewEvent):
    """Sends an event at `tick`, by default the tick that the viewer watches; a past tick makes a fork. With
    `now` the event counts in the present, whatever the viewer watches.
    """

    type: Literal["event"]
    ref: Ref = None
    tick: Tick | None = None
    now: bool = False
    key: IdempotencyKey = ""


class PostParameter(NewParameter):
    """Sets a parameter."""

    type: Literal["set"]
    ref: Ref = None
    key: IdempotencyKey = ""


class Look(SeekBody):
    """Shows a past tick to this viewer alone."""

    type: Literal["look"]


class Live(RequestModel):
    """Returns this viewer to the present."""

    type: Literal["live"]


class ChooseFrames(RequestModel):
    """Chooses the kind of frame for this viewer, and for `glb` the way of skinning (null: each character's
    own).
    """

    type: Literal["frames"]
    frames: FrameKind
    skinning: Skinning | None = None


class PresenceMessage(RequestModel):
    """The base of what a viewer says of itself to the others."""


class GiveName(PresenceMessage):
    """Says what this viewer calls itself; empty: nothing."""

    type: Literal["name"]
    name: ViewerName


class Watch(PresenceMessage):
    """Says which actor this viewer looks at; null: none."""

    type: Literal["watch"]
    actor: ActorId | None


class MoveCamera(PresenceMessage):
    """Says where this viewer looks from, and at what, for those that follow it."""

    type: Literal["camera"]
    position: Place3
    target: Place3
    actor: ActorId | None = None
    """`position` and `target` count from the root of this actor, and move with it; null: from the stage"""


class Follow(PresenceMessage):
    """Asks for the camera of another viewer from now on; null: of none."""

    type: Literal["follow"]
    viewer: Annotated[int, Field(ge=1, le=2**53)] | None


class Ping(RequestModel):
    """Asks for a pong, to measure the round trip."""

    type: Literal["ping"]
    ref: Ref = None


ViewerMessage = Annotated[
    Ack
    | PostEvent
    | PostParameter
    | Look
    | Live
    | ChooseFrames
    | GiveName
    | Watch
    | MoveCamera
    | Follow
    | Ping,
    Field(discriminator="type"),
]
