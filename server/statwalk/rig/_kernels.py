"""The kernels that Python calls for a hierarchy: of a pose buffer, of single actors, and of actors on the
stage.
"""

from __future__ import annotations

from typing import Any

from numba import types

from statwalk.maths.compiling import FLOAT, INT, LONG, inlined, kernel, read, write
from statwalk.rig.hierarchy import ONE, local_rows, model_block, row_after

DOUBLE = types.float64


@kernel(read(INT, 1), read(INT, 1), read(FLOAT, 3), write(FLOAT, 4), LONG)
def model_space(joints: Any, parents: Any, pose: Any, out: Any, count: int) -> None:
    """Runs `model_block` on the first `count` blocks."""
    for block in range(count):
        model_block(joints, parents, pose, out, block)


@inlined
def _row4(values: Any, actor: int, joint: int) -> Any:
    return values[actor, joint, 0], values[actor, joint, 1], values[actor, joint, 2], values[actor, joint, 3]


@inlined
def _row3(values: Any, actor: int, joint: int) -> Any:
    return values[actor, joint, 0], values[actor, joint, 1], values[actor, joint, 2]


@inlined
def _matrix_row(matrices: Any, actor: int, joint: int, row: int) -> Any:
    return (
        matrices[actor, joint, row, 0],
        matrices[actor, joint, row, 1],
        matrices[actor, joint, row, 2],
        matrices[actor, joint, row, 3],
    )


@inlined
def _put(out: Any, actor: int, joint: int, row: int, values: Any) -> None:
    out[actor, joint, row, 0], out[actor, joint, row, 1] = values[0], values[1]
    out[actor, joint, row, 2], out[actor, joint, row, 3] = values[2], values[3]


@inlined
def _joints(parents: Any, translation: Any, rotation: Any, scale: Any, out: Any, one: Any) -> None:
    for actor in range(out.shape[0]):
        for joint in range(parents.shape[0]):
            q, s = _row4(rotation, actor, joint), _row3(scale, actor, joint)
            x, y, z = local_rows(_row3(translation, actor, joint), q, s, one)
            parent = parents[joint]
            if parent >= 0:
                for row in range(3):
                    _put(out, actor, joint, row, row_after(_matrix_row(out, actor, parent, row), x, y, z))
            else:
                _put(out, actor, joint, 0, x)
                _put(out, actor, joint, 1, y)
                _put(out, actor, joint, 2, z)


@kernel(read(INT, 1), read(FLOAT, 3), read(FLOAT, 3), read(FLOAT, 3), write(FLOAT, 4))
def world(parents: Any, translation: Any, rotation: Any, scale: Any, out: Any) -> None:
    """Writes the matrices (N,J,3,4) of joints with local transforms (N,J,3), (N,J,4), (N,J,3)."""
    _joints(parents, translation, rotation, scale, out, ONE)


@kernel(read(INT, 1), read(DOUBLE, 3), read(DOUBLE, 3), read(DOUBLE, 3), write(DOUBLE, 4))
def exact_world(parents: Any, translation: Any, rotation: Any, scale: Any, out: Any) -> None:
    """Writes the same in float64."""
    _joints(parents, translation, rotation, scale, out, 1.0)


@kernel(read(FLOAT, 3), write(FLOAT, 4))
def place(roots: Any, worlds: Any) -> None:
    """Places the matrices (N,J,3,4) of each actor's joints under the actor's matrix in `roots` (N,3,4)."""
    for actor in range(worlds.shape[0]):
        for joint in range(worlds.shape[1]):
            x, y = _matrix_row(worlds, actor, joint, 0), _matrix_row(worlds, actor, joint, 1)
            z = _matrix_row(worlds, actor, joint, 2)
            for row in range(3):
                _put(worlds, actor, joint, row, row_after(_row4(roots, actor, row), x, y, z))
