"""The bodies of inverse kinematics: POST /api/characters/{name}/solve."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, Strict

from statwalk.web.schemas.base import Coordinate, Name, RequestModel, ResponseModel, Vector

Point = Annotated[tuple[Coordinate, Coordinate, Coordinate], Strict(False)]
Quaternion = Annotated[tuple[Coordinate, Coordinate, Coordinate, Coordinate], Strict(False)]
MOST_JOINTS = 1_000
JointName = Annotated[str, Field(max_length=200)]
Rotations = Annotated[dict[JointName, Quaternion], Field(max_length=MOST_JOINTS)]
"""local rotations x y z w by joint"""
Translations = Annotated[dict[JointName, Point], Field(max_length=MOST_JOINTS)]
"""local translations by joint, metres"""
Shares = Annotated[dict[JointName, Annotated[float, Field(ge=0, le=1)]], Field(max_length=MOST_JOINTS)]


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
    `Character.solve`.
    """

    chain: Annotated[
        list[Name],
        Field(min_length=1, max_length=256, description="joints from start to end, or the two alone"),
    ]
    target: Annotated[Point, Field(description="model space, metres, each within ±1,000,000")]
    solver: Literal["two-bone", "ccd", "fabrik", "force", "look-at"] = "two-bone"
    pose: PoseSource = PoseSource()
    weight: Annotated[float, Field(ge=0, le=1, description="0: the pose stays; 1: the solution")] = 1.0
    pole: Annotated[
        Point | None,
        Field(description="model space, a direction: where the middle joint goes; null: as it bends now"),
    ] = None
    pole_point: Annotated[
        Point | None, Field(description="model space, metres: the same as a point; null: none")
    ] = None
    rotation: Annotated[
        Quaternion | None,
        Field(
            description="model space, x y z w, above 0 long: the end's; null: it keeps that from its parent"
        ),
    ] = None
    softening: Annotated[
        float, Field(ge=0, le=1e6, description="metres before full stretch from which the chain eases")
    ] = 0.0
    tolerance: Annotated[
        float, Field(ge=1e-9, le=1e6, description="metres: nearer counts as reached, and ends the iterations")
    ] = 1e-4
    iterations: Annotated[
        int | None,
        Field(
            ge=1,
            le=2_000,
            description="at most; null: two-bone 16, ccd 256, fabrik 512, force 2,000, look-at 8",
        ),
    ] = None
    sensitivity: Annotated[
        Shares,
        Field(description="0…1 by joint: the part of a turn that it makes, else 1; not for two-bone"),
    ] = Field(default_factory=dict)
    forward: Annotated[
        Point,
        Field(description="look-at: the line of sight in the frame of the last joint, above 0 long"),
    ] = (0.0, 0.0, 1.0)
    anchor: Annotated[
        str,
        Field(
            max_length=200,
            description="the first joint of the chain, which stays, or the last: then the first comes to the "
            "target, and the root moves; empty: the first",
        ),
    ] = ""
    machine: Annotated[
        Name | None, Field(description="the machine whose limits count; null: the limits of the character")
    ] = None


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
