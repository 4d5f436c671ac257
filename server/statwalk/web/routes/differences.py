"""GET /api/stages/{id}/differences: how far the actors of two stages, or in two spans of one, are apart."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Any

import numpy as np
from fastapi import APIRouter, Depends, Query

from statwalk.maths.arrays import Floats
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.differences import (
    ActorDifference,
    check_detailed,
    common_span,
    differences,
    in_model_space,
    moved,
)
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.hosting.stage_replies import JointTrack
from statwalk.web.bounded_json import BoundedRoute
from statwalk.web.dependencies import LongWorkToken, registry_of, stage_of
from statwalk.web.errors import Problem
from statwalk.web.schemas.base import Name, Tick
from statwalk.web.schemas.difference import (
    ActorDifferenceView,
    Detail,
    DifferencesView,
    JointDifferences,
    Space,
)

METRE_DIGITS, DEGREE_DIGITS = 6, 4
router = APIRouter(prefix="/api/stages", tags=["stages"], route_class=BoundedRoute)


@router.get("/{stage_id}/differences")
def get_differences(
    host: Annotated[StageHost, Depends(stage_of)],
    registry: Annotated[Registry, Depends(registry_of)],
    token: LongWorkToken,
    other_id: Annotated[Name, Query(alias="with")],
    start: Annotated[Tick | None, Query(alias="from")] = None,
    end: Annotated[Tick | None, Query(alias="to")] = None,
    other_start: Annotated[Tick | None, Query(alias="with_from")] = None,
    space: Space = "stage",
    detail: Detail = "summary",
) -> DifferencesView:
    """Compares the ticks `from` … `to` of two stages, by default the newest 600 that both have. With
    `with_from`, the ticks of the other stage, or of the same one, begin there.

    Actors are matched by id, their joints by name. `space`: places on the stage, or in model space, which are
    the same wherever an actor stands and looks.
    """
    other, later = registry.find(other_id), _later(start, other_start)
    span = common_span(host.handle(ask.Status()), other.handle(ask.Status()), start, end, later)
    here: Sequence[JointTrack] = host.handle(ask.Joints(*span), token).actors
    there = moved(other.handle(ask.Joints(*span.later(later)), token).actors, -later)
    if space == "model":
        here, there = in_model_space(here), in_model_space(there)
    found = differences(here, there)
    if detail == "joints":
        check_detailed(found)
    ids, others = ({track.actor for track in tracks} for tracks in (here, there))
    ticks = [tick for each in found if (tick := each.first_tick) is not None]
    return DifferencesView(
        stage=host.id,
        other=other.id,
        start=span.first,
        end=span.last,
        other_start=span.first + later,
        first_difference=min(ticks, default=None),
        note="" if found else _why_nothing(here, there),
        only_here=sorted(ids - others),
        only_there=sorted(others - ids),
        actors=[_view(each, is_detailed=detail == "joints") for each in found],
    )


def _later(start: int | None, other_start: int | None) -> int:
    """By how many ticks the span of the other stage is later."""
    if other_start is None:
        return 0
    if start is None:
        raise Problem(422, "with_from needs from: say where both spans begin", field="from")
    return other_start - start


def _why_nothing(here: Sequence[JointTrack], there: Sequence[JointTrack]) -> str:
    if {track.actor for track in here} & {track.actor for track in there}:
        return "the actors with the same ids have no joint of the same name, or no tick in common"
    return "no actor is on both stages in these ticks"


def _view(found: ActorDifference, *, is_detailed: bool) -> ActorDifferenceView:
    distance, angle = found.distance, found.angle
    return ActorDifferenceView(
        id=found.actor,
        name=found.name,
        joints=list(found.joints),
        ticks=list(range(found.first, found.first + len(distance))),
        root_distance=_metres(found.root_distance),
        root_angle_deg=_degrees(found.root_angle),
        distance=_metres(distance.max(1)),
        distance_joint=distance.argmax(1).tolist(),
        angle_deg=_degrees(angle.max(1)),
        angle_joint=angle.argmax(1).tolist(),
        joint_distance=_metres(distance.max(0)),
        joint_angle_deg=_degrees(angle.max(0)),
        by_tick=JointDifferences(distance=_metres(distance), angle_deg=_degrees(angle))
        if is_detailed
        else None,
    )


def _metres(numbers: Floats) -> list[Any]:
    rounded: list[Any] = np.round(numbers, METRE_DIGITS).tolist()
    return rounded


def _degrees(numbers: Floats) -> list[Any]:
    rounded: list[Any] = np.round(np.degrees(numbers), DEGREE_DIGITS).tolist()
    return rounded
