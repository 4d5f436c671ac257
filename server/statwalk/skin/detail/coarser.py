"""A primitive with the vertices that are left when its other vertices have collapsed."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Ints
from statwalk.skin.collapses import remaining, same_rows
from statwalk.skin.primitive import TRIANGLES, Primitive


def faces_of(part: Primitive) -> Ints:
    """Returns the triangles (T,3) of a primitive in mode 4."""
    order = np.arange(len(part.positions)) if part.indices is None else part.indices.astype(np.int64)
    return order[: len(order) // 3 * 3].reshape(-1, 3)


def coarser_faces(part: Primitive, steps: int) -> Ints:
    """Returns the triangles (T,3) that are left when the collapses of the steps below `steps` are made, those
    with two corners at one place left out: at least one, without area if none is left.
    """
    assert part.collapses is not None
    stands_for = part.collapses.moved(steps, len(part.positions))
    left = remaining(faces_of(part), stands_for, same_rows(part.positions))
    return left if len(left) else np.zeros((1, 3), np.int64)


def coarser(part: Primitive, steps: int) -> Primitive:
    """Returns the primitive with the vertices and triangles that are left when the collapses of the steps
    below `steps` are made; unchanged if it has no collapses.
    """
    if part.collapses is None:
        return part
    used, faces = np.unique(coarser_faces(part, steps), return_inverse=True)
    return replace(
        part,
        positions=part.positions[used],
        normals=_rows(part.normals, used),
        indices=faces.reshape(-1).astype(np.uint32),
        mode=TRIANGLES,
        joints=None if part.joints is None else part.joints[used],
        weights=_rows(part.weights, used),
        target_positions=_target_rows(part.target_positions, used),
        target_normals=_target_rows(part.target_normals, used),
        attributes={name: values[used] for name, values in part.attributes.items()},
        collapses=None,
    )


def _rows(values: NDArray[np.float32] | None, rows: Ints) -> NDArray[np.float32] | None:
    return None if values is None else values[rows]


def _target_rows(values: NDArray[np.float32] | None, rows: Ints) -> NDArray[np.float32] | None:
    return None if values is None else np.ascontiguousarray(values[:, rows])
