"""POST /api/curves: key rotations by several interpolations; GET …/twinning and …/path of a clip."""

from __future__ import annotations

from math import degrees
from typing import Annotated

import numpy as np
from fastapi import APIRouter, Depends, Query

from statwalk.character.made_clips import sides_of
from statwalk.character.motion_path import motion_path
from statwalk.errors import ContentError, UnknownNameError
from statwalk.maths.arrays import Floats
from statwalk.motion.curve_samples import curve_samples
from statwalk.motion.keys.interpolations import INTERPOLATIONS
from statwalk.motion.principles.twinning import twinning
from statwalk.services.library.catalogue import Catalogue
from statwalk.web.bounded_json import BoundedRoute
from statwalk.web.dependencies import catalogue_of
from statwalk.web.errors import Problem
from statwalk.web.schemas.curve import (
    CurvesView,
    CurveView,
    MotionPathView,
    NewCurves,
    TwinningView,
    TwinView,
)

router = APIRouter(prefix="/api", tags=["curves"], route_class=BoundedRoute)
CatalogueDep = Annotated[Catalogue, Depends(catalogue_of)]
ClipName = Annotated[str, Query(alias="clip", min_length=1, max_length=200)]
JointName = Annotated[str, Query(alias="joint", min_length=1, max_length=200)]


@router.post("/curves")
def compare(body: NewCurves) -> CurvesView:
    """Interpolates key rotations by each of the named interpolations, and samples the curves as a tick
    does.
    """
    for name in body.interpolations:
        if name not in INTERPOLATIONS:
            raise UnknownNameError("interpolation", name, INTERPOLATIONS)
    times = np.array([key.time for key in body.keys])
    if (np.diff(times) < 1e-3).any():
        raise Problem(422, "the times of keys must rise by at least 0.001 s", field="keys")
    moments = np.linspace(times[0], times[-1], body.samples)
    curves = [_curve(body, times, name, moments) for name in body.interpolations]
    return CurvesView(times=moments.tolist(), curves=curves)


def _curve(body: NewCurves, times: Floats, name: str, moments: Floats) -> CurveView:
    angles = np.radians([(key.x_deg, key.y_deg, key.z_deg) for key in body.keys])
    weights = np.array([key.weight for key in body.keys])
    try:
        found = curve_samples(times, angles, weights, name, moments)
    except ContentError as error:
        none: list[float] = []
        return CurveView(
            interpolation=name,
            rotations=[],
            angle_deg=none,
            speed_deg=none,
            acceleration_deg=none,
            refused=error.message,
        )
    return CurveView(
        interpolation=name,
        rotations=[(x, y, z, w) for x, y, z, w in found.rotations.tolist()],
        angle_deg=np.degrees(found.angle).tolist(),
        speed_deg=np.degrees(found.speed).tolist(),
        acceleration_deg=np.degrees(found.acceleration).tolist(),
    )


@router.get("/characters/{name}/twinning", tags=["characters"])
def get_twinning(name: str, catalogue: CatalogueDep, clip: ClipName) -> TwinningView:
    """Returns how alike left and right move at the same moment of a clip."""
    character = catalogue.character(name)
    sides = sides_of(character)
    pairs = [
        TwinView(
            left=twin.left,
            right=twin.right,
            alike=twin.alike,
            twinned=twin.is_twinned,
            swing_deg=degrees(twin.swing),
        )
        for twin in twinning(character.clip(clip), sides)
    ]
    return TwinningView(clip=clip, pairs=pairs, alone=list(sides.alone))


@router.get("/characters/{name}/path", tags=["characters"])
def get_path(name: str, catalogue: CatalogueDep, clip: ClipName, joint: JointName) -> MotionPathView:
    """Returns the path (arc) of a joint through a clip."""
    times, positions = motion_path(catalogue.character(name), clip, joint)
    return MotionPathView(
        clip=clip, joint=joint, times=times.tolist(), positions=[(x, y, z) for x, y, z in positions.tolist()]
    )
