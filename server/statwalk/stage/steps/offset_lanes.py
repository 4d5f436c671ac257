"""Pose offsets of sixteen actors at a time, added to the poses of motions."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import types

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.simd.lane_functions import any_above, either, fused, most, with_lane
from statwalk.maths.simd.lane_quat import from_rotation_vector, mul, plus, renormalized
from statwalk.maths.simd.lanes import LANES, broadcast, load, store
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
from statwalk.stage.steps.offset_clocks import remaining

ZERO = np.float32(0)
NOW, EARLIER, BEGINS, BLANK, OWNS, CLOCKS = 0, 2, 4, 5, 6, 7
"""rows of a layer in the scratch: factors of start and velocity now and a tick earlier; whether a blend
begins; whether a blend begins that has no offset yet; whether the current jump is the layer's own
"""
JOINT = 9
"""numbers in the offset of a joint"""


def scratch_size(layers: int) -> int:
    """Returns how many rows of sixteen float32 `begin_block` and `add_block` need as scratch."""
    return CLOCKS * layers + 2 * JOINT


@inlined
def clock_at(layer: int, clock: int) -> int:
    """Returns the place of a layer's clock in the scratch."""
    return (CLOCKS * layer + clock) * LANES


@inlined
def channel_at(offsets: Any, slot: int, channel: int) -> Any:
    """Returns the place of a channel of a slot."""
    return (slot * offsets.start.shape[1] + channel) * LANES


@inlined
def read_clocks(offsets: Any, block: int, layer: int, earlier: float, scratch: Any, clock: int) -> None:
    """Writes the `remaining` factors of sixteen actors into the scratch."""
    start = rate = broadcast(ZERO)
    first = first_row(block)
    for row in range(first, end_row(block, offsets.elapsed.shape[0])):
        of_start, of_rate = remaining(offsets, row, layer, earlier)
        start = with_lane(start, row - first, types.float32(of_start))
        rate = with_lane(rate, row - first, types.float32(of_rate))
    store(scratch, clock_at(layer, clock), start)
    store(scratch, clock_at(layer, clock + 1), rate)


@inlined
def left_of(offsets: Any, at: int, start: Any, rate: Any, total: Any) -> Any:
    """Returns the total plus what is left of a channel, in lanes with a transition."""
    return either(
        start, fused(load(offsets.start, at), start, fused(load(offsets.rate, at), rate, total)), total
    )


@inlined
def _left_of_three(offsets: Any, at: int, start: Any, rate: Any, total: Any) -> Any:
    """`left_of` for three channels."""
    x = left_of(offsets, at, start, rate, total[0])
    y = left_of(offsets, at + LANES, start, rate, total[1])
    return x, y, left_of(offsets, at + 2 * LANES, start, rate, total[2])


@inlined
def _add_joint(offsets: Any, masks: Any, pose: Any, at: int, block: int, joint: int, scratch: Any) -> None:
    """Adds a joint's offsets of all layers that move the joint."""
    on = zero = broadcast(ZERO)
    move = turn = stretch = (zero, zero, zero)
    for layer in range(offsets.slot.shape[1]):
        slot = offsets.slot[block, layer]
        if slot >= 0 and masks.joints[layer, joint]:
            start, rate = load(scratch, clock_at(layer, NOW)), load(scratch, clock_at(layer, NOW + 1))
            place, on = channel_at(offsets, slot, JOINT * joint), most(on, start)
            move = _left_of_three(offsets, place, start, rate, move)
            turn = _left_of_three(offsets, place + 3 * LANES, start, rate, turn)
            stretch = _left_of_three(offsets, place + 6 * LANES, start, rate, stretch)
    if any_above(on, zero):
        to = joint_at(pose, at, joint)
        moved, rotation, scale = load3(pose, to), load4(pose, to + ROTATION), load3(pose, to + SCALE)
        store3(pose, to, either3(on, plus(moved, move), moved))
        store4(
            pose,
            to + ROTATION,
            either4(on, renormalized(mul(from_rotation_vector(turn), rotation)), rotation),
        )
        store3(pose, to + SCALE, either3(on, plus(scale, stretch), scale))


@inlined
def _add_weight(offsets: Any, masks: Any, pose: Any, at: int, block: int, weight: int, scratch: Any) -> None:
    """Adds a morph weight's offsets of all layers that move it."""
    joints = masks.joints.shape[1]
    on = total = broadcast(ZERO)
    for layer in range(offsets.slot.shape[1]):
        slot = offsets.slot[block, layer]
        if slot >= 0 and masks.weights[layer, weight]:
            start, rate = load(scratch, clock_at(layer, NOW)), load(scratch, clock_at(layer, NOW + 1))
            on = most(on, start)
            total = left_of(offsets, channel_at(offsets, slot, JOINT * joints + weight), start, rate, total)
    to = weight_at(pose, at, joints, weight)
    old = load(pose, to)
    store(pose, to, either(on, old + total, old))


@called
def add_block(offsets: Any, masks: Any, pose: Any, at: int, block: int, earlier: float, scratch: Any) -> None:
    """Adds what was left of the offsets of `block`, `earlier` seconds before now, to the poses in block `at`
    of `pose`; poses without a transition keep their bits.
    """
    present = False
    for layer in range(offsets.slot.shape[1]):
        if offsets.slot[block, layer] >= 0:
            present = True
            read_clocks(offsets, block, layer, earlier, scratch, NOW)
    if present:
        for joint in range(masks.joints.shape[1]):
            _add_joint(offsets, masks, pose, at, block, joint, scratch)
        for weight in range(masks.weights.shape[1]):
            _add_weight(offsets, masks, pose, at, block, weight, scratch)
