"""Ways through the middle of a body: a graph of its voxels, whose shortest ways keep far from the surface.

SciPy is imported on first use.
"""

from __future__ import annotations

from itertools import product
from typing import Any, NamedTuple

import numpy as np

from statwalk.maths.arrays import Floats, Ints
from statwalk.skin.binding.volume import Volume

CENTRING = 3
"""a step costs its length / depth³: ways keep to the middle"""
SMOOTHING = 2
"""neighbours on both sides over which a way is averaged"""
_NEIGHBOURS = [step for step in product((-1, 0, 1), repeat=3) if step > (0, 0, 0)]


class BodyGraph(NamedTuple):
    """The largest connected piece of a body, as N voxels.

    points (N,3), depth (N,): centres, and distances to the outside; length and cost (N,N): sparse matrices
    of the steps between neighbours; size: the side of a voxel
    """

    points: Floats
    depth: Floats
    length: Any
    cost: Any
    size: float

    def nearest(self, place: Floats) -> int:
        """Returns the voxel nearest to a place (3,)."""
        return int(((self.points - place) ** 2).sum(1).argmin())

    def lengths_from(self, source: int) -> Floats:
        """Returns (N,) the lengths of the shortest ways inside the body from a voxel."""
        from scipy.sparse.csgraph import dijkstra

        lengths: Floats = dijkstra(self.length, directed=False, indices=source)
        return lengths

    def ways_from(self, source: int) -> Ints:
        """Returns (N,) the voxel before each on its middle way from a voxel; negative: none."""
        from scipy.sparse.csgraph import dijkstra

        _, before = dijkstra(self.cost, directed=False, indices=source, return_predecessors=True)
        way: Ints = before
        return way

    def middle_way(self, source: int, target: int) -> Ints:
        """Returns the voxels of the middle way from one voxel to another."""
        return way_to(self.ways_from(source), target)

    def line(self, way: Ints) -> Floats:
        """Returns a smooth line (K,3) along a way; its ends stay."""
        points = self.points[way]
        if len(points) <= 2:
            return points
        padded = np.concatenate([points[:1]] * SMOOTHING + [points] + [points[-1:]] * SMOOTHING)
        shifted = [padded[k : k + len(points)] for k in range(2 * SMOOTHING + 1)]
        smooth: Floats = np.mean(shifted, 0)
        smooth[0], smooth[-1] = points[0], points[-1]
        return smooth


def way_to(before: Ints, target: int) -> Ints:
    """Returns the way from the source of `ways_from` to a voxel."""
    way = [target]
    while before[way[-1]] >= 0:
        way.append(int(before[way[-1]]))
    return np.array(way[::-1], np.int64)


def body_graph(volume: Volume) -> BodyGraph:
    """Returns the graph of the largest connected piece of a body."""
    from scipy import ndimage
    from scipy.sparse import coo_matrix

    pieces, _ = ndimage.label(volume.solid, np.ones((3, 3, 3)))
    largest = int(np.bincount(pieces.ravel())[1:].argmax()) + 1
    cells = np.argwhere(pieces == largest)
    row_of = np.full(volume.solid.shape, -1, np.int64)
    row_of[tuple(cells.T)] = np.arange(len(cells))
    depth = volume.depth[tuple(cells.T)]
    pairs, lengths = [], []
    for step in _NEIGHBOURS:  # the margin keeps neighbours inside the grid
        other = row_of[tuple((cells + step).T)]
        rows = np.flatnonzero(other >= 0)
        pairs.append(np.stack([rows, other[rows]]))
        lengths.append(np.full(len(rows), volume.size * np.linalg.norm(step)))
    row, column = np.concatenate(pairs, 1)
    length = np.concatenate(lengths)
    shallow = np.minimum(depth[row], depth[column]) / volume.size
    shape = len(cells), len(cells)
    return BodyGraph(
        volume.points(cells),
        depth,
        coo_matrix((length, (row, column)), shape).tocsr(),
        coo_matrix((length / shallow**CENTRING, (row, column)), shape).tocsr(),
        volume.size,
    )


def at_share(line: Floats, share: float) -> Floats:
    """Returns the point (3,) of a line (K,3) at a share of its length."""
    steps = np.append(0, np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1)))
    wanted = np.clip(share, 0, 1) * steps[-1]
    return np.array([np.interp(wanted, steps, line[:, axis]) for axis in range(3)])


def length_of(line: Floats) -> float:
    """Returns the length of a line (K,3)."""
    return float(np.linalg.norm(np.diff(line, axis=0), axis=1).sum())
