"""The head's skin: loops round eyes and mouth, an even net between them, and a neck.

The points are put onto the field along rays from the head's middle; the net is the convex hull of their
directions, which is Delaunay's triangulation on a ball.
"""

from itertools import pairwise

import numpy as np
from curves import Array
from mesh.face import EYE_AT, MIDDLE, MOUTH_HALF, MOUTH_Y, Face
from mesh.features import eye_loops, mouth_loops
from mesh.patches import Net, Patch, cast, net
from mesh.surface import Indices, averaged, edges_of, project
from mesh.weights import step
from numpy.typing import NDArray
from scipy.spatial import ConvexHull, cKDTree

NECK = 24
FRONT_SPACING, BACK_SPACING = 0.066, 0.24
"""radians between the points of face and skull"""
COLLAR = (1.500, 1.470, 1.440)


def _unit(vectors: Array) -> Array:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=-1, keepdims=True))


def _onto(face: Face, points: Array) -> Array:
    return cast(face.skin, np.broadcast_to(MIDDLE, points.shape), points - MIDDLE, 0.2)


def _neckline(face: Face) -> Array:
    """The loop (K, 3) under the jaw at which the neck begins."""
    turn = 2 * np.pi * np.arange(NECK) / NECK
    height = 1.532 + 0.018 * (1 - np.cos(turn)) / 2 - 0.010 * np.maximum(np.cos(turn), 0) ** 2
    way = np.stack([np.sin(turn), np.zeros(NECK), np.cos(turn)], -1)
    origin = np.stack([np.zeros(NECK), height, np.full(NECK, -0.014)], -1)
    points = cast(face.skin, origin, way, 0.15)
    front = np.maximum(np.cos(turn), 0)[:, None] ** 1.5
    low = cast(face.skin, np.broadcast_to([0.0, 1.505, -0.016], way.shape), way, 0.12)
    return np.asarray(points * (1 - front) + low * front)


def _spread(fixed: Array, floor: Array) -> Array:
    """Directions (N, 3) of the left half between fixed ones: as near to each other as the place wants."""
    count = 6000
    height = 1 - (2 * np.arange(count) + 1) / count
    angle, radius = np.pi * (3 - np.sqrt(5)) * np.arange(count), np.sqrt(1 - height * height)
    some = np.stack([radius * np.cos(angle), height, radius * np.sin(angle)], -1)
    some = some[some[:, 0] >= 0]
    line = np.radians(np.linspace(-180, 180, 721))
    middle = np.stack([np.zeros(721), np.sin(line), np.cos(line)], -1)
    some = np.concatenate([middle, some])
    level = np.interp(np.arctan2(np.abs(some[:, 0]), some[:, 2]), *floor)
    some = some[(some[:, 1] > level) & ~_features(some)]
    spacing = _spacing(some)
    some = some[(some[:, 0] == 0) | (some[:, 0] > 0.5 * spacing)]
    spacing = _spacing(some)
    kept: list[Array] = []
    tree = cKDTree(fixed)
    away, _ = tree.query(some)
    for row, (point, space) in enumerate(zip(some, spacing, strict=True)):
        if away[row] > 0.72 * space and all(
            ((np.array(kept) - point) ** 2).sum(-1) > space**2 if kept else [True]
        ):
            kept.append(point)
    return np.array(kept)


def _spacing(way: Array) -> Array:
    """How far apart points are in a direction: near on nose and cheeks, far under the hair."""
    front = step(way[:, 2] - np.maximum(way[:, 1] - 0.3, 0), 0.05, 0.55)
    nose = step(way[:, 2], 0.85, 0.95) * (1 - step(np.abs(way[:, 1] + 0.1), 0.20, 0.32))
    return np.asarray(
        BACK_SPACING + (FRONT_SPACING - BACK_SPACING) * front - 0.022 * nose * (np.abs(way[:, 0]) < 0.25)
    )


def _features(way: Array) -> NDArray[np.bool_]:
    """Whether a direction of the left half lies within the loops of eye or mouth."""
    flat = MIDDLE[:2] + way[:, :2] * (0.095 / np.maximum(way[:, 2:], 1e-3))
    eye = (((flat - EYE_AT[:2]) / (0.034, 0.026)) ** 2).sum(1) < 1
    lips = ((flat - (0.0, MOUTH_Y)) / (MOUTH_HALF + 0.009, 0.019)) ** 2
    return np.asarray((way[:, 2] > 0.2) & (eye | (lips.sum(1) < 1)))


def _mirror(points: Array) -> Array:
    return points * (-1.0, 1.0, 1.0)


def make_head(face: Face) -> Patch:
    """The skin of head and neck, with a mouth that opens."""
    out = Net()
    rings = [eye_loops(face, out, "Left"), eye_loops(face, out, "Right"), mouth_loops(face, out)]
    neck = _neckline(face)
    rings.append(out.add(neck))
    bound = _unit(neck - MIDDLE)
    floor = (np.arctan2(np.abs(bound[:, 0]), bound[:, 2]), bound[:, 1])
    order = np.argsort(floor[0])
    fixed = np.array(out.points)[np.concatenate(rings)]
    free = _full(_spread(_unit(fixed - MIDDLE), (floor[0][order], floor[1][order] + 0.04)))
    points = np.concatenate([fixed, _onto(face, MIDDLE + 0.1 * free)])
    faces = _hull(points)
    for ring in _numbers(rings):
        faces = faces[~np.isin(faces, ring).all(1)]
    points = _settled(face, points, faces, len(fixed))
    number = np.concatenate([*rings, out.add(points[len(fixed) :])])
    out.cover("skin", number[faces])
    out.give("Jaw", number[len(fixed) :], _jaw(points[len(fixed) :]))
    _neck(face, out, rings[3])
    return out.patch()


def _neck(face: Face, out: Net, ring: Indices) -> None:
    """Rings from the jaw down into the collar."""
    turn = 2 * np.pi * np.arange(NECK) / NECK
    way = np.stack([np.sin(turn), np.zeros(NECK), np.cos(turn)], -1)
    origin = np.zeros((len(COLLAR), NECK, 3)) + np.array([0.0, 0.0, -0.018])
    origin[..., 1] = np.array(COLLAR)[:, None]
    rows = [ring, *out.add(cast(face.skull, origin, way, 0.12))]
    out.cover("skin", net(np.stack(rows[::-1]), closed=True))


def _full(half: Array) -> Array:
    return np.concatenate([half, _mirror(half[half[:, 0] > 1e-9])])


def _numbers(loops: list[Indices]) -> list[Indices]:
    starts = np.cumsum([0, *(len(loop) for loop in loops)])
    return [np.arange(a, b) for a, b in pairwise(starts)]


def _hull(points: Array) -> Indices:
    """The net of points seen from the head's middle, counter-clockwise from outside."""
    way = _unit(points - MIDDLE)
    faces = ConvexHull(way).simplices.astype(np.int64)
    corners = way[faces]
    inward = (np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) * corners[:, 0]).sum(
        1
    ) < 0
    faces[inward] = faces[inward][:, ::-1]
    return faces


def _settled(face: Face, points: Array, faces: Indices, fixed: int) -> Array:
    """The free points evenly between their neighbours."""
    edges = edges_of(faces)
    for _ in range(6):
        moved = points + 0.4 * (averaged(points, edges) - points)
        moved[np.abs(points[:, 0]) < 1e-9, 0] = 0.0
        points = np.concatenate([points[:fixed], project(face.skin, moved[fixed:], 1)])
    return np.concatenate([points[:fixed], project(face.skin, points[fixed:], 3)])


def _jaw(points: Array) -> Array:
    """How much of a place goes with the jaw: the chin wholly, the cheeks a little."""
    x, y, z = points.T
    below = step(MOUTH_Y - y, -0.014, 0.016)
    jaw = below * step(z - 0.9 * np.maximum(1.55 - y, 0), 0.02, 0.07) * (1 - step(np.abs(x), 0.040, 0.068))
    return np.asarray(jaw * (1 - step(1.545 - y, 0.0, 0.05) * (1 - step(z, 0.03, 0.06))))
