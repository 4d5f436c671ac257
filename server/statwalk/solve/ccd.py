"""Cyclic coordinate descent: from the end to the start, each joint turns the end towards the target (IK14,
IK15; Wang and Chen 1991).
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.simd.lane_elementary import of
from statwalk.maths.simd.lane_functions import any_above, most, root, where_below
from statwalk.maths.simd.lane_quat import minus, plus, rotated, rotated_back, scaled, vector_square
from statwalk.maths.simd.lane_vector import length, where3_below
from statwalk.maths.simd.lanes import broadcast, spread
from statwalk.maths.simd.pose_lanes import load3, load4, store3, store4
from statwalk.solve.chain_lanes import AIM, JOINT, LOCAL, OFFSET
from statwalk.solve.chains import TWO_BONE
from statwalk.solve.iterate import FAR, aimed, goes_on, is_free_joint, keep_better, note_cuts, take_best

ZERO, ONE = np.float32(0), np.float32(1)
SLOW = 0.97
"""a limb stops at the iteration that leaves more than this part of the distance: it begins at the best that
a triangle allows, and what its limits leave goes slowly"""


@called
def solve_ccd(
    chains: Any, clamps: Any, number: int, goal: Any, active: Any, best: Any, whole: Any, scratch: Any
) -> Any:
    """Turns the joints until the end is within the chain's tolerance of the goal; returns the iterations
    and the distance of the best pose.

    `active`: above 0 in lanes with work to do; `best`: the distance of the pose at BEST.
    """
    count = chains.first[number + 1] - chains.first[number]
    zero, one, tolerance = broadcast(ZERO), broadcast(ONE), spread(chains.tolerance, number)
    active = where_below(zero, active, where_below(tolerance, best, one, zero), zero)
    iterations, last = zero, of(FAR)
    for _ in range(chains.iterations[number]):
        if not any_above(active, zero):
            break
        distance = _sweep(chains, clamps, number, goal, scratch)
        if chains.solver[number] != TWO_BONE:  # a limb's cuts are those of the exact solution
            note_cuts(chains, number, active, scratch)
        iterations = iterations + active
        better = where_below(distance, best, active, zero)
        best = keep_better(scratch, count - 1, better, distance, best)
        if chains.solver[number] == TWO_BONE:
            active = where_below(distance, last * of(SLOW), active, zero)
        active, last = goes_on(active, distance, last, tolerance, whole), distance
    take_best(scratch, count - 1)
    return iterations, best


@inlined
def _sweep(chains: Any, clamps: Any, number: int, goal: Any, scratch: Any) -> Any:
    """Turns each joint once; returns the end's distance from the goal.

    A joint's turn moves the end, and no joint above it: the goal is brought into all frames first, the end is
    carried up from frame to frame afterwards. That costs one pass instead of one for each joint.
    """
    first, count = chains.first[number], chains.first[number + 1] - chains.first[number]
    seen = goal
    for place in range(count - 1):
        aim = minus(seen, load3(scratch, place * JOINT + OFFSET))
        store3(scratch, place * JOINT + AIM, aim)
        seen = rotated_back(load4(scratch, place * JOINT + LOCAL), aim)
    end = load3(scratch, (count - 1) * JOINT + OFFSET)
    for step in range(count - 1):
        place = count - 2 - step
        at, q = place * JOINT, load4(scratch, place * JOINT + LOCAL)
        bone = rotated(q, end)
        if chains.sensitivity[first + place] > ZERO:
            aim = load3(scratch, at + AIM)
            q = aimed(chains, clamps, first + place, bone, aim, q, scratch, at)
            store4(scratch, at + LOCAL, q)
            bone = _along(bone, aim) if is_free_joint(chains, clamps, first + place) else rotated(q, end)
        end = plus(load3(scratch, at + OFFSET), bone)
    return length(minus(goal, end))


@inlined
def _along(bone: Any, aim: Any) -> Any:
    """The bone turned towards `aim`, if that has a length."""
    square, tiny = vector_square(aim), of(1e-30)
    factor = root(vector_square(bone) * square) / most(square, tiny)
    return where3_below(tiny, square, scaled(aim, factor), bone)
