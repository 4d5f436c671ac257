"""A mesh for binding: vertices at one place are one vertex, so that seams of textures and normals do not
tear.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from statwalk.maths.arrays import Floats, Ints

SAME_PLACE = 1e-5
"""share of the diagonal below which two vertices are at one place"""


class Shell(NamedTuple):
    """N points (N,3) float64, triangles (T,3) of them, and the point of each of V vertices (V,)."""

    points: Floats
    triangles: Ints
    of_vertex: Ints

    @property
    def size(self) -> float:
        """Returns the length of the diagonal of the bounds."""
        return float(np.linalg.norm(np.ptp(self.points, axis=0)))

    def areas(self) -> Floats:
        """Returns (T,) the areas of the triangles."""
        a, b, c = (self.points[self.triangles[:, corner]] for corner in range(3))
        areas: Floats = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
        return areas


def welded(positions: Sequence[Floats], triangles: Sequence[Ints]) -> Shell:
    """Returns the shell of meshes: positions (V,3) and triangles (T,3) of each.

    Triangles with two corners at one place are left out.
    """
    every = np.concatenate([np.zeros((0, 3)), *positions]).astype(np.float64)
    first = np.cumsum([0, *(len(part) for part in positions)])[:-1]
    faces = np.concatenate(
        [np.zeros((0, 3), np.int64), *(rows + start for rows, start in zip(triangles, first, strict=True))]
    )
    if not len(every):
        return Shell(every, faces, np.zeros(0, np.int64))
    of_vertex, kept = _places(every)
    faces = of_vertex[faces]
    is_whole = (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 2] != faces[:, 0])
    return Shell(every[kept], faces[is_whole], of_vertex)


def _places(points: Floats) -> tuple[Ints, Ints]:
    """The number of each point's place (V,), and a point of each place (N,)."""
    low = points.min(0)
    step = max(float(np.linalg.norm(np.ptp(points, axis=0))) * SAME_PLACE, np.finfo(np.float64).tiny)
    cells = np.rint((points - low) / step).astype(np.int64)
    key = (cells[:, 0] * (1 << 20) + cells[:, 1]) * (1 << 20) + cells[:, 2]
    _, kept, of_vertex = np.unique(key, return_index=True, return_inverse=True)
    return of_vertex.reshape(-1), kept
