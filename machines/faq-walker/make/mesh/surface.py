"""Points on the surface of a signed field: slopes, projection, and means over neighbours."""

import numpy as np
from curves import Array
from mesh.shapes import Field
from numpy.typing import NDArray

Indices = NDArray[np.int64]


def gradient(field: Field, points: Array, step: float = 1e-4) -> Array:
    """Slope of the field (V, 3) by central differences."""
    moves = np.eye(3) * step
    return np.stack([(field(points + move) - field(points - move)) / (2 * step) for move in moves], axis=-1)


def project(field: Field, points: Array, rounds: int = 2) -> Array:
    """The points moved onto the zero surface (Newton's steps, none longer than a centimetre)."""
    for _ in range(rounds):
        slope = gradient(field, points)
        move = -slope * (field(points) / np.maximum((slope**2).sum(-1), 1e-3))[:, None]
        length = np.linalg.norm(move, axis=-1, keepdims=True)
        points = points + move * np.minimum(1.0, 0.01 / np.maximum(length, 1e-12))
    return points


def averaged(values: Array, edges: Indices) -> Array:
    """Mean over the neighbours of every vertex, along edges (E, 2)."""
    total, count = np.zeros_like(values), np.zeros(len(values))
    for a, b in ((0, 1), (1, 0)):
        np.add.at(total, edges[:, a], values[edges[:, b]])
        np.add.at(count, edges[:, a], 1.0)
    return total / np.maximum(count, 1.0)[:, None]


def edges_of(faces: Indices) -> Indices:
    """Every edge of polygons (F, n) once, as (E, 2)."""
    pairs = np.stack([faces, np.roll(faces, -1, axis=1)], axis=-1).reshape(-1, 2)
    return np.unique(np.sort(pairs, axis=1), axis=0)
