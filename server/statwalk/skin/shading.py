"""Smooth normals for meshes without normals, each face weighted by its area."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Floats, Ints
from statwalk.skin.rows import unit

STRIP, FAN = 5, 6
MOST_AT_ONCE = 1 << 18


def triangles(indices: Ints, mode: int) -> Ints:
    """Returns (T,3) the vertex numbers of a triangle list, strip or fan (glTF modes 4, 5, 6)."""
    if mode == STRIP:
        rows = np.stack([indices[:-2], indices[1:-1], indices[2:]], axis=1)
        rows[1::2] = rows[1::2, [1, 0, 2]]
        return rows
    if mode == FAN:
        return np.stack([indices[1:-1], indices[2:], np.broadcast_to(indices[0], len(indices) - 2)], axis=1)
    return indices[: len(indices) // 3 * 3].reshape(-1, 3)


def smooth_normals(positions: Floats, faces: Ints) -> NDArray[np.float32]:
    """Returns unit normals (V,3) of positions (V,3) under faces (T,3); vertices without a face get +Z."""
    total = np.zeros(positions.shape)
    for start in range(0, len(faces), MOST_AT_ONCE):
        _add_areas(total, positions, faces[start : start + MOST_AT_ONCE])
    return np.ascontiguousarray(unit(total.T, np.zeros((3, 1))).T, np.float32)


def _add_areas(total: Floats, positions: NDArray[np.float32], faces: Ints) -> None:
    """Adds twice each face's area, along its normal, to its corners in `total` (V,3)."""
    corner = positions[faces].astype(np.float64)
    area = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    for k in range(3):
        np.add.at(total, faces[:, k], area)
