"""How far two stages are apart, tick by tick and joint by joint; metres and degrees."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from statwalk.web.schemas.base import ResponseModel

Detail = Literal["summary", "joints"]
Space = Literal["stage", "model"]


class JointDifferences(ResponseModel):
    """Of each tick, of each joint."""

    distance: list[list[float]]
    angle_deg: list[list[float]]


class ActorDifferenceView(ResponseModel):
    """How far an actor is from the actor with its id on the other stage. A list has a number for each tick of
    `ticks`, or for each joint of `joints`.
    """

    id: int
    name: str
    joints: list[str]
    """that both have"""
    ticks: list[int]
    """at which both stages have the actor"""
    root_distance: list[float]
    """by tick: of the places of the actor"""
    root_angle_deg: list[float]
    """by tick: of its headings"""
    distance: list[float]
    """by tick: of the joint that is farthest apart"""
    distance_joint: list[int]
    """by tick: which one that is, an index into `joints`"""
    angle_deg: list[float]
    """by tick: of the joint whose rotation to its parent differs most"""
    angle_joint: list[int]
    joint_distance: list[float]
    """by joint: the largest of all ticks"""
    joint_angle_deg: list[float]
    by_tick: JointDifferences | None
    """null in a summary"""


class DifferencesView(ResponseModel):
    """The differences of two stages in the ticks `from` to `to`."""

    stage: str
    other: str
    start: Annotated[int, Field(alias="from")]
    end: Annotated[int, Field(alias="to")]
    other_start: Annotated[int, Field(alias="with_from")]
    """the tick of the other stage that is compared with `from`"""
    first_difference: int | None
    """the first of these ticks at which an actor differs; null: none does"""
    note: str
    """why nothing is compared; empty if something is"""
    only_here: list[int]
    """actors that only the stage has in these ticks"""
    only_there: list[int]
    actors: list[ActorDifferenceView]
