"""Skinning in NumPy, one column per vertex: the slow reference that the compiled kernels are held against.

Affine matrices are rows of numbers (12,V): row 4·r + c is the element in row r, column c of the (3,4) matrix.
"""

import numpy as np
from statwalk.maths import transform
from statwalk.skin.rows import unit


def posed(surface, world, weights):
    """Positions and unit normals (3,V) of a surface, for world matrices (J,3,4) and morph weights (W,)."""
    with np.errstate(over="ignore", invalid="ignore"):
        palette = transform.mul(world[surface.palette.joints], surface.palette.inverse_bind)
        rows = blended(palette.reshape(-1, 12).T, surface.bones, surface.weights)
        positions = points(rows, morphed(surface.positions, surface.position_morphs, weights))
        return np.nan_to_num(positions), normals(
            rows, morphed(surface.normals, surface.normal_morphs, weights)
        )


def blended(palette, bones, weights):
    """Rows (12,V): for every vertex the sum of its bones' rows (12,K), by bones and weights (V,I)."""
    rows = palette[:, bones[:, 0]] * weights[:, 0]
    for column in range(1, bones.shape[1]):
        used = weights[:, column] != 0
        rows[:, used] += palette[:, bones[used, column]] * weights[used, column]
    return rows


def morphed(base, morphs, weights):
    """Points (3,V) with all weighted displacements added."""
    out = np.array(base)
    for morph in morphs:
        for target, displacement in enumerate(morph.displacements):
            out[:, morph.span] += displacement * out.dtype.type(weights[morph.first + target])
    return out


def points(m, xyz):
    """The points (3,V) moved by the matrices."""
    x, y, z = xyz
    return np.stack([m[4 * k] * x + m[4 * k + 1] * y + m[4 * k + 2] * z + m[4 * k + 3] for k in range(3)])


def normals(m, xyz):
    """The unit normals (3,V) of a surface moved by the matrices, turned by the inverse transpose.

    The cofactors are the inverse transpose times the determinant, whose sign is kept (mirrors) and whose size
    the length removes. Where a matrix is flat the normal may vanish; the source's normal stays then.
    """
    x, y, z = xyz
    cofactors = [cofactor_row(m, k) for k in range(3)]
    out = np.stack([a * x + b * y + c * z for a, b, c in cofactors])
    first = cofactors[0]
    mirrored = m[0] * first[0] + m[1] * first[1] + m[2] * first[2] < 0
    return unit(np.where(mirrored, -out, out), xyz)


def cofactor_row(m, row):
    """One row of the cofactor matrix of the upper left 3x3 block: the cross product of the other two rows."""
    a, b = 4 * ((row + 1) % 3), 4 * ((row + 2) % 3)
    return (
        m[a + 1] * m[b + 2] - m[a + 2] * m[b + 1],
        m[a + 2] * m[b] - m[a] * m[b + 2],
        m[a] * m[b + 1] - m[a + 1] * m[b],
    )
