"""What the solvers by iteration have in common: where they begin, and the best pose so far."""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.simd.clamp_lanes import clamp_rotation
from statwalk.maths.simd.lane_elementary import of
from statwalk.maths.simd.lane_functions import any_above, either, root, size, where_below
from statwalk.maths.simd.lane_quat import (
    minus,
    mul,
    renormalized,
    rotated,
    rotated_back,
    slerp,
    vector_square,
)
from statwalk.maths.simd.lane_turns import between, half_way
from statwalk.maths.simd.lane_vector import cross, length, per_root, perpendicular, unit, where3_below
from statwalk.maths.simd.lanes import broadcast, load, spread, store
from statwalk.maths.simd.pose_lanes import either4, load3, load4, store4
from statwalk.solve.chain_lanes import BEST, CUT, JOINT, LOCAL, NOTED, OFFSET, POINT, TURN, place_joints
from statwalk.solve.chains import FORCE, TWO_BONE

ZERO, ONE = np.float32(0), np.float32(1)
KICK = 0.1
"""radians by which the joints of a chain bend that is in line with its target"""
IN_LINE = 1e-6
"""the square of a chain's width, as a part of that of its length, below which it counts as in line with its
target"""
NO_PROGRESS = 1e-6
"""metres, as a part of the chain's length: an iteration that changes the distance by less is the last"""
FAR = 1e30


@inlined
def limited(chains: Any, clamps: Any, row: int, q: Any, per_length: Any, scratch: Any, at: int) -> Any:
    """Returns the local rotation q of the joint of a row, whose memory is at `at`, clamped to the joint's
    limits, at unit length; writes by how much to CUT, if somebody reads it. q may have any length,
    `per_length` is 1 / that.
    """
    limit = clamps.row[chains.joint[row]]
    inside = q[0] * per_length, q[1] * per_length, q[2] * per_length, q[3] * per_length
    if limit >= 0:
        q, inside = inside, clamp_rotation(clamps, limit, q, per_length)
        if chains.note[row] >= 0:
            x, y, z, w = inside[0] - q[0], inside[1] - q[1], inside[2] - q[2], inside[3] - q[3]
            apart = x * x + y * y + z * z + w * w  # twice 1 − cosine of half the angle
            store(scratch, at + CUT, apart * (broadcast(ONE) - of(0.25) * apart))
    return inside


@inlined
def is_free_joint(chains: Any, clamps: Any, row: int) -> Any:
    """Returns whether the joint of a row makes every turn that a solver wants."""
    return clamps.row[chains.joint[row]] < 0 and chains.sensitivity[row] >= ONE


@inlined
def note_cuts(chains: Any, number: int, counts: Any, scratch: Any) -> None:
    """Keeps what limits cut in this iteration, in lanes with `counts` above 0."""
    first = chains.first[number]
    for place in range(chains.first[number + 1] - first):
        if chains.note[first + place] >= 0:
            at = place * JOINT
            store(scratch, at + NOTED, either(counts, load(scratch, at + CUT), load(scratch, at + NOTED)))


@inlined
def turned_by(chains: Any, clamps: Any, row: int, turn: Any, q: Any, scratch: Any, at: int) -> Any:
    """Returns a joint's rotation q after a turn in its parent's frame: as much of it as its sensitivity says,
    within its limits.
    """
    if chains.sensitivity[row] < ONE:
        zero, one = broadcast(ZERO), broadcast(ONE)
        turn = slerp((zero, zero, zero, one), turn, spread(chains.sensitivity, row))
    return limited(chains, clamps, row, renormalized(mul(turn, q)), broadcast(ONE), scratch, at)


@inlined
def aimed(chains: Any, clamps: Any, row: int, bone: Any, aim: Any, q: Any, scratch: Any, at: int) -> Any:
    """Returns a joint's rotation q after the turn in its parent's frame that brings the vector `bone` to the
    direction of `aim`: as much of it as its sensitivity says, within its limits.
    """
    if not is_free_joint(chains, clamps, row):
        return _aimed_within(chains, clamps, row, bone, aim, q, scratch, at)
    turn, square = half_way(bone, aim, root(vector_square(bone) * vector_square(aim)))
    q, factor = mul(turn, renormalized(q)), per_root(square)  # q is known before the turn: nothing waits
    return q[0] * factor, q[1] * factor, q[2] * factor, q[3] * factor


@called
def _aimed_within(
    chains: Any, clamps: Any, row: int, bone: Any, aim: Any, q: Any, scratch: Any, at: int
) -> Any:
    if chains.sensitivity[row] < ONE:
        return turned_by(chains, clamps, row, between(bone, aim), q, scratch, at)
    turn, square = half_way(bone, aim, root(vector_square(bone) * vector_square(aim)))
    q = mul(turn, renormalized(q))  # q is known before the turn: nothing waits
    return limited(chains, clamps, row, q, per_root(square), scratch, at)


@called
def begin(chains: Any, clamps: Any, number: int, goal: Any, pole: Any, whole: Any, scratch: Any) -> Any:
    """Prepares the rotations at LOCAL for iterations: stretches chains towards targets out of reach (the
    force solver lets them travel there), and bends chains in line with a target within reach; returns the
    distance of the best pose, which is at BEST. The places at POINT are those of the rotations at LOCAL.
    """
    first, count = chains.first[number], chains.first[number + 1] - chains.first[number]
    one, zero = broadcast(ONE), broadcast(ZERO)
    end = place_joints(scratch, count, LOCAL)
    distance = length(minus(goal, end))
    _copy(scratch, count, LOCAL, BEST)
    far = length(minus(goal, load3(scratch, POINT)))
    reach = whole * of(1 - 1e-6)
    if chains.solver[number] != FORCE and any_above(far, reach):
        is_far = where_below(reach, far, one, zero)
        _stretch(chains, clamps, number, goal, is_far, scratch)
        if chains.solver[number] != TWO_BONE:
            note_cuts(chains, number, is_far, scratch)
        stretched = length(minus(goal, place_joints(scratch, count, LOCAL)))
        better = where_below(stretched, distance, one, zero)
        distance = keep_better(scratch, count - 1, better, stretched, distance)
    in_line = _in_line(goal, whole, count, scratch)
    if any_above(in_line, zero):
        _bend(chains, clamps, first, count, goal, pole, in_line, scratch)
        place_joints(scratch, count, LOCAL)
    return distance


@inlined
def keep_better(scratch: Any, count: int, better: Any, distance: Any, best: Any) -> Any:
    """Keeps the rotations of the joints as the best in lanes with `better` above 0; returns the distance of
    the best.
    """
    for place in range(count):
        at = place * JOINT
        store4(scratch, at + BEST, either4(better, load4(scratch, at + LOCAL), load4(scratch, at + BEST)))
    return either(better, distance, best)


@inlined
def take_best(scratch: Any, count: int) -> None:
    """Puts the best rotations in the place of the last."""
    _copy(scratch, count, BEST, LOCAL)


@inlined
def take_better(scratch: Any, count: int, better: Any) -> None:
    """Puts the best rotations in the place of the last in lanes with `better` 0."""
    for place in range(count):
        at = place * JOINT
        store4(scratch, at + LOCAL, either4(better, load4(scratch, at + LOCAL), load4(scratch, at + BEST)))


@inlined
def goes_on(active: Any, distance: Any, last: Any, tolerance: Any, whole: Any) -> Any:
    """Returns `active` in lanes that are neither at the target nor without progress since the `last`
    distance, else 0.
    """
    zero = broadcast(ZERO)
    active = where_below(tolerance, distance, active, zero)
    return where_below(whole * of(NO_PROGRESS), size(distance - last), active, zero)


@inlined
def _copy(scratch: Any, count: int, source: int, target: int) -> None:
    for place in range(count):
        store4(scratch, place * JOINT + target, load4(scratch, place * JOINT + source))


@inlined
def _stretch(chains: Any, clamps: Any, number: int, goal: Any, mask: Any, scratch: Any) -> None:
    """Points each bone at the target, from the start on, in lanes with a mask above 0."""
    first, count = chains.first[number], chains.first[number + 1] - chains.first[number]
    for place in range(count - 1):
        at = place * JOINT
        q = load4(scratch, at + LOCAL)
        aim = minus(goal, load3(scratch, at + OFFSET))
        if chains.sensitivity[first + place] > ZERO:
            bone = rotated(q, load3(scratch, at + JOINT + OFFSET))
            q = either4(mask, aimed(chains, clamps, first + place, bone, aim, q, scratch, at), q)
            store4(scratch, at + LOCAL, q)
        goal = rotated_back(q, aim)


@inlined
def _in_line(goal: Any, whole: Any, count: int, scratch: Any) -> Any:
    """1 in lanes whose joints are all on the line from the start to a target within reach: no solver would
    know where to bend them.
    """
    zero, one, start = broadcast(ZERO), broadcast(ONE), load3(scratch, POINT)
    aim = minus(goal, start)
    square, nothing, width = vector_square(aim), of(IN_LINE) * whole * whole, zero
    end = minus(load3(scratch, (count - 1) * JOINT + POINT), start)
    line = where3_below(square, nothing, end, aim)
    limit = nothing * vector_square(line)
    for place in range(1, count):
        width = width + vector_square(cross(minus(load3(scratch, place * JOINT + POINT), start), line))
        if not any_above(limit, width):
            break
    in_line = where_below(width, limit, one, zero)
    reach = whole * of(1 - 1e-4)
    return where_below(square, reach * reach, in_line, zero)


@inlined
def _bend(
    chains: Any, clamps: Any, first: int, count: int, goal: Any, pole: Any, mask: Any, scratch: Any
) -> None:
    """Bends the chain a little, towards the pole if it has one, in lanes with a mask above 0."""
    aim, end = minus(goal, load3(scratch, POINT)), load3(scratch, (count - 1) * JOINT + POINT)
    aim = where3_below(vector_square(aim), of(1e-12), minus(end, load3(scratch, POINT)), aim)
    across = cross(aim, pole)
    nothing = vector_square(aim) * vector_square(pole) * of(1e-6)
    across = unit(where3_below(nothing, vector_square(across), across, perpendicular(aim)))
    for place in range(count - 1):
        at = place * JOINT
        if chains.sensitivity[first + place] > ZERO:
            half = of(0.5 * KICK) if place == 0 else of(-KICK)
            axis = rotated_back(load4(scratch, at + TURN), across)
            turn = axis[0] * half, axis[1] * half, axis[2] * half, broadcast(ONE)
            q = load4(scratch, at + LOCAL)
            bent = turned_by(chains, clamps, first + place, renormalized(turn), q, scratch, at)
            store4(scratch, at + LOCAL, either4(mask, bent, q))
