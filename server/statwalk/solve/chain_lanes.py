"""A chain of sixteen actors in memory, while a solver works on it.

All is in the frame of the start's parent, without its scale: metres as in model space. Scales along the chain
and above it are taken as even (the same along x, y and z); uneven ones give an approximate result.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import inlined
from statwalk.maths.simd.lane_bits import natural
from statwalk.maths.simd.lane_elementary import of
from statwalk.maths.simd.lane_functions import any_above, fused, least, most, where_below
from statwalk.maths.simd.lane_quat import minus, mul, normalized, plus, rotated, slerp
from statwalk.maths.simd.lane_vector import added, dot, length, times
from statwalk.maths.simd.lanes import LANES, broadcast, store
from statwalk.maths.simd.pose_lanes import ROTATION, SCALE, either4, joint_at, load3, load4, store3, store4

ZERO, ONE = np.float32(0), np.float32(1)
LOCAL, OFFSET, POINT, TURN, BEST, AIM, LENGTH, CUT, NOTED, TURNED = (
    0,
    4 * LANES,
    7 * LANES,
    10 * LANES,
    14 * LANES,
    18 * LANES,
    21 * LANES,
    22 * LANES,
    23 * LANES,
    24 * LANES,
)
"""floats of a joint in memory: its rotation from its parent; its place in its parent's frame; its place, and
the rotation of its parent, in the chain's frame; the best rotation so far; a vector of the solver's; the
length of the bone before it; by how much its limits cut its last turn (the square of the sine of half the
angle), and the same in the last iteration that counted; the turn carried from tick to tick
"""
JOINT = 28 * LANES
"""floats of a joint in memory"""


def scratch_floats(joints: int) -> int:
    """Returns how many float32 a solver needs as scratch for a chain of so many joints."""
    return JOINT * joints


@inlined
def base_frame(chains: Any, number: int, values: Any, block: int) -> Any:
    """Returns position, rotation and scale, in model space, of the parent of a chain's start."""
    zero, one = broadcast(ZERO), broadcast(ONE)
    position, rotation, scale = (zero, zero, zero), (zero, zero, zero, one), (one, one, one)
    for row in range(chains.first_ancestor[number], chains.first_ancestor[number + 1]):
        at = joint_at(values, block, chains.ancestor[row])
        position = plus(position, rotated(rotation, times(scale, load3(values, at))))
        rotation = mul(rotation, load4(values, at + ROTATION))
        scale = times(scale, load3(values, at + SCALE))
    return position, rotation, scale


@inlined
def read_chain(chains: Any, number: int, values: Any, block: int, scale: Any, scratch: Any) -> None:
    """Writes the rotations and places of the chain's joints into the scratch."""
    first = natural(chains.first[number])
    for place in range(chains.first[number + 1] - first):
        at = joint_at(values, block, chains.joint[first + place])
        store4(scratch, place * JOINT + LOCAL, load4(values, at + ROTATION))
        store3(scratch, place * JOINT + OFFSET, times(scale, load3(values, at)))
        scale = times(scale, load3(values, at + SCALE))
        if chains.is_noted[number]:
            store(scratch, place * JOINT + CUT, broadcast(ZERO))
            store(scratch, place * JOINT + NOTED, broadcast(ZERO))


@inlined
def place_joints(scratch: Any, count: int, local: int) -> Any:
    """Computes places and parents' rotations of the first `count` joints from their rotations, which are at
    LOCAL or BEST; returns the place of the last.
    """
    zero, one = broadcast(ZERO), broadcast(ONE)
    point, turn = (zero, zero, zero), (zero, zero, zero, one)
    for place in range(count):
        at = place * JOINT
        if place > 0:
            turn = mul(turn, load4(scratch, at - JOINT + local))
        point = plus(point, rotated(turn, load3(scratch, at + OFFSET)))
        store3(scratch, at + POINT, point)
        store4(scratch, at + TURN, turn)
    return point


@inlined
def end_of(scratch: Any, count: int) -> Any:
    """Returns the place of the last joint, from the rotations at LOCAL: without the places between."""
    end = load3(scratch, (count - 1) * JOINT + OFFSET)
    for step in range(count - 1):
        at = (count - 2 - step) * JOINT
        end = plus(load3(scratch, at + OFFSET), rotated(load4(scratch, at + LOCAL), end))
    return end


@inlined
def chain_length(scratch: Any, count: int) -> Any:
    """Returns the sum of the lengths of the bones, and writes each to LENGTH."""
    whole = broadcast(ZERO)
    for place in range(1, count):
        bone = length(load3(scratch, place * JOINT + OFFSET))
        store(scratch, place * JOINT + LENGTH, bone)
        whole = whole + bone
    return whole


@inlined
def softened(target: Any, start: Any, reach: Any, softening: Any) -> Any:
    """Returns the target, drawn towards the chain's start: a chain eases towards full stretch from
    `softening` metres before it (at most half its length), and never comes quite to it.

    A target x · softening beyond the beginning of this zone is brought to softening · (1 − 1 / (1 + x/4)⁴)
    beyond it: the slope at the beginning is 1.
    """
    if not any_above(softening, broadcast(ZERO)):
        return target
    aim, softening = minus(target, start), least(softening, reach * of(0.5))
    distance, one = length(aim), broadcast(ONE)
    beyond = most(distance - (reach - softening), broadcast(ZERO))
    zone = most(softening, of(1e-9))
    share = one / (one + of(0.25) * beyond / zone)
    share = share * share
    eased = (reach - softening) + softening * (one - share * share)
    wanted = where_below(broadcast(ZERO), least(beyond, softening), eased, distance)
    return added(start, aim, wanted / most(distance, of(1e-12)))


@inlined
def write_joint(values: Any, at: int, solved: Any, weight: Any) -> Any:
    """Writes a joint's rotation: from that of the pose (weight 0) to the solved one (1); returns it."""
    old, zero, one = load4(values, at + ROTATION), broadcast(ZERO), broadcast(ONE)
    alike = fused(old[3], solved[3], dot(old, solved))
    solved = (
        where_below(alike, zero, -solved[0], solved[0]),
        where_below(alike, zero, -solved[1], solved[1]),
        where_below(alike, zero, -solved[2], solved[2]),
        where_below(alike, zero, -solved[3], solved[3]),
    )
    if any_above(one, weight):
        partly = normalized(slerp(old, solved, least(most(weight, zero), one)))
        solved = either4(weight, either4(one - weight, partly, solved), old)
    store4(values, at + ROTATION, solved)
    return solved
