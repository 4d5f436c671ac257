"""The bodies about interpolations compared: keys, and curves through or near them."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from statwalk.motion.keys.channel import WEIGHT_RANGE
from statwalk.web.schemas.base import Name, RequestModel, ResponseModel, Vector

MOST_KEYS, LONGEST, LARGEST_DEG, MOST_SAMPLES = 32, 60.0, 3600.0, 2000
Degrees = Annotated[float, Field(ge=-LARGEST_DEG, le=LARGEST_DEG)]


class NewKey(RequestModel):
    """A key: `time` in seconds, angles about X, then Y, then Z in degrees, and its weight in a NURBS."""

    time: Annotated[float, Field(ge=0, le=LONGEST)]
    x_deg: Degrees
    y_deg: Degrees
    z_deg: Degrees
    weight: Annotated[float, Field(ge=WEIGHT_RANGE[0], le=WEIGHT_RANGE[1])] = 1.0


class NewCurves(RequestModel):
    """Keys whose times rise, the names of interpolations, and how many samples of each to return."""

    keys: Annotated[list[NewKey], Field(min_length=2, max_length=MOST_KEYS)]
    interpolations: Annotated[list[Name], Field(min_length=1, max_length=16)]
    samples: Annotated[int, Field(ge=3, le=MOST_SAMPLES)] = 241


class CurveView(ResponseModel):
    """One interpolation of the keys; `rotations` are quaternions x y z w. `refused` says why there is no
    curve; the lists are empty then.
    """

    interpolation: str
    rotations: list[tuple[float, float, float, float]]
    angle_deg: list[float]
    """how far it has turned from the first key"""
    speed_deg: list[float]
    """angular speed, degrees per second"""
    acceleration_deg: list[float]
    """angular acceleration, degrees per second squared"""
    refused: str | None = None


class CurvesView(ResponseModel):
    """The curves over the same `times` in seconds."""

    times: list[float]
    curves: list[CurveView]


class TwinView(ResponseModel):
    """How alike two partners move at the same moment: 1 the same, 0 nothing in common, -1 opposite;
    `swing_deg` is how far they move.
    """

    left: str
    right: str
    alike: float
    twinned: bool
    swing_deg: float


class TwinningView(ResponseModel):
    """A clip's pairs of joints that move, the most alike first; `alone` are the joints with a side and no
    partner.
    """

    clip: str
    pairs: list[TwinView]
    alone: list[str]


class MotionPathView(ResponseModel):
    """The path of a joint through a clip, in the character's space: its `positions` in metres at `times`."""

    clip: str
    joint: str
    times: list[float]
    positions: list[Vector]
