"""The edges of a surface along which a place may collapse, and the vertices that move then."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from scipy import sparse

from statwalk.maths.arrays import Bools, Floats, Ints

STEEPEST = 0.2
"""cosine of the largest turn of a triangle in a collapse"""


class Edges(NamedTuple):
    """Directed edges between places; a place is where vertices of all primitives lie together.

    start, end    (E,) places: `start` may collapse into `end`
    edge          (M,) the edge of each pair of vertices; pairs are sorted by edge
    vertex, onto  (M,) the vertices that move in a collapse, and the vertices that they move onto
    """

    start: Ints
    end: Ints
    edge: Ints
    vertex: Ints
    onto: Ints

    def take(self, kept: Bools) -> Edges:
        """Returns some of the edges (E,), with their pairs."""
        pairs = kept[self.edge]
        number = np.cumsum(kept) - 1
        return Edges(
            self.start[kept], self.end[kept], number[self.edge[pairs]], self.vertex[pairs], self.onto[pairs]
        )


def border_edges(faces: Ints, place: Ints) -> Ints:
    """Returns (E,2) the vertices at the ends of edges that belong to one triangle only, or whose two
    triangles have different vertices there: borders, seams of texture and normals, and ends of materials.
    """
    pairs = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
    edges, counts = np.unique(pairs, axis=0, return_counts=True)
    borders: Ints = edges[(counts == 1) & (place[edges[:, 0]] != place[edges[:, 1]])]
    return borders


def collapsible(faces: Ints, place: Ints, places: int) -> Edges:
    """Returns the edges of faces (T,3) along which a place may collapse without a tear and without a fold.

    Every vertex of the place moves along an edge of its own to exactly one vertex: a seam moves as a whole,
    along itself. A place on a border, or where more than two triangles meet at an edge, moves along it only.
    The neighbours that both ends share are the third corners of the edge's triangles, no others (the link
    condition), and the place has other triangles, too.
    """
    starts, ends = faces[:, [0, 1, 2, 1, 2, 0]].reshape(-1), faces[:, [1, 2, 0, 0, 1, 2]].reshape(-1)
    pairs, sides = np.unique(starts * len(place) + ends, return_counts=True)
    vertex, onto = np.divmod(pairs, len(place))
    names, edge = np.unique(place[vertex] * places + place[onto], return_inverse=True)
    edges = Edges(*np.divmod(names, places), edge.reshape(-1), vertex, onto)
    triangles = np.bincount(edges.edge, sides, len(names)).astype(np.int64)
    sharp = triangles != 2
    sharp_at = np.bincount(edges.start[sharp], minlength=places)[edges.start]
    along = (sharp_at == 0) | (sharp & (sharp_at == 2))
    around = np.bincount(place[faces].reshape(-1), minlength=places)[edges.start]
    link = sparse.csr_array((np.ones(len(names), np.int32), (edges.start, edges.end)), (places, places))
    shared = np.asarray((link @ link)[edges.start, edges.end]).reshape(-1)
    moves = _moves_whole(edges, faces, place, places)
    return edges.take(moves & (shared == triangles) & along & (around > triangles))


def _moves_whole(edges: Edges, faces: Ints, place: Ints, places: int) -> Bools:
    """(E,) whether every vertex of the edge's start has exactly one vertex at the edge's end to move onto."""
    live = np.zeros(len(place), bool)
    live[faces] = True
    vertices_at = np.bincount(place[live], minlength=places)
    movers = np.unique(edges.edge * len(place) + edges.vertex) // len(place)
    count = np.bincount(movers, minlength=len(edges.start))
    pairs = np.bincount(edges.edge, minlength=len(edges.start))
    whole: Bools = (count == pairs) & (count == vertices_at[edges.start])
    return whole


def folds(edges: Edges, points: Floats, faces: Ints, place: Ints) -> Bools:
    """Returns (E,) whether a collapse along an edge would turn a triangle over, or nearly on its side.

    points (P,3) are the places.
    """
    corners = place[faces]
    order = np.argsort(corners, axis=None, kind="stable")
    counts = np.bincount(corners.reshape(-1), minlength=len(points))
    first = np.cumsum(counts) - counts
    around = counts[edges.start]
    edge = np.repeat(np.arange(len(edges.start)), around)
    nth = np.arange(len(edge)) - np.repeat(np.cumsum(around) - around, around)
    triangle = order[first[edges.start[edge]] + nth] // 3
    kept = ~(corners[triangle] == edges.end[edge][:, None]).any(1)
    edge, triangle = edge[kept], triangle[kept]
    before = corners[triangle]
    after = np.where(before == edges.start[edge][:, None], edges.end[edge][:, None], before)
    old, new = _normals(points[before]), _normals(points[after])
    lengths = np.sqrt((old * old).sum(1) * (new * new).sum(1))
    turned = (old * new).sum(1) < STEEPEST * lengths
    turned |= ((new * new).sum(1) == 0) & ((old * old).sum(1) > 0)
    folded: Bools = np.bincount(edge[turned], minlength=len(edges.start)) > 0
    return folded


def _normals(corners: Floats) -> Floats:
    """(N,3) across the triangles (N,3,3), as long as twice their areas."""
    return np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
