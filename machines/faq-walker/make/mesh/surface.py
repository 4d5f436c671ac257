"""A mesh from a signed field: naive surface nets (Gibson 1998) on a grid of uneven spacing, relaxed on the
surface.
"""

from collections.abc import Callable, Sequence

import numpy as np
from curves import Array
from numpy.typing import NDArray

Indices = NDArray[np.int64]
Field = Callable[[Array], Array]
CORNERS = np.array([(i, j, k) for i in (0, 1) for j in (0, 1) for k in (0, 1)])
EDGES = [(a, b) for a in range(8) for b in range(a + 1, 8) if np.abs(CORNERS[a] - CORNERS[b]).sum() == 1]


def spaced(segments: Sequence[tuple[float, float]], start: float) -> Array:
    """Grid lines from `start`: segments of (end, spacing)."""
    lines = [start]
    for end, spacing in segments:
        count = max(1, round((end - lines[-1]) / spacing))
        lines.extend(np.linspace(lines[-1], end, count + 1)[1:])
    return np.array(lines)


def surface_net(field: Field, lines: tuple[Array, Array, Array]) -> tuple[Array, Indices]:
    """Points (V, 3) and quads (Q, 4), counter-clockwise from outside, of the zero surface."""
    grid = np.stack(np.meshgrid(*lines, indexing="ij"), axis=-1)
    value = field(grid)
    shape = tuple(np.array(value.shape) - 1)
    inside = value < 0
    corner = [tuple(slice(c, c + s) for c, s in zip(at, shape, strict=True)) for at in CORNERS]
    count, total = np.zeros(shape), np.zeros((*shape, 3))
    for a, b in EDGES:
        va, vb = value[corner[a]], value[corner[b]]
        crossing = inside[corner[a]] != inside[corner[b]]
        f = np.where(crossing, va / np.where(crossing, va - vb, 1.0), 0.0)[..., None]
        total += np.where(crossing[..., None], grid[corner[a]] * (1 - f) + grid[corner[b]] * f, 0.0)
        count += crossing
    used = count > 0
    number = np.full(shape, -1)
    number[used] = np.arange(used.sum())
    return total[used] / count[used][:, None], _quads(inside, number)


def _quads(inside: NDArray[np.bool_], number: Indices) -> Indices:
    """One quad around every grid edge that goes through the surface."""
    quads = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        here = np.moveaxis(inside, (axis, u, v), (0, 1, 2))
        cells = np.moveaxis(number, (axis, u, v), (0, 1, 2))
        start, end = here[:-1, 1:-1, 1:-1], here[1:, 1:-1, 1:-1]
        ring = np.stack([cells[:, :-1, :-1], cells[:, 1:, :-1], cells[:, 1:, 1:], cells[:, :-1, 1:]], axis=-1)
        quads.extend([ring[start & ~end], ring[~start & end][:, ::-1]])
    return np.concatenate(quads)


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
    return total / count[:, None]


def edges_of(faces: Indices) -> Indices:
    """Every edge of polygons (F, n) once, as (E, 2)."""
    pairs = np.stack([faces, np.roll(faces, -1, axis=1)], axis=-1).reshape(-1, 2)
    return np.unique(np.sort(pairs, axis=1), axis=0)


def relaxed(field: Field, points: Array, quads: Indices, rounds: int) -> Array:
    """Points spread evenly over the surface: towards the mean of their neighbours, then back onto it."""
    edges = edges_of(quads)
    for _ in range(rounds):
        points = project(field, points + 0.5 * (averaged(points, edges) - points), 1)
    return project(field, points, 3)


def triangles(points: Array, quads: Indices) -> Indices:
    """Two triangles (T, 3) of each quad, along its shorter diagonal."""
    a, b, c, d = quads.T
    short = np.linalg.norm(points[a] - points[c], axis=1) <= np.linalg.norm(points[b] - points[d], axis=1)
    first = np.where(short[:, None], np.stack([a, b, c], 1), np.stack([a, b, d], 1))
    second = np.where(short[:, None], np.stack([a, c, d], 1), np.stack([b, c, d], 1))
    return np.concatenate([first, second])
