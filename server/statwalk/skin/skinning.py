"""The ways of skinning: what the vertices of a skin follow.

- linear: the sum of their bones' matrices, by weight (RTCA 2.3.2); thin where bones twist.
- dual-quaternion: the sum of their bones' rigid motions, by weight; keeps its volume where bones twist.
- rigid: the heaviest of their bones (RTCA 2.3.1); creased at the joints.
- parts: one piece for each bone. A triangle goes with the bone that is heaviest over its three corners, and
  has corners of its own (RTCA 2.1, FAQ Q20); gaps open at the joints.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

from statwalk.errors import UnknownNameError
from statwalk.maths.arrays import Ints
from statwalk.skin.primitive import TRIANGLES, Primitive
from statwalk.skin.shading import triangles

Skinning = Literal["linear", "dual-quaternion", "rigid", "parts"]
SKINNINGS: tuple[Skinning, ...] = get_args(Skinning)
DECIMALS, LAST = 4, 65_535


def skinning_of(name: str) -> Skinning:
    """Returns the way of skinning that has this name.

    :raises UnknownNameError: when there is none; the error lists the ways.
    """
    for skinning in SKINNINGS:
        if name == skinning:
            return skinning
    raise UnknownNameError("way of skinning", name, SKINNINGS)


def reskinned(parts: Sequence[Primitive], skinning: Skinning) -> tuple[Primitive, ...]:
    """Returns the primitives with the weights, and for `parts` the triangles, of a way of skinning."""
    if skinning == "rigid":
        return tuple(_rigid(part) for part in parts)
    if skinning == "parts":
        return tuple(_torn(part) for part in parts)
    return tuple(parts)


def heaviest_bones(joints: NDArray[np.uint16], weights: NDArray[np.float32]) -> NDArray[np.uint16]:
    """Returns (V,) the bone with the largest sum of each row of weights (V,I), for joints (V,I); of bones
    equal to `DECIMALS` the first of the skin, so that quantised weights change nothing.
    """
    sums = np.zeros(joints.shape)
    for column in range(joints.shape[1]):
        same = joints == joints[:, column : column + 1]
        sums[:, column] = np.where(same, weights, 0).sum(1, dtype=np.float64)
    sums = sums.round(DECIMALS)
    is_heaviest = sums == sums.max(axis=1, keepdims=True)
    heaviest: NDArray[np.uint16] = np.where(is_heaviest, joints, np.uint16(LAST)).min(axis=1)
    return heaviest


def triangle_bones(
    faces: Ints, joints: NDArray[np.uint16], weights: NDArray[np.float32]
) -> NDArray[np.uint16]:
    """Returns (T,) the heaviest bone over all three corners of each of the faces (T,3)."""
    return heaviest_bones(joints[faces].reshape(len(faces), -1), weights[faces].reshape(len(faces), -1))


def _rigid(part: Primitive) -> Primitive:
    if part.joints is None or part.weights is None:
        return part
    return _bound_to(part, heaviest_bones(part.joints, part.weights))


def _bound_to(part: Primitive, bones: NDArray[np.uint16]) -> Primitive:
    """The primitive with one bone for each vertex (V,)."""
    return replace(part, joints=bones[:, None], weights=np.ones((len(bones), 1), np.float32))


def _torn(part: Primitive) -> Primitive:
    """The primitive as pieces, bone by bone; points and lines stay whole."""
    if part.joints is None or part.weights is None or part.mode < TRIANGLES:
        return _rigid(part)
    order = np.arange(len(part.positions), dtype=np.uint32) if part.indices is None else part.indices
    faces = triangles(order, part.mode).astype(np.intp)
    bones = triangle_bones(faces, part.joints, part.weights)
    corners = np.repeat(bones.astype(np.intp), 3) * len(part.positions) + faces.reshape(-1)
    used, indices = np.unique(corners, return_inverse=True)
    owners, vertices = np.divmod(used, max(1, len(part.positions)))
    piece = replace(
        part,
        positions=part.positions[vertices],
        normals=None if part.normals is None else part.normals[vertices],
        indices=indices.reshape(-1).astype(np.uint32),
        mode=TRIANGLES,
        target_positions=_taken(part.target_positions, vertices),
        target_normals=_taken(part.target_normals, vertices),
        attributes={name: values[vertices] for name, values in part.attributes.items()},
        collapses=None,
    )
    return _bound_to(piece, owners.astype(np.uint16))


def _taken(targets: NDArray[np.float32] | None, vertices: NDArray[np.intp]) -> NDArray[np.float32] | None:
    """The rows of some vertices of morph targets (M,V,3)."""
    return None if targets is None else np.ascontiguousarray(targets[:, vertices])
