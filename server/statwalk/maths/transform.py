"""Affine transforms (…, 3, 4): the rows [R | t] of a matrix that acts on column vectors, over any leading
axes.

`mul(a, b)` is b first, then a: world(child) = mul(world(parent), local(child)).
"""

from __future__ import annotations

import numpy as np

from statwalk.maths import quat, vector
from statwalk.maths.arrays import Bools, Floats

SKEW = 1e-3
"""largest cosine between two axes that count as at right angles"""


def from_trs(translation: Floats, rotation: Floats, scale: Floats) -> Floats:
    """Returns T · R · S (glTF 3.5.3) from translation (…, 3), rotation (…, 4) xyzw and scale (…, 3), all with
    the same leading axes.
    """
    linear = quat.to_matrix(rotation)
    columns = np.empty((4, 3, *linear.shape[:-2][::-1]), linear.dtype)  # as to_matrix: long rows for a crowd
    np.multiply(linear.T, scale.T[:, None], out=columns[:3])
    columns[3] = translation.T
    return columns.T


def to_trs(a: Floats) -> tuple[Floats, Floats, Floats]:
    """Returns translation (…, 3), rotation (…, 4) xyzw and scale (…, 3) of transforms without skew; a
    mirrored transform gets a negative X scale.
    """
    columns = np.swapaxes(a[..., :3], -1, -2)
    scale = vector.length(columns)
    axes = np.where(scale[..., None] == 0, np.eye(3), columns / np.where(scale == 0, 1, scale)[..., None])
    for flat in range(3):
        left, right = (flat + 1) % 3, (flat + 2) % 3
        only = (scale[..., flat] == 0) & (scale[..., left] > 0) & (scale[..., right] > 0)
        axes[only, flat] = vector.cross(axes[only, left], axes[only, right])
    mirror = np.where(np.linalg.det(axes) < 0, -1.0, 1.0)
    axes[..., 0, :] *= mirror[..., None]
    scale[..., 0] *= mirror
    return a[..., 3].copy(), quat.from_matrix(np.swapaxes(axes, -1, -2)), scale


def is_skewed(a: Floats) -> Bools:
    """Returns (…) whether the axes of a transform are not at right angles: it has no translation, rotation
    and scale of its own.
    """
    columns = np.swapaxes(a[..., :3], -1, -2)
    size = vector.length(columns)[..., None]
    axes = columns / np.where(size == 0, 1, size)
    angles = axes @ np.swapaxes(axes, -1, -2) * (1 - np.eye(3))
    return np.asarray(np.abs(angles).max((-1, -2)) > SKEW)


def mul(a: Floats, b: Floats) -> Floats:
    """Returns the transform that applies `b` first, then `a`."""
    product = a[..., :, 0, None] * b[..., None, 0, :]
    product += a[..., :, 1, None] * b[..., None, 1, :]
    product += a[..., :, 2, None] * b[..., None, 2, :]
    product[..., 3] += a[..., 3]
    return product


def apply_vector(a: Floats, vectors: Floats) -> Floats:
    """Returns directions (…, 3) under the linear part of `a`: not moved, only rotated and scaled."""
    x, y, z = vectors[..., 0:1], vectors[..., 1:2], vectors[..., 2:3]
    return a[..., 0] * x + a[..., 1] * y + a[..., 2] * z


def apply(a: Floats, points: Floats) -> Floats:
    """Returns points (…, 3) under `a`; one transform for many points needs a[..., None, :, :]."""
    return apply_vector(a, points) + a[..., 3]


def invert(a: Floats) -> Floats:
    """Returns the inverse of `a`; its linear part must not be singular."""
    x, y, z = a[..., 0], a[..., 1], a[..., 2]
    rows = np.stack([vector.cross(y, z), vector.cross(z, x), vector.cross(x, y)], -2)
    linear = rows / vector.dot(x, rows[..., 0, :])[..., None, None]
    back = linear[..., 0] * a[..., 0:1, 3] + linear[..., 1] * a[..., 1:2, 3] + linear[..., 2] * a[..., 2:3, 3]
    return np.concatenate([linear, -back[..., None]], -1)


def to_matrix4(a: Floats) -> Floats:
    """Returns the transforms as matrices (…, 4, 4) with the last row 0 0 0 1."""
    matrix = np.zeros((*a.shape[:-2], 4, 4), a.dtype)
    matrix[..., :3, :] = a
    matrix[..., 3, 3] = 1
    return matrix


def from_matrix4(matrix: Floats) -> Floats:
    """Returns the upper three rows of matrices (…, 4, 4) whose last row is 0 0 0 1."""
    return matrix[..., :3, :]
