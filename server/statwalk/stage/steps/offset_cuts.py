"""The past of actors in whose layers a motion is cut, for sixteen actors at a time.

A blend takes its velocity from the poses of the last two ticks. Between them a cut would count as a velocity,
and a blend in the next tick would swing far beyond both motions. So a cut replaces what was shown: the layers
that cut go back from their new motion's pose by as much as they will advance in the next tick; all other
layers stay where they were. What expressions, springs and solvers had added to the old motion is kept.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.machine.runtime.pace import motion_seconds
from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.simd.lane_functions import either, with_lane
from statwalk.maths.simd.lane_quat import conjugate, minus, mul, plus, renormalized
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
from statwalk.stage.steps._kernels import look_ahead, sample_layers, time_in
from statwalk.stage.steps.offset_lanes import add_block

ZERO, ONE = np.float32(0), np.float32(1)
BEFORE, SHOWN, COMING, FOLLOWING = -2, -1, 0, 1
"""moments of a layer, in ticks from now: the first two of its old motion, the last two of its new motion"""


@inlined
def cuts_here(transitions: Any, block: int) -> bool:
    """Returns whether a layer of an actor of the block cuts."""
    for row in range(first_row(block), end_row(block, transitions.seconds.shape[0])):
        for layer in range(transitions.seconds.shape[1]):
            if transitions.seconds[row, layer] == 0.0:
                return True
    return False


@inlined
def cut_lanes(transitions: Any, block: int) -> Any:
    """Returns the lanes of a block in which a layer cuts."""
    cuts, first = broadcast(ZERO), first_row(block)
    for row in range(first, end_row(block, transitions.seconds.shape[0])):
        for layer in range(transitions.seconds.shape[1]):
            if transitions.seconds[row, layer] == 0.0:
                cuts = with_lane(cuts, row - first, ONE)
    return cuts


@inlined
def put_at(p: Any, s: Any, done: Any, mem: Any, row: int, layer: int, moment: int, dt: float) -> None:
    """Writes state and seconds of an actor's layer at a moment of its old or new motion."""
    state, time = s.state[row, layer], s.time[row, layer]
    if moment == FOLLOWING:
        time = mem.ahead[row, layer]
    elif moment != COMING:
        state, time = mem.old_state[row, layer], done.before[row, layer]
    if moment == BEFORE:
        time = max(time_in(p, state, time - motion_seconds(p, s, mem.weights, row, state, time, dt)), 0.0)
    mem.mixed_state[row, layer], mem.mixed_time[row, layer] = state, time


@called
def _sample_cut(
    p: Any, m: Any, t: Any, s: Any, o: Any, masks: Any, done: Any, mem: Any, moment: int, out: Any,
    block: int, dt: float,
) -> None:  # fmt: skip
    """Puts the poses of a block into `out`: layers that cut at a moment of their new motion, all others, and
    what was left of offsets, at the tick before.
    """
    for row in range(first_row(block), end_row(block, s.state.shape[0])):
        for layer in range(s.state.shape[1]):
            put_at(p, s, done, mem, row, layer, moment if mem.seconds[row, layer] == 0.0 else SHOWN, dt)
    sample_layers(m, t, s, masks, mem, mem.mixed_state, mem.mixed_time, out, block)
    add_block(o, masks, out, 0, block, 0.0, mem.scratch)


@inlined
def _behind(now: Any, following: Any, was: Any, at: int, shown: Any, to: int, cuts: Any) -> None:
    """Puts three numbers as far behind `now` as they are ahead in `following`, and away as they were from
    their motion.
    """
    place, old = load3(now, at), load3(shown, to)
    back = plus(place, minus(place, load3(following, at)))
    store3(shown, to, either3(cuts, plus(back, minus(old, load3(was, at))), old))


@inlined
def _go_back(cuts: Any, now: Any, following: Any, was: Any, shown: Any, block: int, joint: int) -> None:
    """Puts a joint as far behind `now` as it is ahead in `following`, and away as it was from its motion."""
    a, to = joint_at(now, 0, joint), joint_at(shown, block, joint)
    _behind(now, following, was, a, shown, to, cuts)
    turn, on, old = load4(now, a + ROTATION), load4(following, a + ROTATION), load4(shown, to + ROTATION)
    back = mul(turn, mul(conjugate(on), turn))
    added = mul(conjugate(load4(was, a + ROTATION)), old)
    store4(shown, to + ROTATION, either4(cuts, renormalized(mul(back, added)), old))
    _behind(now, following, was, a + SCALE, shown, to + SCALE, cuts)


@called
def forget_cuts(
    p: Any, m: Any, t: Any, s: Any, o: Any, masks: Any, done: Any, mem: Any, shown: Any, block: int,
    dt: float,
) -> None:  # fmt: skip
    """Replaces what a block's actors with a cut have shown one tick before; needs the transitions of this
    tick, and the offsets of the tick before.
    """
    look_ahead(p, s, mem, block, dt)
    _sample_cut(p, m, t, s, o, masks, done, mem, COMING, mem.part_coming, block, dt)
    _sample_cut(p, m, t, s, o, masks, done, mem, FOLLOWING, mem.part_following, block, dt)
    _sample_cut(p, m, t, s, o, masks, done, mem, SHOWN, mem.part_shown, block, dt)
    cuts, joints = cut_lanes(mem, block), masks.joints.shape[1]
    for joint in range(joints):
        _go_back(cuts, mem.part_coming, mem.part_following, mem.part_shown, shown, block, joint)
    for weight in range(masks.weights.shape[1]):
        a, to = weight_at(shown, 0, joints, weight), weight_at(shown, block, joints, weight)
        now, old = load(mem.part_coming, a), load(shown, to)
        back, added = now + (now - load(mem.part_following, a)), old - load(mem.part_shown, a)
        store(shown, to, either(cuts, back + added, old))
