"""Affine matrices as rows of numbers, one column per vertex: (12,V), or (12,K) one column per bone.

Row 4·r + c is the element in row r, column c of the (3,4) matrix; points and normals are (3,V). Every operation then runs along
contiguous vertices.
"""

from __future__ import annotations

import numpy as np

from statwalk.maths.arrays import Floats

SMALLEST_SQUARE, LARGEST_SQUARE = 1e-30, 1e30


def rows_of(matrices: Floats) -> Floats:
    """(K,3,4) matrices as rows (12,K)."""
    return np.ascontiguousarray(matrices.reshape(-1, 12).T)


def points(m: Floats, xyz: Floats) -> Floats:
    """The points (3,V) moved by the matrices."""
    x, y, z = xyz
    out = np.empty_like(xyz)
    for k in range(3):
        np.multiply(m[4 * k], x, out=out[k])
        out[k] += m[4 * k + 1] * y
        out[k] += m[4 * k + 2] * z
        out[k] += m[4 * k + 3]
    return out


def normals(m: Floats, xyz: Floats) -> Floats:
    """The unit normals (3,V) of a surface moved by the matrices: turned by the inverse transpose.

    The cofactors are the inverse transpose times the determinant, whose sign is kept (mirrors) and whose size the length removes.
    Where a matrix is flat the normal may vanish; the source's normal stays then.
    """
    x, y, z = xyz
    cofactors = [cofactor_row(m, k) for k in range(3)]
    out = np.empty_like(xyz)
    for k, (a, b, c) in enumerate(cofactors):
        np.multiply(a, x, out=out[k])
        out[k] += b * y
        out[k] += c * z
    first = cofactors[0]
    mirrored = m[0] * first[0] + m[1] * first[1] + m[2] * first[2] < 0
    if mirrored.any():
        np.negative(out, out=out, where=mirrored)
    return unit(out, xyz)


def cofactor_row(m: Floats, row: int) -> tuple[Floats, Floats, Floats]:
    """One row of the cofactor matrix of the upper left 3x3 block: the cross product of the other two rows."""
    a, b = 4 * ((row + 1) % 3), 4 * ((row + 2) % 3)
    return (
        m[a + 1] * m[b + 2] - m[a + 2] * m[b + 1],
        m[a + 2] * m[b] - m[a] * m[b + 2],
        m[a] * m[b + 1] - m[a + 1] * m[b],
    )


def unit(vectors: Floats, otherwise: Floats) -> Floats:
    """Vectors (3,V) at unit length; where one has no length, the unit vector along `otherwise` or, failing that, +Z."""
    squared = vectors[0] * vectors[0] + vectors[1] * vectors[1] + vectors[2] * vectors[2]
    good = (squared > SMALLEST_SQUARE) & (squared < LARGEST_SQUARE)
    if good.all():
        return np.asarray(vectors / np.sqrt(squared))
    out = np.where(good, vectors / np.sqrt(np.where(good, squared, 1)), 0)
    out[:, ~good] = repaired(vectors[:, ~good], np.broadcast_to(otherwise, vectors.shape)[:, ~good])
    return out


def repaired(vectors: Floats, otherwise: Floats) -> Floats:
    """The slow way of `unit`: scales each vector first, so that tiny and huge ones keep their direction."""
    whole = np.where(largest(vectors) > 0, vectors, otherwise)
    size = largest(whole)
    whole = np.where(size > 0, whole / np.where(size > 0, size, 1), np.array([[0], [0], [1]], vectors.dtype))
    return np.asarray(whole / np.sqrt(whole[0] * whole[0] + whole[1] * whole[1] + whole[2] * whole[2]), vectors.dtype)


def largest(vectors: Floats) -> Floats:
    """The largest component's size of each vector, (V,); 0 where one of them is no finite number."""
    sizes = np.abs(vectors).max(axis=0)
    return np.where(np.isfinite(sizes), sizes, 0)


def finite(values: Floats) -> Floats:
    """The values; where one overflowed, the largest finite number, for neither JSON nor glTF knows infinity."""
    return values if np.isfinite(values).all() else np.nan_to_num(values)
