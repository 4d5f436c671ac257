"""Look-at: the joints of a neck turn the last one, whose line of sight then meets the target (IK15)."""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.simd.lane_elementary import of
from statwalk.maths.simd.lane_functions import any_above, where_below
from statwalk.maths.simd.lane_quat import conjugate, minus, mul, rotated, slerp
from statwalk.maths.simd.lane_turns import between
from statwalk.maths.simd.lane_vector import cross, dot, length
from statwalk.maths.simd.lanes import broadcast, spread
from statwalk.maths.simd.pose_lanes import load4, store4
from statwalk.solve.chain_lanes import JOINT, LOCAL, TURN, place_joints
from statwalk.solve.iterate import keep_better, note_cuts, take_best, turned_by

ZERO, ONE = np.float32(0), np.float32(1)


@called
def solve_look_at(chains: Any, clamps: Any, number: int, goal: Any, active: Any, scratch: Any) -> Any:
    """Turns all joints of the chain, each a part of what is left; returns the iterations.

    The last joint turns by all that is left, as far as sensitivities and limits allow. The eye is the last
    joint: what moves it while it turns is corrected in the next iteration.
    """
    first, count = chains.first[number], chains.first[number + 1] - chains.first[number]
    zero, one, tolerance = broadcast(ZERO), broadcast(ONE), spread(chains.tolerance, number)
    best = missed(chains, number, goal, scratch)
    active = where_below(zero, active, where_below(tolerance, best, one, zero), zero)
    keep_better(scratch, count, one, best, best)
    iterations = zero
    for _ in range(chains.iterations[number]):
        if not any_above(active, zero):
            break
        for place in range(count):
            if chains.sensitivity[first + place] > ZERO:
                _turn_joint(chains, clamps, number, place, goal, scratch)
        note_cuts(chains, number, active, scratch)
        distance = missed(chains, number, goal, scratch)
        iterations = iterations + active
        better = where_below(distance, best, active, zero)
        best = keep_better(scratch, count, better, distance, best)
        active = where_below(tolerance, best, active, zero)
    take_best(scratch, count)
    return iterations


@inlined
def missed(chains: Any, number: int, goal: Any, scratch: Any) -> Any:
    """Returns how far the line of sight passes the goal, metres; the eye's distance from a goal behind it."""
    count = chains.first[number + 1] - chains.first[number]
    way = minus(goal, place_joints(scratch, count, LOCAL))
    sight = _sight(chains, number, count, scratch)
    return where_below(broadcast(ZERO), dot(way, sight), length(cross(way, sight)), length(way))


@inlined
def _sight(chains: Any, number: int, count: int, scratch: Any) -> Any:
    """The unit vector of the line of sight in the chain's frame."""
    at = (count - 1) * JOINT
    forward = (
        spread(chains.forward, 3 * number),
        spread(chains.forward, 3 * number + 1),
        spread(chains.forward, 3 * number + 2),
    )
    return rotated(mul(load4(scratch, at + TURN), load4(scratch, at + LOCAL)), forward)


@inlined
def _turn_joint(chains: Any, clamps: Any, number: int, place: int, goal: Any, scratch: Any) -> None:
    """Turns one joint by its share: what is left, divided by the joints left."""
    first, count = chains.first[number], chains.first[number + 1] - chains.first[number]
    eye, at = place_joints(scratch, count, LOCAL), place * JOINT
    zero, one = broadcast(ZERO), broadcast(ONE)
    turn = between(_sight(chains, number, count, scratch), minus(goal, eye))
    turn = slerp((zero, zero, zero, one), turn, of(1 / (count - place)))
    above = load4(scratch, at + TURN)
    turn = mul(mul(conjugate(above), turn), above)
    turned = turned_by(chains, clamps, first + place, turn, load4(scratch, at + LOCAL), scratch, at)
    store4(scratch, at + LOCAL, turned)
