"""Finds the order in which a character's vertices collapse, and how far every level is off (DS10)."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

import numpy as np

from statwalk.character.character import Character
from statwalk.character.detail.joined_parts import (
    Corners,
    JoinedParts,
    corners_of,
    joined,
    vertex_collapses,
    with_attributes,
)
from statwalk.character.detail.poses import measured_poses, posed_skin, telling_poses
from statwalk.maths.arrays import Floats, Ints
from statwalk.skin.collapses import Collapses, DetailLevel
from statwalk.skin.detail.collapse_order import CollapsePass, collapse_passes
from statwalk.skin.detail.surface_distance import SurfaceDistance
from statwalk.skin.primitive import TRIANGLES, Primitive

NEXT_LEVEL = 0.75
"""the share of the vertices that the next level has at most"""
Progress = Callable[[str, float], None]
"""gets the name of the work and the share that is done"""


def find_detail(character: Character, progress: Progress = lambda _work, _share: None) -> Character:
    """Returns the character with the order in which its vertices collapse, and its levels, finest first.

    Parts of points, lines, strips and fans stay as they are. A mesh that is on several nodes collapses as on
    the first of them. Errors are measured at rest, in the poses of `telling_poses`, and in those of
    `measured_poses`.

    :raises ContentError: when the character has no triangles in lists, or too many.
    """
    progress("posing the skin", 0.0)
    whole, skin = joined(character.parts), posed_skin(character)
    shapes = [skin.points(pose)[whole.rows] for pose in telling_poses(skin)]
    corners = corners_of(whole, shapes)
    faces, points = corners.of_vertex[whole.faces], [shape[corners.sample] for shape in shapes]
    progress("collapsing edges", 0.1)
    passes = list(collapse_passes([with_attributes(whole, corners, shapes[0]), *points[1:]], faces))
    steps = np.cumsum([0, *(int(made.order.max(initial=-1)) + 1 for made in passes)])
    chosen = _level_rows(faces, passes)
    moving = (skin.points(pose)[whole.rows][corners.sample] for pose in measured_poses(skin, len(points[0])))
    errors = _errors([*points, *moving], faces, [passes[row].faces for row in chosen], progress)
    levels = (DetailLevel(int(steps[row + 1]), error) for row, error in zip(chosen, errors, strict=True))
    parts = _with_collapses(character.parts, whole, corners, passes, steps)
    return replace(character, parts=parts, levels=tuple(levels))


def _level_rows(faces: Ints, passes: Sequence[CollapsePass]) -> list[int]:
    """The passes after which a level is left, with at most NEXT_LEVEL of the corners of the one before."""
    rows, left = [], len(np.unique(faces))
    for row, made in enumerate(passes):
        count = len(np.unique(made.faces))
        if count <= NEXT_LEVEL * left:
            rows.append(row)
            left = count
    return rows


def _errors(
    shapes: Sequence[Floats], full: Ints, levels: Sequence[Ints], progress: Progress
) -> Iterator[float]:
    """The error of each level, metres: the largest distance in any of the shapes, never less than that of a
    finer level.
    """
    worst = 0.0
    for number, faces in enumerate(levels):
        progress("measuring errors", 0.5 + 0.5 * number / len(levels))
        distance = SurfaceDistance(shapes[0], full, faces)
        for points in shapes:
            worst = distance.largest(points, worst)
        yield worst


def _with_collapses(
    parts: Sequence[Primitive],
    whole: JoinedParts,
    corners: Corners,
    passes: Sequence[CollapsePass],
    starts: Ints,
) -> tuple[Primitive, ...]:
    """The parts with the collapses of their own vertices."""
    none = np.zeros(0, np.int64)
    moved = np.concatenate([none, *(made.vertices for made in passes)])
    goals = np.concatenate([none, *(made.onto for made in passes)])
    steps = np.concatenate([none, *(made.order + start for made, start in zip(passes, starts, strict=False))])
    vertices, onto, row = vertex_collapses(whole, corners, moved, goals)
    of_mesh = {}
    for part, start, end in zip(whole.parts, whole.first, whole.first[1:], strict=False):
        own = (vertices >= start) & (vertices < end)
        arrays = (vertices[own] - start, onto[own] - start, steps[row[own]])
        of_mesh[part.mesh, part.primitive] = Collapses(*(values.astype(np.uint32) for values in arrays))
    return tuple(
        replace(part, collapses=of_mesh.get((part.mesh, part.primitive)) if part.mode == TRIANGLES else None)
        for part in parts
    )
