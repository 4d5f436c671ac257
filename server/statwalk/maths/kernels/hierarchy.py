"""Computes joint matrices for frames and exported files: from local transforms to stage space in one compiled
call.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import FLOAT, INT, inlined, kernel, read, write

ONE, TWO = np.float32(1), np.float32(2)


@inlined
def local(translation: Any, rotation: Any, scale: Any, actor: int, joint: int) -> Any:
    """Returns the rows of T·R·S (glTF 2.0, 3.5.3)."""
    x, y, z, w = (
        rotation[actor, joint, 0],
        rotation[actor, joint, 1],
        rotation[actor, joint, 2],
        rotation[actor, joint, 3],
    )
    a, b, c = scale[actor, joint, 0], scale[actor, joint, 1], scale[actor, joint, 2]
    u, v, t = translation[actor, joint, 0], translation[actor, joint, 1], translation[actor, joint, 2]
    return (
        ((ONE - TWO * (y * y + z * z)) * a, TWO * (x * y - z * w) * b, TWO * (x * z + y * w) * c, u),
        (TWO * (x * y + z * w) * a, (ONE - TWO * (x * x + z * z)) * b, TWO * (y * z - x * w) * c, v),
        (TWO * (x * z - y * w) * a, TWO * (y * z + x * w) * b, (ONE - TWO * (x * x + y * y)) * c, t),
    )


@inlined
def put(out: Any, actor: int, joint: int, above: Any, other: int, rows: Any) -> None:
    """Writes one of the matrices `above` (n,…,3,4), at `other`, times `rows` as the joint's matrix."""
    x, y, z = rows
    for row in range(3):
        a, b, c, d = (
            above[actor, other, row, 0],
            above[actor, other, row, 1],
            above[actor, other, row, 2],
            above[actor, other, row, 3],
        )
        out[actor, joint, row, 0] = a * x[0] + b * y[0] + c * z[0]
        out[actor, joint, row, 1] = a * x[1] + b * y[1] + c * z[1]
        out[actor, joint, row, 2] = a * x[2] + b * y[2] + c * z[2]
        out[actor, joint, row, 3] = a * x[3] + b * y[3] + c * z[3] + d


@inlined
def _rows_of(out: Any, actor: int, joint: int) -> Any:
    """The rows of a joint's matrix."""
    return (
        (out[actor, joint, 0, 0], out[actor, joint, 0, 1], out[actor, joint, 0, 2], out[actor, joint, 0, 3]),
        (out[actor, joint, 1, 0], out[actor, joint, 1, 1], out[actor, joint, 1, 2], out[actor, joint, 1, 3]),
        (out[actor, joint, 2, 0], out[actor, joint, 2, 1], out[actor, joint, 2, 2], out[actor, joint, 2, 3]),
    )


@kernel(read(INT, 1), read(FLOAT, 3), read(FLOAT, 3), read(FLOAT, 3), read(FLOAT, 4), write(FLOAT, 4))
def placed(parents: Any, translation: Any, rotation: Any, scale: Any, roots: Any, out: Any) -> None:
    """Writes the matrices (n,J,3,4) of joints with local transforms (n,J,3), (n,J,4), (n,J,3), of actors at
    `roots` (n,1,3,4).

    Each joint is computed within its actor first, then the actor is placed as a whole: far from the origin no
    precision is lost along the joints.
    """
    for actor in range(out.shape[0]):
        for joint in range(parents.shape[0]):
            rows = local(translation, rotation, scale, actor, joint)
            if parents[joint] >= 0:
                put(out, actor, joint, out, parents[joint], rows)
                continue
            for row in range(3):
                for column in range(4):
                    out[actor, joint, row, column] = rows[row][column]
        for joint in range(parents.shape[0]):
            put(out, actor, joint, roots, 0, _rows_of(out, actor, joint))
