"""The bones of dual-quaternion skin: each bone's turn, shift and stretch, seen from each heaviest bone.

Bone i carries vertex v to yᵢ = Mᵢ·v, and turns it by Rᵢ, the rotation closest to Mᵢ. Seen from the vertex
this is a rigid motion, x -> Rᵢ·x + yᵢ, with the dual quaternion qᵢ + ε·½·yᵢ·qᵢ. These are blended (Kavan,
Collins, Žára and O'Sullivan 2008, "Geometric Skinning with Approximate Dual Quaternion Blending"). With
Mᵢ·v = Rᵢ·Sᵢ·v + tᵢ the dual part is ½·tᵢ·qᵢ + ½·qᵢ·(Sᵢ·v).

So one bone alone gives Mᵢ·v for every matrix, equal rotations give the linear blend, and a character that is
scaled as a whole is only scaled.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import FLOAT, INT, LONG, inlined, kernel, read, write
from statwalk.maths.simd.lanes import LANES, load, store
from statwalk.skin.closest_rotation import closest_rotation
from statwalk.skin.repair import MATRIX

LINEAR, RIGID, STRETCHED = 0, 1, 2
"""what `_kernels.skinned` blends: matrices, rigid motions, motions that stretch"""
BONE = 2 * MATRIX
"""floats of a bone"""
DUAL, SHAPE = 4, 8
"""floats from a bone's first, its rotation: the dual part, and the six numbers of its symmetric stretch"""
DOUBLE = np.float64
SIGNS = np.array([1] * 32 + [-1] * SHAPE + [1] * (MATRIX - SHAPE) + [-1] * MATRIX, np.float32)
"""what a bone is multiplied by if it is on the side of the first, and if not: a stretch has no side"""
SLIGHT = 1e-5
"""a stretch below a hundred-thousandth is rounding"""


@inlined
def _stretch_column(turn: Any, x: Any, y: Any, z: Any) -> Any:
    """Returns a column of a matrix, turned back by a unit quaternion."""
    i, j, k, w = turn
    u, v, t = 2 * (y * k - z * j), 2 * (z * i - x * k), 2 * (x * j - y * i)
    return x + w * u + v * k - t * j, y + w * v + t * i - u * k, z + w * t + u * j - v * i


@inlined
def _write_product(bones: Any, bone: int, column: int, turn: Any, u: Any) -> None:
    """Writes half the product of a quaternion and a vector as a column of a bone."""
    x, y, z, w = turn
    at = bone + MATRIX + column
    bones[at] = (w * u[0] + y * u[2] - z * u[1]) / 2
    bones[at + 3] = (w * u[1] + z * u[0] - x * u[2]) / 2
    bones[at + 6] = (w * u[2] + x * u[1] - y * u[0]) / 2
    bones[at + 9] = -(x * u[0] + y * u[1] + z * u[2]) / 2


@inlined
def _write_bone(matrices: Any, at: int, bones: Any, bone: int) -> Any:
    """Writes a bone: rotation, dual part, stretch, and what a vertex at rest adds to the dual part (4,3);
    returns the largest difference between the stretch and 1.
    """
    a, b, c = DOUBLE(matrices[at]), DOUBLE(matrices[at + 1]), DOUBLE(matrices[at + 2])
    d, e, f = DOUBLE(matrices[at + 4]), DOUBLE(matrices[at + 5]), DOUBLE(matrices[at + 6])
    g, h, i = DOUBLE(matrices[at + 8]), DOUBLE(matrices[at + 9]), DOUBLE(matrices[at + 10])
    turn = x, y, z, w = closest_rotation((a, b, c, d, e, f, g, h, i))
    bones[bone], bones[bone + 1], bones[bone + 2], bones[bone + 3] = x, y, z, w
    tx, ty, tz = matrices[at + 3], matrices[at + 7], matrices[at + 11]
    bones[bone + DUAL] = (tx * w + ty * z - tz * y) / 2
    bones[bone + DUAL + 1] = (ty * w + tz * x - tx * z) / 2
    bones[bone + DUAL + 2] = (tz * w + tx * y - ty * x) / 2
    bones[bone + DUAL + 3] = -(tx * x + ty * y + tz * z) / 2
    first, second, third = (
        _stretch_column(turn, a, d, g),
        _stretch_column(turn, b, e, h),
        _stretch_column(turn, c, f, i),
    )
    bones[bone + SHAPE], bones[bone + SHAPE + 3], bones[bone + SHAPE + 5] = first[0], second[1], third[2]
    bones[bone + SHAPE + 1] = (first[1] + second[0]) / 2
    bones[bone + SHAPE + 2] = (first[2] + third[0]) / 2
    bones[bone + SHAPE + 4] = (second[2] + third[1]) / 2
    _write_product(bones, bone, 0, turn, first)
    _write_product(bones, bone, 1, turn, second)
    _write_product(bones, bone, 2, turn, third)
    return max(
        max(abs(first[0] - 1), abs(second[1] - 1), abs(third[2] - 1)),
        max(abs(first[1]), abs(first[2]), abs(second[2])),
        max(abs(second[0]), abs(third[0]), abs(third[1])),
    )


@kernel(
    read(FLOAT, 1), read(INT, 2), read(FLOAT, 1), write(FLOAT, 1), write(FLOAT, 1), write(FLOAT, 1),
    returns=LONG,
)  # fmt: skip
def dual_palette(matrices: Any, pairs: Any, signs: Any, bones: Any, turns: Any, stretches: Any) -> int:
    """Writes the bones (P,2) of `pairs`: the second as seen from the first, 16 floats each in `turns` and, if
    any bone stretches, in `stretches`; returns RIGID or STRETCHED.

    matrices (K·16,) as `_kernels.palette` writes them; `SIGNS`; bones (K·32,) is memory to work in.
    """
    way = RIGID
    for bone in range(bones.shape[0] // BONE):
        if _write_bone(matrices, MATRIX * bone, bones, BONE * bone) > SLIGHT:
            way = STRETCHED
    for pair in range(pairs.shape[0]):
        first, second = BONE * pairs[pair, 0], BONE * pairs[pair, 1]
        same = bones[first] * bones[second] + bones[first + 1] * bones[second + 1]
        same += bones[first + 2] * bones[second + 2] + bones[first + 3] * bones[second + 3]
        is_far = LONG(same < 0)
        store(turns, MATRIX * pair, load(bones, second) * load(signs, 2 * LANES * is_far))
        if way == STRETCHED:
            sign = load(signs, 2 * LANES * is_far + LANES)
            store(stretches, MATRIX * pair, load(bones, second + MATRIX) * sign)
    return way
