"""How far two triangle surfaces over the same vertices are apart, in any pose: the distance of sample points
of each from the other, the largest (Hausdorff).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from scipy.spatial import KDTree

from statwalk.maths.arrays import Floats, Ints

SAMPLES = 5_000
"""about as many points are spread over a surface"""
FINEST = 24
"""parts of the side of a triangle, at most"""
NEAREST = 3
"""the triangles of the nearest samples, with which a point is compared at first"""
MOST_EXACT = 200
"""points that are compared with all triangles"""


class Samples(NamedTuple):
    """Points of a surface: the corners (N,3) of their triangles, and their share (N,3) of each."""

    corners: Ints
    share: Floats

    def at(self, points: Floats) -> Floats:
        """Returns the points (N,3) for vertices (V,3)."""
        places: Floats = np.einsum("nk,nkx->nx", self.share, points[self.corners])
        return places


class Way(NamedTuple):
    """From one surface to the other.

    samples  points of the one
    target   points of the other
    faces    (T,3) the triangles of the other
    near     (N,3) the triangle of the other that seems to be nearest to each sample at rest
    """

    samples: Samples
    target: Samples
    faces: Ints
    near: Ints


class SurfaceDistance:
    """The distance between a surface and a coarser one over the same vertices, prepared for any number of
    poses.
    """

    def __init__(self, rest: Floats, full: Ints, coarse: Ints) -> None:
        """Prepares faces `full` (T,3) and `coarse` (C,3), neither empty, of vertices at `rest` (V,3)."""
        lost = np.setdiff1d(full, coarse)
        corners = Samples(np.repeat(lost[:, None], 3, 1), np.tile([1.0, 0.0, 0.0], (len(lost), 1)))
        spread_full, spread_coarse = spread(rest, full), spread(rest, coarse)
        self.ways = _way(rest, corners, spread_coarse, coarse), _way(rest, spread_coarse, spread_full, full)

    def largest(self, points: Floats, least: float = 0.0) -> float:
        """Returns the distance, metres, for the vertices (V,3) in a pose, or `least` if it is not larger,
        which takes a tenth of the time.
        """
        for way in self.ways:
            least = _largest(points, way, least)
        return least


def _way(rest: Floats, samples: Samples, target: Samples, faces: Ints) -> Way:
    nearest = _tree(target.at(rest)).query(samples.at(rest))[1]
    return Way(samples, target, faces, target.corners[nearest])


def _tree(points: Floats) -> KDTree:
    """Returns a tree that is asked once: an unbalanced one is made in less than half of the time."""
    return KDTree(points, compact_nodes=False, balanced_tree=False)


def _largest(points: Floats, way: Way, least: float) -> float:
    """The largest distance of the samples from the faces, or `least` if it is not larger: at first from the
    triangle that was nearest at rest, for those further away from the faces of the nearest target samples,
    and exactly for the samples that seem to be furthest.
    """
    place = way.samples.at(points)
    squared = squared_distance(place, points[way.near])
    further = squared > least * least
    if not further.any():
        return least
    place, squared = place[further], squared[further]
    count = min(NEAREST, len(way.target.corners))
    rows = _tree(way.target.at(points)).query(place, count)[1].reshape(len(place), count)
    for row in rows.T:
        squared = np.minimum(squared, squared_distance(place, points[way.target.corners[row]]))
    return max(least, float(np.sqrt(_settled(place, squared, points[way.faces], least * least))))


def _settled(points: Floats, squared: Floats, corners: Floats, least: float) -> float:
    """The largest squared distance of points (N,3) from triangles (T,3,3), at least `least`; `squared` (N,)
    are not smaller.
    """
    a, b, c = (corners[:, k] for k in range(3))
    middle = (a + b + c) / 3
    radius = np.sqrt(np.max([_dot(corner - middle, corner - middle) for corner in (a, b, c)], axis=0))
    largest, order = least, np.argsort(-squared)
    for row in order[:MOST_EXACT]:
        if squared[row] <= largest:
            return largest
        from_point = middle - points[row]
        away = np.sqrt(_dot(from_point, from_point)) - radius
        near = corners[away <= np.sqrt(squared[row])]
        largest = max(largest, float(squared_distance(points[row : row + 1], near).min(initial=squared[row])))
    return max(largest, float(squared[order[MOST_EXACT:]].max(initial=0)))


def spread(points: Floats, faces: Ints) -> Samples:
    """Returns about SAMPLES points, spread evenly over the faces (T,3), at least one on each."""
    corners = points[faces]
    sides = corners - np.roll(corners, 1, axis=1)
    longest = np.sqrt((sides * sides).sum(2).max(1))
    doubled = np.cross(sides[:, 0], sides[:, 1])
    area = np.sqrt((doubled * doubled).sum(1)).sum() / 2
    spacing = np.sqrt(2 * area / SAMPLES) or 1.0
    parts = np.clip(np.ceil(longest / spacing), 1, FINEST).astype(np.int64)
    rows, shares = [], []
    for count in np.unique(parts).tolist():
        lattice = _lattice(count)
        own = faces[parts == count]
        rows.append(np.repeat(own, len(lattice), axis=0))
        shares.append(np.tile(lattice, (len(own), 1)))
    return Samples(np.concatenate(rows), np.concatenate(shares))


def _lattice(count: int) -> Floats:
    """(count², 3) the middles of the small triangles in a triangle whose sides are cut in `count` parts."""
    upright = [(3 * i + 1, 3 * j + 1) for i in range(count) for j in range(count - i)]
    turned = [(3 * i + 2, 3 * j + 2) for i in range(count) for j in range(count - i - 1)]
    first, second = np.array(upright + turned).T / (3 * count)
    return np.stack([first, second, 1 - first - second], axis=1)


def squared_distance(points: Floats, corners: Floats) -> Floats:
    """Returns (N,) the squared distances of points (N,3) from triangles (N,3,3)."""
    a, b, c = (corners[:, k] for k in range(3))
    first, second, away = b - a, c - a, points - a
    one, both, two = _dot(first, first), _dot(first, second), _dot(second, second)
    along, across = _dot(away, first), _dot(away, second)
    square = one * two - both * both
    safe = np.where(square > 0, square, 1)
    u, v = (two * along - both * across) / safe, (one * across - both * along) / safe
    above = away - u[:, None] * first - v[:, None] * second
    edges = np.minimum(_to_segment(away, first), _to_segment(away, second))
    edges = np.minimum(edges, _to_segment(points - b, c - b))
    inside = (u >= 0) & (v >= 0) & (u + v <= 1) & (square > 0)
    return np.where(inside, _dot(above, above), edges)


def _to_segment(away: Floats, along: Floats) -> Floats:
    """The squared distances of points `away` (N,3) from one end of the segments `along` (N,3)."""
    square = _dot(along, along)
    share = np.clip(_dot(away, along) / np.where(square > 0, square, 1), 0, 1)
    apart = away - share[:, None] * along
    return _dot(apart, apart)


def _dot(a: Floats, b: Floats) -> Floats:
    products: Floats = np.einsum("nx,nx->n", a, b)
    return products
