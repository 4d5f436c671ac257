"""Affine matrices as rows of numbers, one column per vertex: (…,12,V), or (…,12,1) where all vertices share one.

Row 4·r + c is the element in row r, column c of the (3,4) matrix. Every operation then runs along contiguous vertices.
"""

from __future__ import annotations

import numpy as np

from statwalk.maths.arrays import Floats

SMALLEST_LENGTH = 1e-30


def rows_of(matrices: Floats) -> Floats:
    """(…,K,3,4) matrices as rows (…,12,K)."""
    flat = matrices.reshape(*matrices.shape[:-2], 12)
    return np.ascontiguousarray(np.swapaxes(flat, -1, -2))


def points(rows: Floats, xyz: Floats) -> Floats:
    """The points (…,V,3) moved by the matrices."""
    x, y, z = xyz[..., 0], xyz[..., 1], xyz[..., 2]
    r = np.moveaxis(rows, -2, 0)
    return stacked([r[4 * k] * x + r[4 * k + 1] * y + r[4 * k + 2] * z + r[4 * k + 3] for k in range(3)])


def normals(rows: Floats, xyz: Floats) -> Floats:
    """The unit normals (…,V,3) of a surface moved by the matrices: turned by the inverse transpose.

    The cofactors are the inverse transpose times the determinant, whose sign is kept (mirrors) and whose size the length removes.
    Where a matrix is flat the normal may vanish; the source's normal stays then.
    """
    m = np.moveaxis(rows, -2, 0)
    x, y, z = xyz[..., 0], xyz[..., 1], xyz[..., 2]
    cofactor = [cofactor_row(m, k) for k in range(3)]
    determinant = m[0] * cofactor[0][0] + m[1] * cofactor[0][1] + m[2] * cofactor[0][2]
    sign = np.where(determinant < 0, -1, 1).astype(rows.dtype)
    return unit(stacked([(c[0] * x + c[1] * y + c[2] * z) * sign for c in cofactor]), xyz)


def cofactor_row(m: Floats, row: int) -> tuple[Floats, Floats, Floats]:
    """One row of the cofactor matrix of the upper left 3x3 block: the cross product of the other two rows."""
    a, b = 4 * ((row + 1) % 3), 4 * ((row + 2) % 3)
    return (
        m[a + 1] * m[b + 2] - m[a + 2] * m[b + 1],
        m[a + 2] * m[b] - m[a] * m[b + 2],
        m[a] * m[b + 1] - m[a + 1] * m[b],
    )


def unit(vectors: Floats, otherwise: Floats) -> Floats:
    """Vectors (…,V,3) at unit length; where one has no length, the unit vector along `otherwise` or, failing that, +Z."""
    squared = vectors[..., 0] ** 2 + vectors[..., 1] ** 2 + vectors[..., 2] ** 2
    if squared.size == 0 or squared.min() > SMALLEST_LENGTH:
        return np.asarray(vectors / np.sqrt(squared)[..., None])
    return repaired(vectors, otherwise)


def repaired(vectors: Floats, otherwise: Floats) -> Floats:
    """The slow way of `unit`: scales each vector first, so that tiny ones keep their direction."""
    whole = np.where(largest(vectors) > 0, vectors, otherwise)
    size = largest(whole)
    whole = np.where(size > 0, whole / np.where(size > 0, size, 1), np.array([0, 0, 1], vectors.dtype))
    length = np.sqrt(whole[..., 0] ** 2 + whole[..., 1] ** 2 + whole[..., 2] ** 2)
    return np.asarray(whole / length[..., None], vectors.dtype)


def largest(vectors: Floats) -> Floats:
    """The largest component's size of each vector, (…,V,1)."""
    return np.asarray(np.abs(vectors).max(axis=-1, keepdims=True))


def stacked(components: list[Floats]) -> Floats:
    """Three arrays (…,V) as one (…,V,3)."""
    out = np.empty((*components[0].shape, 3), components[0].dtype)
    for k, component in enumerate(components):
        out[..., k] = component
    return out
