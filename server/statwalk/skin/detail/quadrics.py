"""Quadric error metric: the squared distance of points from the planes of triangles, in any number of
dimensions (Garland & Heckbert, Simplifying Surfaces with Color and Texture using Quadric Error Metrics,
1998).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from statwalk.maths.arrays import Floats, Ints


class Quadrics(NamedTuple):
    """For each of V vertices the weighted sum of squared distances x·A·x + 2 b·x + c, and the sum of weights.

    matrix (V,n,n), vector (V,n), constant (V,), weight (V,)
    """

    matrix: Floats
    vector: Floats
    constant: Floats
    weight: Floats

    def at(self, rows: Ints, points: Floats) -> Floats:
        """Returns the sums (N,) of the vertices `rows` (N,) at points (N,n)."""
        bent = np.einsum("nab,nb->na", self.matrix[rows], points)
        sums: Floats = ((bent + 2 * self.vector[rows]) * points).sum(1) + self.constant[rows]
        return np.maximum(sums, 0)

    def add(self, rows: Ints, onto: Ints) -> None:
        """Adds the quadrics of the vertices `rows` to the quadrics of the vertices `onto`."""
        for values in self:
            np.add.at(values, onto, values[rows])


def _none(vertices: int, dimensions: int) -> Quadrics:
    return Quadrics(
        np.zeros((vertices, dimensions, dimensions)),
        np.zeros((vertices, dimensions)),
        np.zeros(vertices),
        np.zeros(vertices),
    )


def quadrics(points: Floats, faces: Ints, borders: Ints) -> Quadrics:
    """Returns the quadrics of points (V,n) under triangles (T,3), each weighted by its area, and under the
    edges `borders` (E,2): the distance from the edge's line, weighted by the square of its length.
    """
    total = _none(*points.shape)
    corners = points[faces]
    first, along = _unit(corners[:, 1] - corners[:, 0])
    side = corners[:, 2] - corners[:, 0]
    second, across = _unit(side - (side * first).sum(1)[:, None] * first)
    area = (along * across / 2)[:, 0]
    _add(total, faces, corners[:, 0], (first, second), area / 3)
    ends = points[borders]
    line, length = _unit(ends[:, 1] - ends[:, 0])
    _add(total, borders, ends[:, 0], (line,), length[:, 0] ** 2 / 2)
    return total


def _unit(vectors: Floats) -> tuple[Floats, Floats]:
    """Unit vectors (N,n), and the lengths (N,1)."""
    length = np.sqrt((vectors * vectors).sum(1, keepdims=True))
    return vectors / np.where(length > 0, length, 1), length


def _add(total: Quadrics, corners: Ints, origin: Floats, axes: tuple[Floats, ...], weight: Floats) -> None:
    """Adds to each of the corners (N,k) the squared distance from the flat (a plane or line) through the
    origin (N,n) along unit axes (N,n).
    """
    matrix = np.broadcast_to(np.eye(origin.shape[1]), (len(origin), *total.matrix.shape[1:])).copy()
    for axis in axes:
        matrix -= axis[:, :, None] * axis[:, None, :]
    vector = -np.einsum("nab,nb->na", matrix, origin)
    constant = -(vector * origin).sum(1)
    for k in range(corners.shape[1]):
        rows = corners[:, k]
        np.add.at(total.matrix, rows, weight[:, None, None] * matrix)
        np.add.at(total.vector, rows, weight[:, None] * vector)
        np.add.at(total.constant, rows, weight * constant)
        np.add.at(total.weight, rows, weight)
