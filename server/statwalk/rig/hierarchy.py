"""The hierarchy: each joint's matrix is its parent's times its own T·R·S (RTCA 2.1; glTF 3.5.3), compiled.

The arithmetic is written once, for numbers and for sixteen lanes: a tick computes sixteen actors at a time in
a `PoseBuffer`, frames and exported files compute one actor at a time (`_kernels`).
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import inlined
from statwalk.maths.simd.lanes import LANES, broadcast
from statwalk.maths.simd.pose_lanes import ROTATION, SCALE, joint_at, load3, load4, store4
from statwalk.maths.simd.pose_layout import place_of

ONE = np.float32(1)
MATRIX = 12
"""rows of sixteen floats in a matrix: three rows of four"""


@inlined
def local_rows(t: Any, q: Any, s: Any, one: Any) -> Any:
    """Returns the three rows of T·R·S of numbers or of lanes, with `one` of their type."""
    x, y, z, w = q
    a, b, c = x + x, y + y, z + z
    xx, yy, zz, xy, xz, yz = a * x, b * y, c * z, a * y, a * z, b * z
    xw, yw, zw = a * w, b * w, c * w
    return (
        ((one - (yy + zz)) * s[0], (xy - zw) * s[1], (xz + yw) * s[2], t[0]),
        ((xy + zw) * s[0], (one - (xx + zz)) * s[1], (yz - xw) * s[2], t[1]),
        ((xz - yw) * s[0], (yz + xw) * s[1], (one - (xx + yy)) * s[2], t[2]),
    )


@inlined
def row_after(above: Any, x: Any, y: Any, z: Any) -> Any:
    """Returns a row of the product of a matrix whose row is `above`, and a matrix with rows x y z."""
    a, b, c, d = above
    return (
        a * x[0] + b * y[0] + c * z[0],
        a * x[1] + b * y[1] + c * z[1],
        a * x[2] + b * y[2] + c * z[2],
        a * x[3] + b * y[3] + c * z[3] + d,
    )


@inlined
def model_block(joints: Any, parents: Any, pose: Any, out: Any, block: int) -> None:
    """Writes the model-space matrices of some joints of a block's actors into out (B, n, 12, LANES).

    joints (n,): joints of the pose, parents before children; parents (n,): the index of each joint's parent
    in that list, -1 a root.
    """
    count, row = joints.shape[0], 4 * LANES
    for number in range(count):
        place = joint_at(pose, block, joints[number])
        translation, rotation = load3(pose, place), load4(pose, place + ROTATION)
        x, y, z = local_rows(translation, rotation, load3(pose, place + SCALE), broadcast(ONE))
        at = (block * count + number) * MATRIX * LANES
        if parents[number] >= 0:
            above = (block * count + parents[number]) * MATRIX * LANES
            store4(out, at, row_after(load4(out, above), x, y, z))
            store4(out, at + row, row_after(load4(out, above + row), x, y, z))
            store4(out, at + 2 * row, row_after(load4(out, above + 2 * row), x, y, z))
        else:
            store4(out, at, x)
            store4(out, at + row, y)
            store4(out, at + 2 * row, z)


@inlined
def read_matrix(model: Any, row: int, place: int, matrix: Any) -> None:
    """Reads the matrix (3, 4) of one of the joints of `model_block` of an actor; the identity if `place` is
    below 0.
    """
    block, lane = place_of(row)
    for axis in range(3):
        for column in range(4):
            if place < 0:
                matrix[axis, column] = 1.0 if axis == column else 0.0
            else:
                matrix[axis, column] = model[block, place, 4 * axis + column, lane]
