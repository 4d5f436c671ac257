"""The force solver: a force at the end of the chain pulls it to the target (IK13; RTCA 2.4 `solvejoint`)."""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.simd.lane_elementary import of
from statwalk.maths.simd.lane_functions import (
    any_above,
    either,
    least,
    most,
    root,
    size,
    where_below,
    with_sign,
)
from statwalk.maths.simd.lane_quat import minus, mul, normalized, plus, rotated, rotated_back, vector_square
from statwalk.maths.simd.lane_vector import added, cross, length
from statwalk.maths.simd.lanes import broadcast, spread
from statwalk.maths.simd.pose_lanes import load3, load4, store3, store4
from statwalk.solve.chain_lanes import AIM, JOINT, LOCAL, OFFSET, place_joints
from statwalk.solve.iterate import FAR, keep_better, limited, note_cuts, take_best

ZERO, ONE, HALF = np.float32(0), np.float32(1), np.float32(0.5)
LARGEST_STEP = 0.25
"""radians about one axis in one step"""
STALLED = 1e-7
"""metres, as a part of the chain's length: a step that changes the distance by less is the last"""


@called
def solve_force(
    chains: Any, clamps: Any, number: int, goal: Any, active: Any, best: Any, whole: Any, scratch: Any
) -> Any:
    """Makes small steps until the end is within the chain's tolerance of the goal; returns the steps.

    `active`: above 0 in lanes with work to do; `best`: the distance of the pose at BEST.
    """
    count = chains.first[number + 1] - chains.first[number]
    zero, one, tolerance = broadcast(ZERO), broadcast(ONE), spread(chains.tolerance, number)
    active = where_below(zero, active, where_below(tolerance, best, one, zero), zero)
    iterations, last, per_length = zero, of(FAR), one / most(whole, of(1e-12))
    gain = spread(chains.gain, number) / of(float(count - 1))
    pulled, mark, is_far = _pulled(goal, whole, scratch)
    now = length(minus(mark, place_joints(scratch, count, LOCAL)))
    best = either(is_far, now, best)
    for _ in range(chains.iterations[number]):
        if not any_above(active, zero):
            break
        distance = length(minus(mark, _step(chains, clamps, number, pulled, gain, per_length, scratch)))
        note_cuts(chains, number, active, scratch)
        iterations = iterations + active
        better = where_below(distance, best, active, zero)
        best = keep_better(scratch, count - 1, better, distance, best)
        active = where_below(tolerance, best, active, zero)
        active = where_below(whole * of(STALLED), size(distance - last), active, zero)
        last = distance
    take_best(scratch, count - 1)
    return iterations


@inlined
def _step(chains: Any, clamps: Any, number: int, goal: Any, gain: Any, per_length: Any, scratch: Any) -> Any:
    """Turns each joint once about each of its axes, from the end back to the start; returns the end."""
    first, count = chains.first[number], chains.first[number + 1] - chains.first[number]
    seen = goal
    for place in range(count - 1):
        aim = minus(seen, load3(scratch, place * JOINT + OFFSET))
        seen = rotated_back(load4(scratch, place * JOINT + LOCAL), aim)
        store3(scratch, place * JOINT + AIM, seen)
    end = load3(scratch, (count - 1) * JOINT + OFFSET)
    for step in range(count - 1):
        place = count - 2 - step
        at, q = place * JOINT, load4(scratch, place * JOINT + LOCAL)
        if chains.sensitivity[first + place] > ZERO:
            part = gain * spread(chains.sensitivity, first + place)
            seen, bone = load3(scratch, at + AIM), load3(scratch, at + JOINT + OFFSET)
            for axis in range(3):
                turn = _turn(axis, bone, minus(seen, end), per_length, part)
                seen, q = rotated_back(turn, seen), mul(q, turn)
            q = limited(chains, clamps, first + place, normalized(q), broadcast(ONE), scratch, at)
            store4(scratch, at + LOCAL, q)
        end = plus(load3(scratch, at + OFFSET), rotated(q, end))
    return end


@inlined
def _pulled(goal: Any, whole: Any, scratch: Any) -> Any:
    """Where the force pulls to: to half a length beyond full stretch for a target there or out of reach, so
    that the chain becomes straight; the point nearest to the target within reach, from which the end's
    distance counts; and 1 in lanes with a target at full stretch or out of reach, else 0.
    """
    start, zero, one = load3(scratch, OFFSET), broadcast(ZERO), broadcast(ONE)
    aim = minus(goal, start)
    far = most(length(aim), of(1e-12))
    is_far = where_below(whole * of(1 - 1e-4), far, one, zero)
    pulled = added(start, aim, either(is_far, whole * of(1.5) / far, one))
    return pulled, added(start, aim, least(whole / far, one)), is_far


@inlined
def _turn(axis: int, bone: Any, force: Any, per_length: Any, gain: Any) -> Any:
    """The turn about one of the joint's own axes A, X Y Z for `axis` 0 1 2: by gain · |F| · sin∠(A,F) ·
    sin∠(B,F) · sign((A×B)·F), where |F| is measured in lengths of the chain and counts as at most 1.
    """
    zero, one, tiny = broadcast(ZERO), broadcast(ONE), of(1e-30)
    torque = cross(bone, force)  # (A×B)·F = A·(B×F)
    along = force[0] if axis == 0 else (force[1] if axis == 1 else force[2])
    about = torque[0] if axis == 0 else (torque[1] if axis == 1 else torque[2])
    square, twist = most(vector_square(force), tiny), vector_square(torque)
    sines = twist / most(square * vector_square(bone), tiny) * most(one - along * along / square, zero)
    angle = root(least(square * per_length * per_length, one) * sines) * gain
    # an axis along the bone has no sign
    angle = where_below(
        of(1e-6) * twist, about * about, with_sign(least(angle, of(LARGEST_STEP)), about), zero
    )
    half = angle * broadcast(HALF)
    factor = one / root(one + half * half)
    sine, cosine = half * factor, factor
    return (
        sine if axis == 0 else zero,
        sine if axis == 1 else zero,
        sine if axis == 2 else zero,
        cosine,
    )
