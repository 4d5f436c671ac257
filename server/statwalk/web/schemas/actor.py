"""The bodies about actors and their inputs: events and parameters."""

from __future__ import annotations

import math
from typing import Annotated, Literal

from pydantic import Field

from statwalk.services.hosting.commands import AddActor, EventKind, SendEvent, SetParameter
from statwalk.web.schemas.base import ActorId, Coordinate, Name, RequestModel, ResponseModel


class NewActor(RequestModel):
    """An actor to add; `position` in metres, `heading_deg` in degrees about +Y."""

    machine: Name
    name: Name | None = None
    position: list[Coordinate] = Field([0.0, 0.0, 0.0], min_length=3, max_length=3)
    heading_deg: Coordinate = 0.0

    def command(self) -> AddActor:
        """Returns the command for the stage."""
        x, y, z = self.position
        return AddActor(self.machine, (x, y, z), math.radians(self.heading_deg), self.name)


class NewEvent(RequestModel):
    """An event for one actor, or (null) for all actors of the stage."""

    event: Name
    actor: ActorId | None = None
    kind: EventKind = "press"

    def command(self) -> SendEvent:
        """Returns the command for the stage."""
        return SendEvent(self.event, self.actor, self.kind)


class NewParameter(RequestModel):
    """A parameter's value for one actor, or (null) for all actors of the stage; a list for a point, direction
    or rotation.
    """

    parameter: Name
    value: Coordinate | Annotated[list[Coordinate], Field(min_length=3, max_length=4)]
    actor: ActorId | None = None

    def command(self) -> SetParameter:
        """Returns the command for the stage."""
        return SetParameter(self.parameter, self.value, self.actor)


class ClampedView(ResponseModel):
    """A joint that its limits changed in this tick: by how many degrees and metres, after blending (`motion`)
    or in inverse kinematics (`solver`: the last turn of the joint).
    """

    joint: str
    angle_deg: float
    distance: float
    by: Literal["motion", "solver"]


class ReachedView(ResponseModel):
    """What a solver of the machine file did in this tick: its weight 0…1, and the metres that are left to its
    target; `reached` if they are within its tolerance, never without weight.
    """

    solver: str
    weight: float
    distance: float
    reached: bool


class ActorView(ResponseModel):
    """An actor at the stage's playhead; `time` in seconds, `position` in metres, `heading_deg` about +Y."""

    id: int
    name: str
    machine: str
    state: str
    states: list[str]
    time: float
    position: list[float]
    heading_deg: float
    hash: str
    variables: dict[str, float]
    """the free variables of the expressions of the machine and its character"""
    channels: dict[str, float]
    """the channels of joints that expressions set: degrees, metres, scales"""
    parameters: dict[str, float | list[float]]
    """as they are set; points, directions and rotations as lists"""
    clamped: list[ClampedView]
    reached: list[ReachedView]


class Accepted(ResponseModel):
    """An input is logged and counts in the tick after `tick`; `seq` is its number in the log of `stage`: the
    stage, or a new fork.
    """

    tick: int
    seq: int
    stage: str


class RootView(ResponseModel):
    """An actor's root: `position` in metres, `heading` in radians about +Y."""

    position: list[float]
    heading: float


class PoseAnswer(ResponseModel):
    """An actor's pose: local transforms of J joints, world matrices (J,4,4) in row-major order, and the root
    on the stage.
    """

    tick: int
    state: str
    names: list[str]
    translation: list[list[float]]
    rotation: list[list[float]]
    scale: list[list[float]]
    weights: list[float]
    world: list[list[list[float]]]
    root: RootView
