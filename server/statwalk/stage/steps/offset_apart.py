"""The jumps of single layers, if several layers of an actor change in the same tick.

The jump of a layer is what exchanging its motion alone does to the pose. Of the layers of an actor that
change in a tick, let C be the layers that cut, and F the layers that begin a blend, from the base up F1 … Fn.
Let P(o, k, a, b) be the pose in which the layers of C show their new motion of this tick, F1 … Fk-1 too, Fk
its old motion o ticks or its new motion a ticks from now, and the layers above Fk their old motion of the
tick before.

- A layer of C gets no offset. What was shown is replaced by U, what would have been shown if the layers of C
  had played their new motions before: the old motions of F, at the tick before and the one before that, over
  the new motions of C as they stand in this tick, and on top what was left of all offsets then. The new
  motions of F follow over C held still, so that the velocity of C does not get into an offset.
- Fk below Fn gets what it had on top and its own jump: old motion, two ticks and one tick before this one,
  against its new motion, now and a tick later, all other layers held still.
- Fn gets the rest of the whole jump from U (if C is empty: from what was shown) to what comes, so the sum is
  exact and the pose does not jump. On channels that Fn does not move the next layer below takes its place.

All jumps are jumps of `motion.jump_lanes`, offset and velocity. In lanes in which one layer changes, U is
what was shown, no Fk lies below Fn, and the bits equal `offset_begin.begin_block`.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import types

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.simd.lane_functions import any_above, either, most
from statwalk.maths.simd.lanes import LANES, broadcast, load, store
from statwalk.maths.simd.pose_layout import end_row, first_row
from statwalk.stage.steps._kernels import express_block, look_ahead, sample_layers
from statwalk.stage.steps.offset_begin import (
    begin_block,
    begin_offsets,
    jump_of_joint,
    jump_of_weight,
    read_block,
    start_clocks,
)
from statwalk.stage.steps.offset_cuts import BEFORE, COMING, FOLLOWING, SHOWN, cut_lanes, put_at
from statwalk.stage.steps.offset_lanes import (
    BEGINS,
    BLANK,
    EARLIER,
    JOINT,
    NOW,
    OWNS,
    add_block,
    clock_at,
)
from statwalk.stage.steps.offset_shares import give_part

ZERO, ONE = np.float32(0), np.float32(1)
ALL = -1
"""instead of a layer: all layers that begin a blend"""


@inlined
def _change_together(transitions: Any, block: int) -> bool:
    """Whether a blend begins in an actor of a block while another of its layers also changes."""
    for row in range(first_row(block), end_row(block, transitions.seconds.shape[0])):
        begins = changes = 0
        for layer in range(transitions.seconds.shape[1]):
            begins += 1 if transitions.seconds[row, layer] > 0.0 else 0
            changes += 1 if transitions.seconds[row, layer] >= 0.0 else 0
        if begins > 0 and changes > 1:
            return True
    return False


@called
def _sample_mixed(
    p: Any, m: Any, t: Any, s: Any, masks: Any, done: Any, mem: Any, exchanged: int, moment: int, out: Any,
    block: int, dt: float,
) -> None:  # fmt: skip
    """Puts the poses of a block into `out`, with the layer `exchanged`, or ALL layers that begin a blend, at
    a moment.

    Layers above a single exchanged layer that begin a blend stay at the tick before; all other layers are at
    this tick.
    """
    for row in range(first_row(block), end_row(block, s.state.shape[0])):
        for layer in range(s.state.shape[1]):
            at = COMING
            if mem.seconds[row, layer] > 0.0 and layer >= exchanged:
                at = moment if exchanged == ALL or layer == exchanged else SHOWN
            put_at(p, s, done, mem, row, layer, at, dt)
    sample_layers(m, t, s, masks, mem, mem.mixed_state, mem.mixed_time, out, block)


@inlined
def _keep(lanes: Any, poses: Any, others: Any, at: int) -> None:
    """Keeps the poses of a one-block buffer in some lanes; the other lanes are copied from block `at` of
    `others`.
    """
    base = at * others.shape[1] * LANES
    for place in range(0, poses.shape[1] * LANES, LANES):
        store(poses, place, either(lanes, load(poses, place), load(others, base + place)))


@called
def _sample_uncut(
    p: Any, m: Any, t: Any, s: Any, o: Any, masks: Any, done: Any, mem: Any, previous: Any, shown: Any,
    block: int, dt: float,
) -> None:  # fmt: skip
    """Puts U of a block into its buffers, and the poses that follow on U; in lanes without a cut, what was
    shown and what follows.
    """
    cuts = cut_lanes(mem, block)
    _sample_mixed(p, m, t, s, masks, done, mem, ALL, BEFORE, mem.uncut_before, block, dt)
    add_block(o, masks, mem.uncut_before, 0, block, dt, mem.scratch)
    _keep(cuts, mem.uncut_before, previous, block)
    _sample_mixed(p, m, t, s, masks, done, mem, ALL, SHOWN, mem.uncut_shown, block, dt)
    add_block(o, masks, mem.uncut_shown, 0, block, 0.0, mem.scratch)
    _keep(cuts, mem.uncut_shown, shown, block)
    _sample_mixed(p, m, t, s, masks, done, mem, ALL, FOLLOWING, mem.part_following, block, dt)
    _keep(broadcast(ONE) - cuts, mem.following, mem.part_following, 0)


@inlined
def _find_partial(layers: int, layer: int, scratch: Any) -> Any:
    """Marks the lanes in which a layer and a layer above it begin a blend; returns whether any lane is
    marked.
    """
    above = broadcast(ZERO)
    for upper in range(layer + 1, layers):
        above = most(above, load(scratch, clock_at(upper, BEGINS)))
    lanes = above * load(scratch, clock_at(layer, BEGINS))
    store(scratch, clock_at(layer, OWNS), lanes)
    return any_above(lanes, broadcast(ZERO))


@inlined
def _put_factors(lanes: Any, at: int, start: Any, rate: Any, scratch: Any) -> None:
    """Writes factors of start and velocity into the scratch, in some lanes."""
    store(scratch, at, either(lanes, broadcast(start), load(scratch, at)))
    store(scratch, at + LANES, either(lanes, broadcast(rate), load(scratch, at + LANES)))


@inlined
def _count_as_given(layer: int, dt: float, scratch: Any) -> None:
    """Treats the offset that a layer has just got as an offset that it had on top."""
    lanes, blank = load(scratch, clock_at(layer, OWNS)), load(scratch, clock_at(layer, BLANK))
    store(scratch, clock_at(layer, BLANK), blank - lanes)
    _put_factors(lanes, clock_at(layer, NOW), ONE, ZERO, scratch)
    _put_factors(lanes, clock_at(layer, EARLIER), ONE, types.float32(-dt), scratch)


@called
def _begin_part(o: Any, masks: Any, mem: Any, block: int, layer: int, dt: float) -> None:
    """Gives a layer its own jump, in the lanes of OWNS."""
    per_second, scratch = broadcast(types.float32(1.0 / dt)), mem.scratch
    poses, layers = (mem.part_before, mem.part_shown, mem.part_coming, mem.part_following), o.slot.shape[1]
    joints = masks.joints.shape[1]
    for joint in range(joints):
        jump_of_joint(poses, 0, 0, joint, layers, per_second, scratch)
        moves = masks.joints[layer, joint]
        give_part(o, block, layer, JOINT * joint, JOINT, moves, per_second, scratch)
    for weight in range(masks.weights.shape[1]):
        jump_of_weight(poses, 0, 0, joints, weight, layers, per_second, scratch)
        moves = masks.weights[layer, weight]
        give_part(o, block, layer, JOINT * joints + weight, 1, moves, per_second, scratch)


@called
def _begin_apart(
    p: Any, m: Any, t: Any, s: Any, o: Any, masks: Any, done: Any, mem: Any, previous: Any, shown: Any,
    block: int, root_delta: Any, dt: float,
) -> None:  # fmt: skip
    """Begins the transitions of a block's actors, each layer with its own jump."""
    _sample_uncut(p, m, t, s, o, masks, done, mem, previous, shown, block, dt)
    read_block(o, mem, block, dt, mem.scratch)
    for layer in range(o.slot.shape[1] - 1):
        if _find_partial(o.slot.shape[1], layer, mem.scratch):
            _sample_mixed(p, m, t, s, masks, done, mem, layer, BEFORE, mem.part_before, block, dt)
            _sample_mixed(p, m, t, s, masks, done, mem, layer, SHOWN, mem.part_shown, block, dt)
            _sample_mixed(p, m, t, s, masks, done, mem, layer, COMING, mem.part_coming, block, dt)
            _sample_mixed(p, m, t, s, masks, done, mem, layer, FOLLOWING, mem.part_following, block, dt)
            _begin_part(o, masks, mem, block, layer, dt)
            _count_as_given(layer, dt, mem.scratch)
    poses = mem.uncut_before, mem.uncut_shown, mem.coming, mem.following
    begin_offsets(o, masks, poses, 0, 0, block, dt, mem.scratch)
    start_clocks(o, mem, block, root_delta)


@inlined
def begin_transitions(
    p: Any, m: Any, t: Any, s: Any, o: Any, masks: Any, done: Any, mem: Any, previous: Any, shown: Any,
    block: int, root_delta: Any, dt: float,
) -> None:  # fmt: skip
    """Begins the transitions of a block's actors at the tick before this one; needs `has_room`.

    `previous` and `shown` are the buffers shown two ticks and one tick before this one; `root_delta` (N, 3)
    is the root motion of the tick before; `mem.coming` has the poses of this tick.
    """
    look_ahead(p, s, mem, block, dt)
    sample_layers(m, t, s, masks, mem, s.state, mem.ahead, mem.following, block)
    # what was shown has the machine's expressions in it: they must be no part of the jump
    express_block(t.expressions, s.smoothed, 0.0, mem, mem.coming, block)
    express_block(t.expressions, s.smoothed, 1.0, mem, mem.following, block)
    if _change_together(mem, block):
        _begin_apart(p, m, t, s, o, masks, done, mem, previous, shown, block, root_delta, dt)
    else:
        poses = previous, shown, mem.coming, mem.following
        begin_block(o, mem, masks, poses, block, 0, root_delta, dt, mem.scratch)
