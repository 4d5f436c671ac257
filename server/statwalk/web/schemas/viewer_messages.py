"""The messages that a viewer sends on the socket."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from statwalk.services.publish.outbox import FrameKind
from statwalk.skin.skinning import Skinning
from statwalk.web.schemas.actor import NewEvent, NewParameter
from statwalk.web.schemas.base import IdempotencyKey, Ref, RequestModel, Tick
from statwalk.web.schemas.stage import SeekBody


class Ack(RequestModel):
    """Acknowledges the frame of a tick."""

    type: Literal["ack"]
    tick: Tick


class PostEvent(NewEvent):
    """Sends an event at `tick`, by default the tick that the viewer watches; a past tick makes a fork."""

    type: Literal["event"]
    ref: Ref = None
    tick: Tick | None = None
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


class Ping(RequestModel):
    """Asks for a pong, to measure the round trip."""

    type: Literal["ping"]
    ref: Ref = None


ViewerMessage = Annotated[
    Ack | PostEvent | PostParameter | Look | Live | ChooseFrames | Ping, Field(discriminator="type")
]
