"""The question to the twelve rules of inverse kinematics, and their answer."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field, Strict, StringConstraints

from statwalk.web.schemas.base import Name, RequestModel, ResponseModel, Vector

Number = Annotated[float, Field(ge=-1e9, le=1e9)]
Triple = Annotated[tuple[Number, Number, Number], Strict(False)]


class BoneBody(RequestModel):
    """A bone; a missing length or direction is not known."""

    parent: Name | None = None
    length: Annotated[float, Field(ge=0, le=1e9)] | None = None
    direction: Triple | None = None


class KnownBody(RequestModel):
    """What is known of a bone; null takes a value of the bones away."""

    RA_deg: Triple | None = None
    """Euler angles relative to the parent: about X first, then Y, then Z"""
    RM: Annotated[tuple[Triple, Triple, Triple], Strict(False)] | None = None
    """the rotation matrix from the bone's space to the character's, row by row"""
    SP: Triple | None = None
    """start point"""
    EP: Triple | None = None
    """end point"""
    TR: Triple | None = None
    """translation of the start away from the parent's end, in the parent's space"""
    DIR: Triple | None = None
    """direction in the bone's own space"""
    LEN: Annotated[float, Field(ge=0, le=1e9)] | None = None
    path: Annotated[tuple[Triple, Triple], Strict(False)] | None = None
    """two points of the motion path on which the bone slides"""
    bend: Triple | None = None
    """the direction in which the joint at the bone's start bends"""


class NewDeduction(RequestModel):
    """A question: a `file`, or bones (your own, of a `skeleton` or of a `character`) and what is known."""

    file: Annotated[str, StringConstraints(max_length=1 << 17)] | None = None
    """the text of a file as `statwalk deduce` reads it; without the other members"""
    character: Name | None = None
    """takes the bones of a character's joints in their pose at rest"""
    skeleton: Name | None = None
    """takes the bones of a skeleton that statwalk ships: `mammal` or `hand`"""
    bones: Annotated[dict[Name, BoneBody], Field(min_length=1, max_length=1000)] | None = None
    known: Annotated[dict[Name, KnownBody], Field(max_length=1000)] = Field(default_factory=dict)
    expressions: (
        Annotated[str, StringConstraints(max_length=1 << 17)]
        | Annotated[list[Annotated[str, StringConstraints(max_length=1000)]], Field(max_length=1024)]
    ) = Field(default_factory=list)
    """a text, or a list of its lines"""


class FoundView(ResponseModel):
    """A value and its source: `given`, `default`, `rule 8`, `expression, line 3`."""

    value: list[float]
    """one number, three, or nine (a matrix row by row); angles in degrees"""
    source: str


class DeducedBoneView(ResponseModel):
    """A bone with everything that is known of it."""

    name: str
    parent: int
    values: dict[str, FoundView]
    """by quantity: RA_deg RM SP EP TR DIR LEN"""
    unknown: list[str]
    start: Vector
    """for a drawing: SP, or where the bone would start at rest"""
    end: Vector


class DeductionView(ResponseModel):
    """What follows from the question."""

    bones: list[DeducedBoneView]
    """parents first"""
    variables: dict[str, float]
    """the free variables that expressions set"""
