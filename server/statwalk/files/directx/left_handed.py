"""DirectX's conventions and glTF's.

DirectX is left-handed with rows as vectors: v' = v · M, the translation in the last row, and a triangle is
seen from the front when its corners run clockwise. glTF is right-handed with column vectors, and
counter-clockwise corners. Both have +Y up. The Z axis is turned round: a point (x, y, z) becomes (x, y, -z),
so that a figure that looks at the viewer still does, and its left hand stays its left hand. A matrix M
becomes S · Mᵀ · S with S = diag(1, 1, -1), corners are read in reverse, and a key's rotation w x y z (which
.x files store inverted) is the quaternion (x, y, -z, w).
"""

from __future__ import annotations

import numpy as np

from statwalk.maths.arrays import Floats

_POINT = np.array([1.0, 1.0, -1.0])
_SIGNS = np.array([[1, 1, -1, 1], [1, 1, -1, 1], [-1, -1, 1, -1], [1, 1, -1, 1]], np.float64)
_KEY = np.array([1.0, 1.0, -1.0, 1.0])


def mirrored(points: Floats) -> Floats:
    """Returns points or directions (…, 3) in the other convention, either way."""
    out: Floats = points * _POINT + 0.0  # no -0
    return out


def affine(matrices: Floats) -> Floats:
    """Returns the transforms (…, 3, 4) of matrices (…, 16), as a .x file writes them."""
    rows = matrices.reshape(*matrices.shape[:-1], 4, 4)
    return np.swapaxes(rows, -1, -2)[..., :3, :] * _SIGNS[:3]


def row_matrices(transforms: Floats) -> Floats:
    """Returns the matrices (…, 16), as a .x file writes them, of transforms (…, 3, 4)."""
    matrices = np.zeros((*transforms.shape[:-2], 4, 4))
    matrices[..., :3, :] = transforms
    matrices[..., 3, 3] = 1
    return np.swapaxes(matrices * _SIGNS, -1, -2).reshape(*transforms.shape[:-2], 16)


def rotations(keys: Floats) -> Floats:
    """Returns quaternions (…, 4) xyzw of a .x file's rotation keys w x y z."""
    quaternions: Floats = keys[..., [1, 2, 3, 0]] * _KEY
    return quaternions


def rotation_keys(quaternions: Floats) -> Floats:
    """Returns rotation keys (…, 4) w x y z of quaternions xyzw."""
    keys: Floats = (quaternions * _KEY)[..., [3, 0, 1, 2]]
    return keys
