"""Offsets that begin, for sixteen actors at a time: the difference between the shown poses and the poses that
come next (see `motion.inertialize`).
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import types

from statwalk.maths.compiling import FLOAT, LONG, inlined, kernel, read, write
from statwalk.maths.reference import called
from statwalk.maths.simd.lane_functions import any_above, with_lane
from statwalk.maths.simd.lanes import LANES, broadcast, load, store
from statwalk.maths.simd.pose_lanes import ROTATION, SCALE, joint_at, load3, load4, weight_at
from statwalk.maths.simd.pose_layout import end_row, first_row
from statwalk.motion.jump_lanes import number_jump, rotation_jump, vector_jump
from statwalk.motion.layer_lanes import MASKS
from statwalk.stage.state.pose_offsets import OFFSETS, TRANSITIONS
from statwalk.stage.steps.offset_clocks import has_room, take_slot
from statwalk.stage.steps.offset_lanes import (
    BEGINS,
    BLANK,
    EARLIER,
    JOINT,
    NOW,
    clock_at,
    read_clocks,
)
from statwalk.stage.steps.offset_shares import jump_at, keep_jump, share_out

ZERO, ONE = np.float32(0), np.float32(1)


@inlined
def begins_here(transitions: Any, block: int) -> bool:
    """Returns whether a blend begins in an actor of the block."""
    for row in range(first_row(block), end_row(block, transitions.seconds.shape[0])):
        for layer in range(transitions.seconds.shape[1]):
            if transitions.seconds[row, layer] > 0.0:
                return True
    return False


@inlined
def _read_transitions(offsets: Any, transitions: Any, block: int, layer: int, scratch: Any) -> None:
    """Writes into the scratch which of sixteen actors begin a blend in a layer, and takes a slot for the
    layer if one does.
    """
    begins = broadcast(ZERO)
    first = first_row(block)
    for row in range(first, end_row(block, transitions.seconds.shape[0])):
        begins = with_lane(begins, row - first, ONE if transitions.seconds[row, layer] > 0.0 else ZERO)
    store(scratch, clock_at(layer, BEGINS), begins)
    store(scratch, clock_at(layer, BLANK), begins)
    if any_above(begins, broadcast(ZERO)):
        take_slot(offsets, block, layer)


@inlined
def read_block(offsets: Any, transitions: Any, block: int, dt: float, scratch: Any) -> None:
    """Writes into the scratch what a block's layers have on top at the tick before, and which layers begin a
    blend.
    """
    for layer in range(offsets.slot.shape[1]):
        read_clocks(offsets, block, layer, 0.0, scratch, NOW)
        read_clocks(offsets, block, layer, dt, scratch, EARLIER)
        _read_transitions(offsets, transitions, block, layer, scratch)


@inlined
def start_clocks(offsets: Any, transitions: Any, block: int, root_delta: Any) -> None:
    """Starts the clocks of transitions that begin, and stores `root_delta` (N, 3), the root motion of the
    tick before, for actors whose base layer begins one.
    """
    for row in range(first_row(block), end_row(block, transitions.seconds.shape[0])):
        for layer in range(transitions.seconds.shape[1]):
            if transitions.seconds[row, layer] > 0.0:
                offsets.elapsed[row, layer], offsets.duration[row, layer] = (
                    0.0,
                    transitions.seconds[row, layer],
                )
                offsets.quintic[row, layer] = transitions.quintic[row, layer]
        if transitions.seconds[row, 0] > 0.0:
            for axis in range(3):
                offsets.old_root_delta[row, axis] = root_delta[row, axis]


@inlined
def jump_of_joint(
    poses: Any, at: int, ahead: int, joint: int, layers: int, per_second: Any, scratch: Any
) -> None:
    """Writes the jumps of a joint into the scratch; `poses`: before and shown at block `at`, new and
    following at block `ahead`.
    """
    before, shown, new, following = poses
    a, b = joint_at(before, at, joint), joint_at(shown, at, joint)
    c, d = joint_at(new, ahead, joint), joint_at(following, ahead, joint)
    keep_jump(
        scratch,
        layers,
        0,
        vector_jump(load3(before, a), load3(shown, b), load3(new, c), load3(following, d), per_second),
    )
    turns = (
        load4(before, a + ROTATION),
        load4(shown, b + ROTATION),
        load4(new, c + ROTATION),
        load4(following, d + ROTATION),
    )
    keep_jump(scratch, layers, 3, rotation_jump(turns[0], turns[1], turns[2], turns[3], per_second))
    scales = (
        load3(before, a + SCALE),
        load3(shown, b + SCALE),
        load3(new, c + SCALE),
        load3(following, d + SCALE),
    )
    keep_jump(scratch, layers, 6, vector_jump(scales[0], scales[1], scales[2], scales[3], per_second))


@inlined
def jump_of_weight(
    poses: Any, at: int, ahead: int, joints: int, weight: int, layers: int, per_second: Any, scratch: Any
) -> None:
    """Writes the jump of a morph weight into the scratch; `poses` as in `jump_of_joint`."""
    before, shown, new, following = poses
    a, b = weight_at(before, at, joints, weight), weight_at(shown, at, joints, weight)
    c, d = weight_at(new, ahead, joints, weight), weight_at(following, ahead, joints, weight)
    start, rate = number_jump(load(before, a), load(shown, b), load(new, c), load(following, d), per_second)
    store(scratch, jump_at(layers, 0), start)
    store(scratch, jump_at(layers, 0) + JOINT * LANES, rate)


@called
def begin_offsets(
    offsets: Any, masks: Any, poses: Any, at: int, ahead: int, block: int, dt: float, scratch: Any
) -> None:
    """Gives the jumps of a block, after `read_block`, to the uppermost layers that begin a blend; `poses` as
    in `jump_of_joint`.
    """
    per_second, layers, joints = (
        broadcast(types.float32(1.0 / dt)),
        masks.joints.shape[0],
        masks.joints.shape[1],
    )
    for joint in range(joints):
        jump_of_joint(poses, at, ahead, joint, layers, per_second, scratch)
        share_out(offsets, block, JOINT * joint, JOINT, masks.joints, joint, per_second, scratch)
    for weight in range(masks.weights.shape[1]):
        jump_of_weight(poses, at, ahead, joints, weight, layers, per_second, scratch)
        share_out(offsets, block, JOINT * joints + weight, 1, masks.weights, weight, per_second, scratch)


@inlined
def begin_block(
    offsets: Any,
    transitions: Any,
    masks: Any,
    poses: Any,
    block: int,
    ahead: int,
    root_delta: Any,
    dt: float,
    scratch: Any,
) -> None:
    """Begins the transitions of a block's actors at the tick before this one, if one layer of each actor
    changes; needs `has_room`.

    `poses` are buffers: two ticks before this one, one tick before, and, in block `ahead`, the poses of the
    new motions now and a tick later; `root_delta` (N, 3) is the root motion of the tick before.
    """
    read_block(offsets, transitions, block, dt, scratch)
    begin_offsets(offsets, masks, poses, block, ahead, block, dt, scratch)
    start_clocks(offsets, transitions, block, root_delta)


@kernel(
    OFFSETS, TRANSITIONS, MASKS, read(FLOAT, 3), read(FLOAT, 3), read(FLOAT, 3), read(FLOAT, 3),
    read(types.float64, 2), types.float64, LONG, write(FLOAT, 2), returns=LONG,
)  # fmt: skip
def begin(
    offsets: Any, transitions: Any, masks: Any, before: Any, shown: Any, new: Any, following: Any,
    root_delta: Any, dt: float, first: int, scratch: Any,
) -> int:  # fmt: skip
    """Runs `begin_block` for the blocks from `first` on; returns the first block without room, else the
    number of blocks.
    """
    for block in range(first, offsets.slot.shape[0]):
        if begins_here(transitions, block):
            if not has_room(offsets):
                return block
            begin_block(
                offsets,
                transitions,
                masks,
                (before, shown, new, following),
                block,
                block,
                root_delta,
                dt,
                scratch,
            )
    return int(offsets.slot.shape[0])
