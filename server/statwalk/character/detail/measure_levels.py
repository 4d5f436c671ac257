"""Measures levels of detail against the full skin: at rest, and in frames of the clips."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from statwalk.character.character import Character
from statwalk.character.detail.poses import frames, posed_skin
from statwalk.maths.arrays import Floats, Ints
from statwalk.skin.detail.coarser import coarser_faces, faces_of
from statwalk.skin.detail.surface_distance import SurfaceDistance

FRAMES = 12


class MeasuredLevel(NamedTuple):
    """A level: what is left, and the largest distance from the full skin, metres.

    steps      the collapses that are made
    error      as the model stores it
    at_rest    measured in the pose at rest
    in_clips   the largest, measured in FRAMES frames of all clips; at rest without a clip
    """

    steps: int
    vertices: int
    triangles: int
    error: float
    at_rest: float
    in_clips: float


def measured_levels(character: Character) -> list[MeasuredLevel]:
    """Returns the levels of a character, from the full skin to the coarsest; empty without levels.

    All parts with collapses are measured as one surface; other parts are left out.
    """
    if not character.levels:
        return []
    skin = posed_skin(character)
    shapes = [skin.points(pose) for pose in (skin.rest, *frames(skin.clips, FRAMES))]
    full = _faces(character, 0)
    return [
        _measured(shapes, full, _faces(character, steps), steps, error)
        for steps, error in ((0, 0.0), *character.levels)
    ]


def _measured(shapes: list[Floats], full: Ints, coarse: Ints, steps: int, error: float) -> MeasuredLevel:
    distance = SurfaceDistance(shapes[0], full, coarse)
    errors = [distance.largest(points) if steps else 0.0 for points in shapes]
    used = len(np.unique(coarse))
    return MeasuredLevel(steps, used, len(coarse), error, errors[0], max(errors[1:] or errors))


def _faces(character: Character, steps: int) -> Ints:
    """The faces (T,3) of all parts with collapses after the steps below `steps`; vertices of all parts."""
    firsts = np.cumsum([0, *(len(part.positions) for part in character.parts)])
    faces = [
        first + (coarser_faces(part, steps) if steps else faces_of(part))
        for part, first in zip(character.parts, firsts, strict=False)
        if part.collapses is not None
    ]
    return np.concatenate(faces)
