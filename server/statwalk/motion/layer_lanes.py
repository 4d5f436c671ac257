"""Layers over poses, sixteen actors at a time, in place in a `PoseBuffer` (see `motion.layers`).

Buffers are values (B, C, 16); weights (N, L) float64 in 0...1. A weight of 0 (the layer plays nothing) leaves
an actor's bits unchanged.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numba import types
from numpy.typing import NDArray

from statwalk.maths.compiling import inlined, read
from statwalk.maths.reference import called
from statwalk.maths.simd.lane_functions import any_above, either, fused, with_lane
from statwalk.maths.simd.lane_quat import conjugate, minus, mul, renormalized, slerp
from statwalk.maths.simd.lanes import broadcast, load, store
from statwalk.maths.simd.pose_lanes import (
    ROTATION,
    SCALE,
    either3,
    either4,
    joint_at,
    load3,
    load4,
    store3,
    store4,
    weight_at,
)
from statwalk.maths.simd.pose_layout import end_row, first_row
from statwalk.motion.layers import Mask

ZERO, ONE = np.float32(0), np.float32(1)


class LayerMasks(NamedTuple):
    """The joints (of J) and morph weights (of W) that each of L layers moves."""

    joints: NDArray[np.bool_]
    """(L, J)"""
    weights: NDArray[np.bool_]
    """(L, W)"""

    @classmethod
    def of(cls, masks: Sequence[Mask], joints: int, weights: int) -> LayerMasks:
        """Returns the masks of all layers, read-only."""
        layer_masks = cls(np.zeros((len(masks), joints), bool), np.zeros((len(masks), weights), bool))
        for layer, mask in enumerate(masks):
            layer_masks.joints[layer, mask.joints] = True
            layer_masks.weights[layer, mask.weights] = True
        for array in layer_masks:
            array.setflags(write=False)
        return layer_masks


MASKS = types.BaseTuple.from_types([read(types.boolean, 2)] * 2, LayerMasks)
"""the numba type of LayerMasks"""


@inlined
def _column_lanes(values: Any, block: int, column: int) -> Any:
    """A column of per-actor values (N, L) as sixteen float32; 0 in lanes without an actor."""
    lanes, first = broadcast(ZERO), first_row(block)
    for row in range(first, end_row(block, values.shape[0])):
        lanes = with_lane(lanes, row - first, types.float32(values[row, column]))
    return lanes


@inlined
def _mixed(a: Any, b: Any, part: Any) -> Any:
    """a (1 - part) + b part; exactly a at 0 and b at 1."""
    return fused(b, part, a * (broadcast(ONE) - part))


@inlined
def _mixed3(a: Any, b: Any, part: Any) -> Any:
    return _mixed(a[0], b[0], part), _mixed(a[1], b[1], part), _mixed(a[2], b[2], part)


@inlined
def _raised3(under: Any, over: Any, first: Any, part: Any) -> Any:
    """under + (over - first) part, for vectors."""
    way = minus(over, first)
    return fused(way[0], part, under[0]), fused(way[1], part, under[1]), fused(way[2], part, under[2])


@called
def override_block(under: Any, over: Any, at: int, weights: Any, masks: Any, layer: int, block: int) -> None:
    """Blends a layer's poses `over` into the poses `under` it by the layer's weight: linearly, rotations by
    slerp.

    Block `at` of the poses belongs to the actors of `block`.
    """
    part = _column_lanes(weights, block, layer)
    if not any_above(part, broadcast(ZERO)):
        return
    joints = masks.joints.shape[1]
    for joint in range(joints):
        if masks.joints[layer, joint]:
            to, from_ = joint_at(under, at, joint), joint_at(over, at, joint)
            moved, turned, stretched = load3(under, to), load4(under, to + ROTATION), load3(under, to + SCALE)
            store3(under, to, either3(part, _mixed3(moved, load3(over, from_), part), moved))
            store4(
                under,
                to + ROTATION,
                either4(part, slerp(turned, load4(over, from_ + ROTATION), part), turned),
            )
            store3(
                under,
                to + SCALE,
                either3(part, _mixed3(stretched, load3(over, from_ + SCALE), part), stretched),
            )
    for weight in range(masks.weights.shape[1]):
        if masks.weights[layer, weight]:
            to = weight_at(under, at, joints, weight)
            old = load(under, to)
            new = load(over, weight_at(over, at, joints, weight))
            store(under, to, either(part, _mixed(old, new, part), old))


@called
def additive_block(
    under: Any, over: Any, first: Any, at: int, weights: Any, masks: Any, layer: int, block: int
) -> None:
    """Adds the difference between a layer's poses `over` and the first pose of its motion, `first`, times its
    weight, to the poses `under`.

    Block `at` of the poses belongs to the actors of `block`.
    """
    part = _column_lanes(weights, block, layer)
    if not any_above(part, broadcast(ZERO)):
        return
    joints = masks.joints.shape[1]
    for joint in range(joints):
        if masks.joints[layer, joint]:
            to, from_, start = (
                joint_at(under, at, joint),
                joint_at(over, at, joint),
                joint_at(first, at, joint),
            )
            moved, turned, stretched = load3(under, to), load4(under, to + ROTATION), load3(under, to + SCALE)
            whole = mul(turned, mul(conjugate(load4(first, start + ROTATION)), load4(over, from_ + ROTATION)))
            store3(
                under,
                to,
                either3(part, _raised3(moved, load3(over, from_), load3(first, start), part), moved),
            )
            store4(under, to + ROTATION, either4(part, renormalized(slerp(turned, whole, part)), turned))
            scaled = _raised3(stretched, load3(over, from_ + SCALE), load3(first, start + SCALE), part)
            store3(under, to + SCALE, either3(part, scaled, stretched))
    for weight in range(masks.weights.shape[1]):
        if masks.weights[layer, weight]:
            to = weight_at(under, at, joints, weight)
            old = load(under, to)
            way = load(over, weight_at(over, at, joints, weight)) - load(
                first, weight_at(first, at, joints, weight)
            )
            store(under, to, either(part, fused(way, part, old), old))
