"""Surfaces of simple things: points (V, 3) metres, unit normals (V, 3), triangles (T, 3) seen from
outside.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Point = tuple[float, float, float]


class Mesh(NamedTuple):
    """A surface."""

    points: Array
    normals: Array
    faces: NDArray[np.int64]

    def moved(self, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> "Mesh":
        """The same somewhere else."""
        return self._replace(points=self.points + np.array([x, y, z]))

    def turned(self, matrix: Array) -> "Mesh":
        """The same under a rotation (3, 3)."""
        return self._replace(points=self.points @ matrix.T, normals=self.normals @ matrix.T)


def joined(*meshes: Mesh) -> Mesh:
    """Several surfaces as one."""
    starts = np.cumsum([0, *(len(mesh.points) for mesh in meshes)])
    faces = [mesh.faces + start for mesh, start in zip(meshes, starts, strict=False)]
    return Mesh(
        np.concatenate([mesh.points for mesh in meshes]),
        np.concatenate([mesh.normals for mesh in meshes]),
        np.concatenate(faces),
    )


def about_x(degrees: float) -> Array:
    """The rotation (3, 3) about X."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.array([[1, 0, 0], [0, c, -s], [0, s, c]])


def about_y(degrees: float) -> Array:
    """The rotation (3, 3) about Y."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])


def about_z(degrees: float) -> Array:
    """The rotation (3, 3) about Z."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def grid_faces(rows: int, columns: int) -> NDArray[np.int64]:
    """Triangles of a net of points whose last column meets its first."""
    row, column = np.meshgrid(np.arange(rows - 1), np.arange(columns), indexing="ij")
    a, b = row * columns + column, row * columns + (column + 1) % columns
    quads = np.stack([a, b, b + columns, a + columns], -1).reshape(-1, 4)
    return np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


def smooth(points: Array, faces: NDArray[np.int64]) -> Mesh:
    """A surface whose normals are the mean of the faces around, by their area; points at the same place share
    one.
    """
    corners = points[faces]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    _, same = np.unique(np.round(points, 6), axis=0, return_inverse=True)
    total = np.zeros((same.max() + 1, 3))
    for corner in range(3):
        np.add.at(total, same.ravel()[faces[:, corner]], across)
    normals = total[same.ravel()]
    size = np.linalg.norm(normals, axis=1, keepdims=True)
    used = np.linalg.norm(across, axis=1) > 1e-12
    return Mesh(points, normals / np.where(size > 0, size, 1), faces[used])


def box(size: Point, bevel: float = 0.01, steps: int = 3) -> Mesh:
    """A box around the origin with round edges: a ball whose eighths have been moved into the corners."""
    quarter = np.linspace(0, np.pi / 2, steps + 1)
    around, up = (
        np.concatenate([quarter + turn * np.pi / 2 for turn in range(4)]),
        np.concatenate([quarter - np.pi / 2, quarter]),
    )
    directions = [
        np.outer(np.cos(up), np.sin(around)),
        np.outer(np.sin(up), np.ones(len(around))),
        np.outer(np.cos(up), np.cos(around)),
    ]
    quadrant, upper = np.repeat(np.arange(4), steps + 1), np.repeat([-1, 1], steps + 1)
    signs = [
        np.outer(np.ones(len(up)), side[quadrant]) for side in np.array([[1, 1, -1, -1], [1, -1, -1, 1]])
    ]
    corners = np.stack([signs[0], np.outer(upper, np.ones(len(around))), signs[1]], -1)
    normals = np.stack(directions, -1)
    points = normals * bevel + corners * (np.array(size) / 2 - bevel)
    ring = np.arange(4) * (steps + 1)
    caps = [ring[::-1], ring + (len(up) - 1) * len(around)]
    flat = np.array([[cap[0], cap[one], cap[one + 1]] for cap in caps for one in (1, 2)])
    return Mesh(
        points.reshape(-1, 3),
        normals.reshape(-1, 3),
        np.concatenate([grid_faces(len(up), len(around)), flat]),
    )


def lathe(profile: Sequence[tuple[float, float]], segments: int = 24) -> Mesh:
    """(radius, height) turned about Y, from below to above; a corner of the profile is sharp where it is
    given twice.
    """
    radius, height = np.array(profile, float).T
    turn = np.linspace(0, 2 * np.pi, segments, endpoint=False)
    points = np.stack(
        [np.outer(radius, np.sin(turn)), np.outer(height, np.ones(segments)), np.outer(radius, np.cos(turn))],
        -1,
    )
    slope = _slopes(radius, height)
    normals = np.stack(
        [
            np.outer(slope[:, 0], np.sin(turn)),
            np.outer(slope[:, 1], np.ones(segments)),
            np.outer(slope[:, 0], np.cos(turn)),
        ],
        -1,
    )
    return Mesh(points.reshape(-1, 3), normals.reshape(-1, 3), grid_faces(len(radius), segments))


def _slopes(radius: Array, height: Array) -> Array:
    """Outward directions (K, 2) of a profile: the mean of both sides, of one side where a corner is sharp."""
    along = np.stack([np.diff(radius), np.diff(height)], -1)
    length = np.linalg.norm(along, axis=1, keepdims=True)
    out = np.stack([along[:, 1], -along[:, 0]], -1) / np.where(length > 0, length, 1)
    sides = np.concatenate([out[:1], out]) + np.concatenate([out, out[-1:]])
    return np.asarray(sides / np.maximum(np.linalg.norm(sides, axis=1, keepdims=True), 1e-9))


def ball(radius: float, segments: int = 16) -> Mesh:
    """A ball around the origin."""
    angle = np.linspace(-np.pi / 2, np.pi / 2, segments // 2 + 1)
    return lathe([(radius * float(np.cos(a)), radius * float(np.sin(a))) for a in angle], segments)


def loft(spine: Sequence[Point], width: Sequence[float], height: Sequence[float], segments: int = 16) -> Mesh:
    """Ellipses along a spine that runs from back to front; `width` and `height` are their half axes, 0 closes
    an end.
    """
    middle = np.array(spine, float)
    ahead = np.gradient(middle, axis=0)
    ahead /= np.linalg.norm(ahead, axis=1, keepdims=True)
    side = np.cross([0.0, 1, 0], ahead)
    side /= np.linalg.norm(side, axis=1, keepdims=True)
    up = np.cross(ahead, side)
    turn = np.linspace(0, 2 * np.pi, segments, endpoint=False)
    rings = (
        middle[:, None]
        + side[:, None] * np.outer(width, np.cos(turn))[..., None]
        + up[:, None] * np.outer(height, np.sin(turn))[..., None]
    )
    return smooth(rings.reshape(-1, 3), grid_faces(len(middle), segments))


def pipe(
    spine: Sequence[Point],
    side: Point,
    width: Sequence[float],
    height: Sequence[float],
    segments: int = 12,
) -> Mesh:
    """Ellipses along a spine that may go anywhere but along `side`: `width` is their half axis towards
    `side`, 0 closes an end.
    """
    middle = np.array(spine, float)
    ahead = np.gradient(middle, axis=0)
    ahead /= np.linalg.norm(ahead, axis=1, keepdims=True)
    up = np.cross(ahead, np.array(side, float))
    up /= np.linalg.norm(up, axis=1, keepdims=True)
    across = np.cross(up, ahead)
    turn = np.linspace(0, 2 * np.pi, segments, endpoint=False)
    rings = (
        middle[:, None]
        + across[:, None] * np.outer(width, np.cos(turn))[..., None]
        + up[:, None] * np.outer(height, np.sin(turn))[..., None]
    )
    return smooth(rings.reshape(-1, 3), grid_faces(len(middle), segments))


def wing(
    span: Sequence[float],
    front: Sequence[float],
    back: Sequence[float],
    thick: Sequence[float],
    rise: Sequence[float] | None = None,
) -> Mesh:
    """A wing out to +X: for each place along the span where it begins and ends (Z), half its thickness, and
    its height.
    """
    turn = np.linspace(0, 2 * np.pi, 12, endpoint=False)
    middle, half = (np.array(front) + back) / 2, (np.array(front) - back) / 2
    lift = np.zeros(len(span)) if rise is None else np.array(rise)
    z = middle[:, None] + np.outer(half, np.cos(turn))
    y = lift[:, None] + np.outer(thick, np.sin(turn))
    x = np.outer(span, np.ones(12))
    return smooth(np.stack([x, y, z], -1).reshape(-1, 3), grid_faces(len(span), 12)[:, ::-1])


def mirrored(mesh: Mesh) -> Mesh:
    """The same on the other side, −X."""
    flip = np.array([-1.0, 1, 1])
    return Mesh(mesh.points * flip, mesh.normals * flip, mesh.faces[:, ::-1])
