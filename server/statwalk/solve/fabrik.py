"""FABRIK: the joints are pulled along the chain from the target to the start, and back (IK14, IK15; Aristidou
and Lasenby 2011).
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.simd.lane_elementary import of
from statwalk.maths.simd.lane_functions import any_above, either, fused, most, root, size, where_below
from statwalk.maths.simd.lane_quat import (
    minus,
    mul,
    plus,
    renormalized,
    rotated,
    rotated_back,
    scaled,
    vector_square,
)
from statwalk.maths.simd.lane_turns import half_way
from statwalk.maths.simd.lane_vector import added, dot, length, per_root, where3_below
from statwalk.maths.simd.lanes import broadcast, load, spread
from statwalk.maths.simd.pose_lanes import either3, load3, load4, store3, store4
from statwalk.solve.chain_lanes import AIM, JOINT, LENGTH, LOCAL, OFFSET, POINT
from statwalk.solve.iterate import FAR, aimed, goes_on, keep_better, note_cuts, take_best, take_better

ZERO, ONE = np.float32(0), np.float32(1)
CANCELLED, TINY = 1e-6, 1e-36
"""of a sum of squares: a difference of squares below it is rounding; the square of a length that is none"""
UNLIKE = 1e-5
"""of the square of a bone: by how much that of the way between its points may differ"""


@called
def solve_fabrik(
    chains: Any, clamps: Any, number: int, goal: Any, active: Any, best: Any, whole: Any, scratch: Any
) -> Any:
    """Pulls the joints until the end is within the chain's tolerance of the goal; returns the
    iterations and the distance of the best pose.

    `active`: above 0 in lanes with work to do; `best`: the distance of the pose at BEST. Joints with limits
    or sensitivities turn in every iteration; without them, positions are enough until the last.
    """
    count = chains.first[number + 1] - chains.first[number]
    zero, one, tolerance = broadcast(ZERO), broadcast(ONE), spread(chains.tolerance, number)
    active = where_below(zero, active, where_below(tolerance, best, one, zero), zero)
    iterations, before, last = zero, active, of(FAR)
    is_free, upper = chains.is_free[number], (count - 2) * JOINT + POINT
    drawn = fixed(load3(scratch, upper))
    for _ in range(chains.iterations[number]):
        if not any_above(active, zero):
            break
        drawn = pull_back(scratch, count, goal, drawn)
        iterations = iterations + active
        if is_free:
            if any_above(one, active):
                end, drawn = pull_forth(scratch, count, active, False, drawn)
            else:  # nothing to choose
                end, drawn = pull_forth(scratch, count, active, True, drawn)
            distance = length(minus(goal, end))
        else:
            distance = length(minus(goal, turn_to_points(chains, clamps, number, AIM, scratch)))
            note_cuts(chains, number, active, scratch)
            better = where_below(distance, best, active, zero)
            best = keep_better(scratch, count - 1, better, distance, best)
            drawn = fixed(load3(scratch, upper))
        active, last = goes_on(active, distance, last, tolerance, whole), distance
    if is_free:
        distance = length(minus(goal, turn_along(scratch, count)))
        better = where_below(distance, best, before, zero)
        if any_above(one, better):
            take_better(scratch, count - 1, better)
        return iterations, either(better, distance, best)
    take_best(scratch, count - 1)
    return iterations, best


@inlined
def pull_back(scratch: Any, count: int, goal: Any, drawn: Any) -> Any:
    """Puts the end at the goal, and each joint, from the end to the start, at its bone's length; writes the
    points to AIM. `drawn`: the last joint but one; returns the second as it has been drawn.
    """
    store3(scratch, (count - 1) * JOINT + AIM, goal)
    if count == 2:
        return fixed(goal)
    drawn = _drawn_back(drawn, goal, load(scratch, (count - 1) * JOINT + LENGTH))
    for step in range(count - 3):
        at = (count - 3 - step) * JOINT
        drawn = _drawn(drawn, load3(scratch, at + POINT), load(scratch, at + JOINT + LENGTH))
        store3(scratch, at + JOINT + AIM, drawn[0])
    return drawn


@inlined
def pull_forth(scratch: Any, count: int, active: Any, all_move: bool, drawn: Any) -> Any:
    """Puts each joint, from the start to the end, at its bone's length; writes the points of active lanes, or
    of all lanes, to POINT. `drawn`: the second joint; returns the place of the end, and the last joint but
    one as drawn.
    """
    start = load3(scratch, POINT)
    before, drawn = fixed(start), _drawn_back(drawn, start, load(scratch, JOINT + LENGTH))
    for place in range(2, count):
        at, before = place * JOINT, drawn
        drawn = _drawn(drawn, load3(scratch, at + AIM), load(scratch, at + LENGTH))
        _move(scratch, at - JOINT, active, all_move, drawn[0])
    end = _place(drawn)
    _move(scratch, (count - 1) * JOINT, active, all_move, end)
    return end, before


@inlined
def _move(scratch: Any, at: int, active: Any, all_move: bool, point: Any) -> None:
    if not all_move:
        point = either3(active, point, load3(scratch, at + POINT))
    store3(scratch, at + POINT, point)


@inlined
def fixed(point: Any) -> Any:
    """Returns a joint that stays at a point, as `_drawn` returns it."""
    zero = broadcast(ZERO)
    return point, (zero, zero, zero), (zero, zero), zero


@inlined
def _place(drawn: Any) -> Any:
    """Where a joint has been drawn to."""
    origin, way, (length_of_way, per_square), _ = drawn
    return added(origin, way, length_of_way * per_square)


@inlined
def _drawn(drawn: Any, point: Any, bone: Any) -> Any:
    """Draws a joint from `point` to a bone's length from the joint before it: returns the place of that one,
    the way from there to `point`, the two numbers whose product is the factor of the way, and the bone.

    Only roots take long, so the square of the way does not wait for the way: with o + w·f the place of the
    joint before, its bone |w·f|, and v = point − o, it is |v|² + |w·f|² − 2 f w·v.
    """
    origin, way, (length_of_way, per_square), last = drawn
    from_origin = minus(point, origin)
    squares = fused(last, last, vector_square(from_origin))
    both = dot(from_origin, way)
    square = fused(-(both + both) * per_square, length_of_way, squares)
    square, factor = most(square, fused(squares, of(CANCELLED), of(TINY))), length_of_way * per_square
    return added(origin, way, factor), added(from_origin, way, -factor), _factors(bone, square), bone


@inlined
def _drawn_back(drawn: Any, point: Any, bone: Any) -> Any:
    """Draws a joint, from where it has been drawn to, to a bone's length from a point that stays.

    The length of the last bone is measured here, so that rounding does not add up from pass to pass.
    """
    origin, way, (length_of_way, per_square), last = drawn
    factor, from_point = length_of_way * per_square, minus(origin, point)
    apart, both = vector_square(from_point), dot(from_point, way)
    least_square = fused(fused(last, last, apart), of(CANCELLED), of(TINY))
    square = most(fused(fused(vector_square(way), factor, both + both), factor, apart), least_square)
    return point, added(from_point, way, factor), _factors(bone, square), bone


@inlined
def _factors(bone: Any, square: Any) -> Any:
    """Two numbers whose product is bone / √square; the division does not wait for the root."""
    return root(square), bone / square


@inlined
def turn_along(scratch: Any, count: int) -> Any:
    """Turns each joint, from the start on, so that its bone is parallel to that between the points at POINT;
    writes rotations; returns the end.
    """
    zero, one = broadcast(ZERO), broadcast(ONE)
    above, end = (zero, zero, zero, one), load3(scratch, OFFSET)
    for place in range(count - 1):
        at = place * JOINT
        q, offset = load4(scratch, at + LOCAL), load3(scratch, at + JOINT + OFFSET)
        way, bone = minus(load3(scratch, at + JOINT + POINT), load3(scratch, at + POINT)), rotated(q, offset)
        length_of_bone, square_of_way = load(scratch, at + JOINT + LENGTH), vector_square(way)
        square_of_bone = length_of_bone * length_of_bone
        apart, unlike = size(square_of_way - square_of_bone), square_of_bone * of(UNLIKE)
        if any_above(apart, unlike):
            factor = length_of_bone / root(most(square_of_way, of(TINY)))
            way = where3_below(unlike, apart, scaled(way, factor), way)
        turn, square = half_way(bone, rotated_back(above, way), square_of_bone)
        q, factor = mul(turn, renormalized(q)), per_root(square)
        q = q[0] * factor, q[1] * factor, q[2] * factor, q[3] * factor
        store4(scratch, at + LOCAL, q)
        above = mul(above, q)
        end = plus(end, way)
    return end


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
            way = rotated_back(above, minus(load3(scratch, at + JOINT + points), place_now))
            q = aimed(chains, clamps, first + place, rotated(q, offset), way, q, scratch, at)
            store4(scratch, at + LOCAL, q)
        above = mul(above, q)
        place_now = plus(place_now, rotated(above, offset))
        store3(scratch, at + JOINT + POINT, place_now)
    return place_now
