"""Computes model-space matrices from local transforms, sixteen actors at a time: each joint's matrix after
its parent's (RTCA 2.1; glTF 3.5.3).
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import FLOAT, INT, LONG, inlined, kernel, read, write
from statwalk.maths.simd.lane_functions import fused
from statwalk.maths.simd.lanes import LANES, broadcast
from statwalk.maths.simd.pose_lanes import ROTATION, SCALE, joint_at, load3, load4, store4
from statwalk.maths.simd.pose_layout import place_of

ONE, TWO = np.float32(1), np.float32(2)
MATRIX = 12
"""rows of sixteen floats in a matrix: three rows of four"""


@inlined
def _twice_products(q: Any) -> Any:
    """xx yy zz xy xz yz xw yw zw of a quaternion, each twice."""
    x, y, z, w = q
    two = broadcast(TWO)
    a, b, c = two * x, two * y, two * z
    return a * x, b * y, c * z, a * y, a * z, b * z, a * w, b * w, c * w


@inlined
def _local_rows(pose: Any, block: int, joint: int) -> Any:
    """The three rows of T·R·S of a joint."""
    at, one = joint_at(pose, block, joint), broadcast(ONE)
    tx, ty, tz = load3(pose, at)
    sx, sy, sz = load3(pose, at + SCALE)
    xx, yy, zz, xy, xz, yz, xw, yw, zw = _twice_products(load4(pose, at + ROTATION))
    return (
        ((one - (yy + zz)) * sx, (xy - zw) * sy, (xz + yw) * sz, tx),
        ((xy + zw) * sx, (one - (xx + zz)) * sy, (yz - xw) * sz, ty),
        ((xz - yw) * sx, (yz + xw) * sy, (one - (xx + yy)) * sz, tz),
    )


@inlined
def _row_after(above: Any, x: Any, y: Any, z: Any) -> Any:
    """A row of the product of a parent's matrix, whose row is `above`, and a local matrix with rows x y z."""
    a, b, c, d = above
    return (
        fused(c, z[0], fused(b, y[0], a * x[0])),
        fused(c, z[1], fused(b, y[1], a * x[1])),
        fused(c, z[2], fused(b, y[2], a * x[2])),
        fused(c, z[3], fused(b, y[3], fused(a, x[3], d))),
    )


@inlined
def model_block(joints: Any, parents: Any, pose: Any, out: Any, block: int) -> None:
    """Writes the model-space matrices of some joints of a block's actors into out (B, n, 12, 16).

    joints (n,): joints of the pose, parents before children; parents (n,): the index of each joint's parent
    in that list, -1 a root.
    """
    count = joints.shape[0]
    for number in range(count):
        x, y, z = _local_rows(pose, block, joints[number])
        at = (block * count + number) * MATRIX * LANES
        if parents[number] >= 0:
            above = (block * count + parents[number]) * MATRIX * LANES
            store4(out, at, _row_after(load4(out, above), x, y, z))
            store4(out, at + 4 * LANES, _row_after(load4(out, above + 4 * LANES), x, y, z))
            store4(out, at + 8 * LANES, _row_after(load4(out, above + 8 * LANES), x, y, z))
        else:
            store4(out, at, x)
            store4(out, at + 4 * LANES, y)
            store4(out, at + 8 * LANES, z)


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


@kernel(read(INT, 1), read(INT, 1), read(FLOAT, 3), write(FLOAT, 4), LONG)
def model_space(joints: Any, parents: Any, pose: Any, out: Any, count: int) -> None:
    """Runs `model_block` on the first `count` blocks."""
    for block in range(count):
        model_block(joints, parents, pose, out, block)
