"""FABRIK: the joints are pulled along the chain from the target to the start, and back (IK14, IK15; Aristidou
and Lasenby 2011).
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.simd.lane_elementary import of
from statwalk.maths.simd.lane_functions import any_above, most, root, where_below
from statwalk.maths.simd.lane_quat import conjugate, minus, mul, plus, rotated, vector_square
from statwalk.maths.simd.lane_turns import between
from statwalk.maths.simd.lane_vector import added, length
from statwalk.maths.simd.lanes import broadcast, load, spread
from statwalk.maths.simd.pose_lanes import either3, load3, load4, store3, store4
from statwalk.solve.chain_lanes import AIM, JOINT, LENGTH, LOCAL, OFFSET, POINT, place_joints
from statwalk.solve.iterate import FAR, goes_on, keep_better, note_cuts, take_best, turned_by

ZERO, ONE = np.float32(0), np.float32(1)


@called
def solve_fabrik(
    chains: Any, clamps: Any, number: int, goal: Any, active: Any, best: Any, whole: Any, scratch: Any
) -> Any:
    """Pulls the joints until the end is within the chain's tolerance of the goal; returns the iterations.

    `active`: above 0 in lanes with work to do; `best`: the distance of the pose at BEST. Joints with limits
    or sensitivities turn in every iteration; without them, positions are enough until the last.
    """
    count = chains.first[number + 1] - chains.first[number]
    zero, one, tolerance = broadcast(ZERO), broadcast(ONE), spread(chains.tolerance, number)
    active = where_below(zero, active, where_below(tolerance, best, one, zero), zero)
    place_joints(scratch, count, LOCAL)
    iterations, before, last = zero, active, of(FAR)
    is_free = chains.is_free[number]
    for _ in range(chains.iterations[number]):
        if not any_above(active, zero):
            break
        pull_back(scratch, count, goal)
        iterations = iterations + active
        if is_free:
            distance = length(minus(goal, pull_forth(scratch, count, active)))
        else:
            distance = length(minus(goal, turn_to_points(chains, clamps, number, AIM, scratch)))
            note_cuts(chains, clamps, number, active, scratch)
            better = where_below(distance, best, active, zero)
            best = keep_better(scratch, count, better, distance, best)
        active, last = goes_on(active, distance, last, tolerance, whole), distance
    if is_free:
        distance = length(minus(goal, turn_to_points(chains, clamps, number, POINT, scratch)))
        keep_better(scratch, count, where_below(distance, best, before, zero), distance, best)
    take_best(scratch, count)
    return iterations


@inlined
def pull_back(scratch: Any, count: int, goal: Any) -> None:
    """Puts the end at the goal, and each joint, from the end to the start, at its bone's length; writes the
    points to AIM.
    """
    after = goal
    store3(scratch, (count - 1) * JOINT + AIM, goal)
    for step in range(count - 2):
        at = (count - 2 - step) * JOINT
        after = _at_length(after, load3(scratch, at + POINT), load(scratch, at + JOINT + LENGTH))
        store3(scratch, at + AIM, after)


@inlined
def pull_forth(scratch: Any, count: int, active: Any) -> Any:
    """Puts each joint, from the start to the end, at its bone's length; writes the points of active lanes to
    POINT; returns the end.
    """
    before = load3(scratch, POINT)
    for place in range(1, count):
        at = place * JOINT
        moved = _at_length(before, load3(scratch, at + AIM), load(scratch, at + LENGTH))
        before = either3(active, moved, load3(scratch, at + POINT))
        store3(scratch, at + POINT, before)
    return before


@inlined
def _at_length(origin: Any, point: Any, bone: Any) -> Any:
    """The point at a bone's length from the origin, in the direction of `point`."""
    way = minus(point, origin)
    return added(origin, way, bone / root(most(vector_square(way), of(1e-30))))


@inlined
def turn_to_points(chains: Any, clamps: Any, number: int, points: int, scratch: Any) -> Any:
    """Turns each joint, from the start on, so that its bone points at the next of the points (at AIM or
    POINT), as far as it may; writes rotations and places; returns the end.
    """
    first, count = chains.first[number], chains.first[number + 1] - chains.first[number]
    zero, one = broadcast(ZERO), broadcast(ONE)
    above, place_now = (zero, zero, zero, one), load3(scratch, OFFSET)
    for place in range(count - 1):
        at = place * JOINT
        q, offset = load4(scratch, at + LOCAL), load3(scratch, at + JOINT + OFFSET)
        if chains.sensitivity[first + place] > ZERO:
            way = rotated(conjugate(above), minus(load3(scratch, at + JOINT + points), place_now))
            q = turned_by(chains, clamps, first + place, between(rotated(q, offset), way), q, scratch, at)
            store4(scratch, at + LOCAL, q)
        above = mul(above, q)
        place_now = plus(place_now, rotated(above, offset))
        store3(scratch, at + JOINT + POINT, place_now)
    return place_now
