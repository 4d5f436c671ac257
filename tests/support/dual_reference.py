"""Dual-quaternion skin by the textbook, one vertex at a time in float64: rotations are SciPy's.

Each bone's rigid motion of the vertex is a dual quaternion q + ε·½·t·q. They are summed by weight, on the
side of the heaviest bone's, divided by the length of the real part, and read back as a rotation and a
translation (Kavan and others 2008, algorithm 1).
"""

import numpy as np
from scipy.linalg import polar
from scipy.spatial.transform import Rotation


def turned(linear):
    """The rotation closest to a matrix, and the stretch before it: R·S."""
    mirror = -1 if np.linalg.det(linear) < 0 else 1
    rotation, stretch = polar(mirror * linear)
    return rotation, mirror * stretch


def times(a, b):
    """The product of quaternions x y z w."""
    vector = a[3] * b[:3] + b[3] * a[:3] + np.cross(a[:3], b[:3])
    return np.array([*vector, a[3] * b[3] - a[:3] @ b[:3]])


def carried(matrices, weights, point, normal):
    """A point and its unit normal under bones (I,3,4) by weights (I,)."""
    real, dual, shape, leader = np.zeros(4), np.zeros(4), np.zeros((3, 3)), None
    for bone in np.argsort(-weights, kind="stable"):
        rotation, stretch = turned(matrices[bone][:, :3])
        q = Rotation.from_matrix(rotation).as_quat()
        leader = q if leader is None else leader
        q = -q if q @ leader < 0 else q
        moved = matrices[bone][:, :3] @ point + matrices[bone][:, 3]
        translation = np.array([*(moved - rotation @ point), 0])
        real += weights[bone] * q
        dual += weights[bone] * times(translation, q) / 2
        shape += weights[bone] * stretch
    length = np.linalg.norm(real)
    real, dual = real / length, dual / length
    rotation = Rotation.from_quat(real)
    translation = 2 * times(dual, real * [-1, -1, -1, 1])[:3]
    turned_normal = rotation.apply(np.linalg.inv(shape).T @ normal)
    return rotation.apply(point) + translation, turned_normal / np.linalg.norm(turned_normal)


def posed(surface, world):
    """Positions and normals (V,3) of a surface without morph targets, for world matrices (J,3,4)."""
    palette = surface.palette
    bind = np.concatenate([palette.inverse_bind, np.tile([[[0, 0, 0, 1]]], (len(palette.joints), 1, 1))], 1)
    matrices = world[palette.joints].astype(float) @ bind.astype(float)
    points = zip(surface.positions.T.astype(float), surface.normals.T.astype(float), strict=True)
    both = [
        carried(matrices[surface.bones[row]], surface.weights[row].astype(float), *vertex)
        for row, vertex in enumerate(points)
    ]
    return np.array([point for point, _ in both]), np.array([normal for _, normal in both])
