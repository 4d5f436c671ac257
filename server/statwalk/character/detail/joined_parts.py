"""The triangles of all parts as one surface, whose corners are joined where only their normals differ."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from statwalk.errors import ContentError
from statwalk.maths.arrays import Floats, Ints
from statwalk.skin.collapses import same_rows
from statwalk.skin.detail.coarser import faces_of
from statwalk.skin.primitive import TRIANGLES, Primitive

MOST_TRIANGLES = 100_000
NORMAL, COLOUR, TEXTURE = 0.003, 0.02, 0.25
"""what a change of a unit normal, or of a colour, counts as: shares of the character's size; and of a place
in a texture: a share of the metres that the texture stretches over
"""


class JoinedParts(NamedTuple):
    """The parts in mode 4, each mesh once, as one array of vertices.

    rows      (V,) the places of its vertices among the vertices of all parts
    first     (P+1,) each part's first vertex in it
    faces     (T,3)
    normals   (V,3), zeros without normals
    attributes  (V,5) colours and places in a texture, zeros without
    """

    parts: tuple[Primitive, ...]
    rows: Ints
    first: Ints
    faces: Ints
    normals: Floats
    attributes: Floats


class Corners(NamedTuple):
    """Vertices of one part at one place that differ in their normals only are one corner: where a model is
    shaded flat, its surface still hangs together.
    """

    of_vertex: Ints
    """(V,)"""
    sample: Ints
    """(C,) a vertex of each corner"""


def joined(parts: Sequence[Primitive]) -> JoinedParts:
    """Returns the parts in mode 4 as one surface; a mesh that is on several nodes is there once.

    :raises ContentError: when there are no triangles in lists, or too many.
    """
    starts = np.cumsum([0, *(len(part.positions) for part in parts)])
    taken: dict[tuple[int, int], tuple[Primitive, int]] = {}
    for part, start in zip(parts, starts.tolist(), strict=False):
        if part.mode == TRIANGLES and len(faces_of(part)):
            taken.setdefault((part.mesh, part.primitive), (part, start))
    if not taken:
        raise ContentError("the model has no triangles in lists, so it has no level of detail")
    own = [part for part, _start in taken.values()]
    first = np.cumsum([0, *(len(part.positions) for part in own)])
    triangles = sum(len(faces_of(part)) for part in own)
    if max(triangles, int(first[-1])) > MOST_TRIANGLES:
        raise ContentError(
            f"the model has {triangles:,} triangles and {first[-1]:,} vertices; level of detail is found for "
            f"at most {MOST_TRIANGLES:,} of each"
        )
    return JoinedParts(
        tuple(own),
        np.concatenate([start + np.arange(len(part.positions)) for part, start in taken.values()]),
        first,
        np.concatenate([faces_of(part) + at for part, at in zip(own, first, strict=False)]),
        np.concatenate([np.zeros((len(p.positions), 3)) if p.normals is None else p.normals for p in own]),
        np.concatenate([_attributes(part) for part in own]),
    )


def _attributes(part: Primitive) -> Floats:
    """(V,5) colours and places in a texture."""
    columns = np.zeros((len(part.positions), 5))
    if "COLOR_0" in part.attributes:
        columns[:, :3] = np.clip(part.attributes["COLOR_0"][:, :3], 0, 1)
    if "TEXCOORD_0" in part.attributes:
        columns[:, 3:] = part.attributes["TEXCOORD_0"]
    return columns


def corners_of(joined: JoinedParts, shapes: Sequence[Floats]) -> Corners:
    """Returns the corners of the surface, whose vertices are at (V,3) in several poses."""
    part = np.repeat(np.arange(len(joined.parts)), np.diff(joined.first))
    columns = np.concatenate([part[:, None], *shapes, joined.attributes], axis=1)
    of_vertex = same_rows(columns)
    return Corners(of_vertex, np.unique(of_vertex, return_index=True)[1])


def with_attributes(joined: JoinedParts, corners: Corners, rest: Floats) -> Floats:
    """Returns the corners at rest (C,n): their places (C,3), and behind them what else should stay, in
    metres: the mean normal, the colour, and the place in a texture.
    """
    size = float(np.sqrt((np.ptp(rest[joined.faces].reshape(-1, 3), axis=0) ** 2).sum()))
    normals = np.zeros((len(corners.sample), 3))
    np.add.at(normals, corners.of_vertex, joined.normals)
    normals /= np.bincount(corners.of_vertex)[:, None]
    colours, texture = joined.attributes[:, :3], joined.attributes[:, 3:].copy()
    for part, start, end in zip(joined.parts, joined.first, joined.first[1:], strict=False):
        texture[start:end] *= TEXTURE * _stretch(rest[start:end], texture[start:end], faces_of(part))
    further = np.concatenate([COLOUR * size * colours, texture], axis=1)[corners.sample]
    columns = np.concatenate([NORMAL * size * normals, further], axis=1)
    used = np.abs(columns).max(axis=0, initial=0) > 0
    return np.concatenate([rest[corners.sample], columns[:, used]], axis=1)


def _stretch(points: Floats, places: Floats, faces: Ints) -> float:
    """How many metres of the surface the whole texture would stretch over."""
    sides = points[faces[:, 1:]] - points[faces[:, :1]]
    surface = np.sqrt((np.cross(sides[:, 0], sides[:, 1]) ** 2).sum(1)).sum()
    flat = places[faces[:, 1:]] - places[faces[:, :1]]
    texture = np.abs(flat[:, 0, 0] * flat[:, 1, 1] - flat[:, 0, 1] * flat[:, 1, 0]).sum()
    return float(np.sqrt(surface / texture)) if texture > 0 and np.isfinite(texture) else 0.0


def vertex_collapses(
    joined: JoinedParts, corners: Corners, moved: Ints, onto: Ints
) -> tuple[Ints, Ints, Ints]:
    """Returns the collapses of vertices that collapses of corners `moved` (K,) onto corners (K,) mean: each
    vertex moves onto the vertex of the other corner whose normal is nearest.

    Returns (N,) vertices, the vertices that they move onto, and the row of the collapse, in the same order.
    """
    order = np.argsort(corners.of_vertex, kind="stable")
    count = np.bincount(corners.of_vertex)
    first = np.cumsum(count) - count
    row, vertex = _members(moved, first, count, order)
    pair, goal = _members(onto[row], first, count, order)
    apart = ((joined.normals[vertex[pair]] - joined.normals[goal]) ** 2).sum(1)
    nearest = np.lexsort((apart, pair))
    _, best = np.unique(pair[nearest], return_index=True)
    return vertex, goal[nearest[best]], row


def _members(corners: Ints, first: Ints, count: Ints, order: Ints) -> tuple[Ints, Ints]:
    """The rows of some corners (K,) once for each of their vertices, and these vertices."""
    number = count[corners]
    row = np.repeat(np.arange(len(corners)), number)
    nth = np.arange(len(row)) - np.repeat(np.cumsum(number) - number, number)
    return row, order[first[corners][row] + nth]
