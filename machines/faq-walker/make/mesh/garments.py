"""Clothes: the mesh is cut along smooth lines, and what lies between them gets a material."""

from collections.abc import Callable

import numpy as np
from curves import Array
from mesh.figure import ARM_WAY, SHOULDER_AT, SOLE_Y, hairline
from mesh.surface import Indices
from skeleton import WRIST

Line = Callable[[Array], Array]

# name: linear colour, roughness
MATERIALS: dict[str, tuple[tuple[float, float, float], float]] = {
    "skin": ((0.80, 0.58, 0.44), 0.75),
    "shirt": ((0.85, 0.20, 0.09), 0.85),
    "trousers": ((0.055, 0.075, 0.115), 0.90),
    "shoes": ((0.86, 0.84, 0.80), 0.60),
    "soles": ((0.50, 0.48, 0.45), 0.80),
    "hair": ((0.045, 0.032, 0.028), 0.65),
}


def _arm_along(p: Array) -> Array:
    return (np.stack([np.abs(p[:, 0]), p[:, 1], p[:, 2]], axis=1) - SHOULDER_AT) @ ARM_WAY


def _cuff(p: Array) -> Array:
    on_arm = np.abs(p[:, 0]) > 0.30
    return np.where(on_arm, _arm_along(p) - (WRIST - 0.030), -1.0)


def _collar(p: Array) -> Array:
    return p[:, 1] - 1.478 + 0.35 * p[:, 2] - 0.9 * np.maximum(np.abs(p[:, 0]) - 0.045, 0.0)


def _belt(p: Array) -> Array:
    return np.where(np.abs(p[:, 0]) < 0.25, 0.982 + 0.03 * p[:, 2] - p[:, 1], -1.0)


def _ankle(p: Array) -> Array:
    return SOLE_Y + 0.128 - 0.10 * p[:, 2] - p[:, 1]


def _sole(p: Array) -> Array:
    return SOLE_Y + 0.024 + np.maximum(0, p[:, 2] - 0.11) * 0.28 - p[:, 1]


# in order: where the line's value is positive, the material takes over
CUTS: list[tuple[str, Line]] = [
    ("skin", _collar),
    ("skin", _cuff),
    ("trousers", _belt),
    ("shoes", _ankle),
    ("soles", _sole),
    ("hair", hairline),
]


def _cut(
    points: Array, weights: Array, faces: Indices, label: Indices, line: Line
) -> tuple[Array, Array, Indices, Indices]:
    """Split the triangles that a line crosses; vertices close to it are taken for lying on it."""
    value = line(points)
    value[np.abs(value) < 0.002] = 0.0
    signs = np.sign(value)[faces]
    crossed = (signs.min(1) < 0) & (signs.max(1) > 0)
    middle: dict[tuple[int, int], int] = {}
    new_points: list[Array] = []
    new_weights: list[Array] = []

    def between(a: int, b: int) -> int:
        key = (min(a, b), max(a, b))
        if key not in middle:
            f = value[key[0]] / (value[key[0]] - value[key[1]])
            middle[key] = len(points) + len(new_points)
            new_points.append(points[key[0]] * (1 - f) + points[key[1]] * f)
            new_weights.append(weights[key[0]] * (1 - f) + weights[key[1]] * f)
        return middle[key]

    pieces, labels = [], []
    for face, old in zip(faces[crossed], label[crossed], strict=True):
        ring: list[int] = []
        for a, b in zip(face, np.roll(face, -1), strict=True):
            ring.append(int(a))
            if value[a] * value[b] < 0:
                ring.append(between(int(a), int(b)))
        sign = [0.0 if v >= len(points) else value[v] for v in ring]
        for side in (1, -1):
            part = [v for v, s in zip(ring, sign, strict=True) if s * side >= 0]
            pieces.extend([(part[0], part[i], part[i + 1]) for i in range(1, len(part) - 1)])
            labels.extend([old] * (len(part) - 2))
    points = np.concatenate([points, np.array(new_points).reshape(-1, 3)])
    weights = np.concatenate([weights, np.array(new_weights).reshape(-1, weights.shape[1])])
    faces = np.concatenate([faces[~crossed], np.array(pieces, dtype=np.int64).reshape(-1, 3)])
    return points, weights, faces, np.concatenate([label[~crossed], np.array(labels, dtype=np.int64)])


def dress(points: Array, weights: Array, faces: Indices) -> tuple[Array, Array, dict[str, Indices]]:
    """Points, weights with the cuts in them, and the triangles of every material."""
    names = list(MATERIALS)
    label = np.full(len(faces), names.index("shirt"))
    for material, line in CUTS:
        points, weights, faces, label = _cut(points, weights, faces, label, line)
        label[line(points[faces].mean(1)) > 0] = names.index(material)
    return points, weights, {name: faces[label == index] for index, name in enumerate(names)}
