"""Loop's subdivision: each triangle becomes four, and the surface smoother (C. Loop, 1987)."""

import numpy as np
from numpy.typing import NDArray
from shapes import Array

Faces = NDArray[np.int64]


def subdivided(points: Array, faces: Faces) -> tuple[Array, Faces]:
    """Points (V, n) and triangles (T, 3) once subdivided; the new points follow the old ones. Edges of one
    triangle alone are the border, which is smoothed by itself.
    """
    corners = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    opposite = np.concatenate([faces[:, 2], faces[:, 0], faces[:, 1]])
    edges, row, count = np.unique(np.sort(corners, 1), axis=0, return_inverse=True, return_counts=True)
    row = row.reshape(-1)
    across = np.zeros((len(edges), points.shape[1]))
    np.add.at(across, row, points[opposite])
    is_border = (count != 2)[:, None]
    ends = points[edges].sum(1)
    middles = np.where(is_border, ends / 2, 3 / 8 * ends + across / 8)
    middle = len(points) + row.reshape(3, -1).T
    a, b, c = faces.T
    ab, bc, ca = middle.T
    quarters = np.stack([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]).transpose(0, 2, 1)
    return np.concatenate([_moved(points, edges, is_border[:, 0]), middles]), quarters.reshape(-1, 3)


def _moved(points: Array, edges: Faces, is_border: NDArray[np.bool_]) -> Array:
    """The old points, each nearer to its neighbours."""
    inner, number = _sums(points, edges)
    share = np.where(number == 3, 3 / 16, 3 / (8 * np.maximum(number, 1)))
    inside = points * (1 - number * share) + share * inner
    rim, count = _sums(points, edges[is_border])
    return np.where(count == 2, points * 3 / 4 + rim / 8, np.where(count > 0, points, inside))


def _sums(points: Array, edges: Faces) -> tuple[Array, Array]:
    """The sum of the neighbours (V, n), and their number (V, 1)."""
    total, number = np.zeros_like(points), np.zeros((len(points), 1))
    for one, other in (edges.T, edges.T[::-1]):
        np.add.at(total, one, points[other])
        np.add.at(number, one, 1)
    return total, number
