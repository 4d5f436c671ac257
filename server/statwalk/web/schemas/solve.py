"""The bodies of inverse kinematics: POST /api/characters/{name}/solve."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BeforeValidator, Field, Strict

from statwalk.web.schemas.base import Coordinate, Name, RequestModel, ResponseModel, Values, Vector

Point = Annotated[tuple[Coordinate, Coordinate, Coordinate], Strict(False)]
Quaternion = Annotated[tuple[Coordinate, Coordinate, Coordinate, Coordinate], Strict(False)]
Rotations = Annotated[dict[str, Quaternion], BeforeValidator(dict)]
"""local rotations x y z w by joint"""
Translations = Annotated[dict[str, Point], BeforeValidator(dict)]
"""local translations by joint, metres"""


class PoseSource(RequestModel):
    """The pose to solve: the rest pose, or a clip's pose at a time (seconds), with the given rotations and
    translations of joints on top.
    """

    clip: Name | None = None
    time: Annotated[float, Field(ge=0, le=1e6)] = 0.0
    rotations: Rotations = Field(default_factory=dict)
    translations: Translations = Field(default_factory=dict)


class NewSolve(RequestModel):
    """A chain of joints and its target, in model space, metres; the other members have the defaults of
    `Character.solve`. `machine`: its limits count in place of the character's.
    """

    chain: Annotated[list[Name], Field(min_length=1, max_length=256)]
    target: Point
    solver: Literal["two-bone", "ccd", "fabrik", "force", "look-at"] = "two-bone"
    pose: PoseSource = PoseSource()
    weight: Annotated[float, Field(ge=0, le=1)] = 1.0
    pole: Point | None = None
    pole_point: Point | None = None
    rotation: Quaternion | None = None
    softening: Annotated[float, Field(ge=0, le=1e6)] = 0.0
    tolerance: Annotated[float, Field(ge=1e-9, le=1e6)] = 1e-4
    iterations: Annotated[int, Field(ge=1, le=1_000)] | None = None
    sensitivity: Values = Field(default_factory=dict)
    forward: Point = (0.0, 0.0, 1.0)
    anchor: Annotated[str, Field(max_length=200)] = ""
    machine: Name | None = None


class SolvedJointView(ResponseModel):
    """A joint of the chain afterwards: its local rotation x y z w, its place in model space, metres."""

    name: str
    rotation: tuple[float, float, float, float]
    position: Vector


class SolveView(ResponseModel):
    """The solved chain, from start to end; `distance`: metres from the end to the target; `clamped`: the
    degrees by which limits cut the last turns of its joints; `root`: the translation of the skeleton's root,
    which moves if the chain's end is the anchor.
    """

    joints: list[SolvedJointView]
    reached: bool
    distance: float
    iterations: int
    clamped: dict[str, float]
    root: Vector
