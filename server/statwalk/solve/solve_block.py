"""Solves one chain for the sixteen actors of a block of poses: what step 8 of the tick calls.

solve_chain_block(chains, clamps, number, values, block, rows, at, scratch, keep)

chains    a `Chains`
number    the chain
values    (B, C, 16) the values of a `PoseBuffer`; the chain's rotations are changed
block     the block in `values`
rows, at  an array, and the index in it of the chain's ROWS · 16 floats for this block: inputs, and outputs
          (`chains`)
scratch   at least `scratch_floats(joints of the chain)` float32
keep      (N, K) float64, a row for each actor: the columns `chains.note` get by how much limits cut the last
          turns of joints (the square of the sine of half the angle)
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import inlined
from statwalk.maths.simd.lane_bits import natural
from statwalk.maths.simd.lane_functions import any_above, either, where_below
from statwalk.maths.simd.lane_quat import conjugate, minus, mul, plus, rotated, rotated_back
from statwalk.maths.simd.lane_vector import length
from statwalk.maths.simd.lanes import LANES, broadcast, load, spread, store
from statwalk.maths.simd.pose_lanes import either3, joint_at, load3, load4, store3, store4
from statwalk.maths.simd.pose_layout import end_row, first_row
from statwalk.solve.carried_turns import add_turns, take_turns
from statwalk.solve.ccd import solve_ccd
from statwalk.solve.chain_lanes import (
    CUT,
    JOINT,
    LOCAL,
    NOTED,
    OFFSET,
    TURN,
    base_frame,
    chain_length,
    end_of,
    place_joints,
    read_chain,
    softened,
    write_joint,
)
from statwalk.solve.chains import (
    DISTANCE,
    FABRIK,
    FORCE,
    ITERATIONS,
    LOOK_AT,
    POLE,
    POLE_POINT,
    ROTATION,
    TARGET,
    TWO_BONE,
    WEIGHT,
)
from statwalk.solve.fabrik import solve_fabrik
from statwalk.solve.force import solve_force
from statwalk.solve.iterate import begin, limited
from statwalk.solve.look_at import missed, solve_look_at
from statwalk.solve.swivel import swivel_limb
from statwalk.solve.two_bone import clamp_limb, solve_two_bone

ZERO, ONE, UNKNOWN = np.float32(0), np.float32(1), np.float32(-1)


@inlined
def solve_chain_block(
    chains: Any, clamps: Any, number: int, values: Any, block: int, rows: Any, at: int, scratch: Any,
    keep: Any,
) -> None:  # fmt: skip
    """Turns the joints of one chain of a block's actors, and writes its output rows; an actor of weight 0
    keeps its bits.
    """
    number, block = natural(number), natural(block)
    weight, zero = load(rows, at + WEIGHT * LANES), broadcast(ZERO)
    distance, iterations = zero, zero
    if any_above(weight, zero):
        position, rotation, scale = base_frame(chains, number, values, block)
        read_chain(chains, number, values, block, scale, scratch)
        target = rotated_back(rotation, minus(load3(rows, at + TARGET * LANES), position))
        pole = rotated_back(rotation, load3(rows, at + POLE * LANES))
        start = load3(scratch, OFFSET)
        end = start
        if chains.pole_kind[number] == POLE_POINT:
            base = rotated_back(rotation, position)
            pole = minus(pole, plus(base, target if chains.is_moored[number] else start))
        if chains.is_moored[number]:  # the end stays: as seen from the start, it goes the other way
            end = end_of(scratch, _count(chains, number))
            target = minus(plus(start, end), target)
        if chains.is_carried[number]:
            add_turns(chains, clamps, number, scratch)
        iterations, known = _solve(chains, clamps, number, target, pole, weight, scratch)
        if chains.is_carried[number]:
            take_turns(chains, number, values, block, scratch)
        _write(chains, number, values, block, weight, scratch)
        if chains.turns_end[number]:
            end_rotation = mul(conjugate(rotation), load4(rows, at + ROTATION * LANES))
            _turn_end(chains, clamps, number, values, block, end_rotation, weight, scratch)
        distance = _distance(chains, number, target, known, weight, scratch)
        if chains.is_moored[number]:
            away = minus(end, end_of(scratch, _count(chains, number)))
            _move_top(chains, number, values, block, rotated(rotation, away), weight)
        if chains.is_noted[number]:
            keep_notes(chains, number, block, weight, scratch, keep)
    store(rows, at + DISTANCE * LANES, either(weight, distance, zero))
    store(rows, at + ITERATIONS * LANES, either(weight, iterations, zero))


@inlined
def _count(chains: Any, number: int) -> Any:
    return chains.first[number + 1] - chains.first[number]


@inlined
def _move_top(chains: Any, number: int, values: Any, block: int, way: Any, weight: Any) -> None:
    """Moves the joint above all of the chain, in lanes with a weight above 0."""
    at = joint_at(values, block, chains.top[number])
    before = load3(values, at)
    store3(values, at, either3(weight, plus(before, way), before))


@inlined
def keep_notes(chains: Any, number: int, block: int, weight: Any, scratch: Any, keep: Any) -> None:
    """Writes what the limits cut in the lanes of actors with a weight above 0."""
    first = natural(chains.first[number])
    for place in range(_count(chains, number)):
        column, at = chains.note[first + place], place * JOINT + NOTED
        if column >= 0:
            store(scratch, at, either(weight, load(scratch, at), broadcast(ZERO)))
            for row in range(first_row(block), end_row(block, keep.shape[0])):
                keep[row, column] = max(keep[row, column], scratch[at + row - first_row(block)])


@inlined
def forget_notes(chains: Any, keep: Any, block: int) -> None:
    """Clears what the limits cut in the tick before."""
    for k in range(chains.note.shape[0]):
        if chains.note[k] >= 0:
            for row in range(first_row(block), end_row(block, keep.shape[0])):
                keep[row, chains.note[k]] = 0.0


@inlined
def _solve(chains: Any, clamps: Any, number: int, target: Any, pole: Any, weight: Any, scratch: Any) -> Any:
    """Runs the chain's solver, which leaves its rotations at LOCAL; returns its iterations, and how far the
    end is from the target, below 0 where that has to be measured.
    """
    solver, count = chains.solver[number], _count(chains, number)
    zero, unknown = broadcast(ZERO), broadcast(UNKNOWN)
    if solver == LOOK_AT:
        return solve_look_at(chains, clamps, number, target, weight, scratch), unknown
    softening = spread(chains.softening, number)
    if solver == TWO_BONE:
        middle = chains.middle[number]
        at = 3 * number
        hinge = spread(chains.hinge, at), spread(chains.hinge, at + 1), spread(chains.hinge, at + 2)
        target, distance, circle = solve_two_bone(scratch, count, middle, target, pole, hinge, softening)
        if chains.is_free[number]:
            return zero, distance
        wanted = clamp_limb(chains, clamps, number, middle, scratch)
        swivel_limb(chains, clamps, number, circle, wanted, scratch)
    whole = chain_length(scratch, count)
    if solver != TWO_BONE:
        target = softened(target, load3(scratch, OFFSET), whole, softening)
    best = begin(chains, clamps, number, target, pole, whole, scratch)
    if solver == FORCE:
        return solve_force(chains, clamps, number, target, weight, best, whole, scratch), unknown
    if solver == FABRIK:
        iterations, best = solve_fabrik(chains, clamps, number, target, weight, best, whole, scratch)
    else:
        iterations, best = solve_ccd(chains, clamps, number, target, weight, best, whole, scratch)
    return iterations, where_below(zero, softening, unknown, best)


@inlined
def _write(chains: Any, number: int, values: Any, block: int, weight: Any, scratch: Any) -> None:
    """Writes the rotations into the pose; where a weight is below 1, also to LOCAL."""
    is_partial = any_above(broadcast(ONE), weight)
    first, turned = natural(chains.first[number]), _count(chains, number)
    for place in range(turned if chains.solver[number] == LOOK_AT else turned - 1):
        if chains.sensitivity[first + place] > ZERO:
            where = joint_at(values, block, chains.joint[first + place])
            solved = write_joint(values, where, load4(scratch, place * JOINT + LOCAL), weight)
            if is_partial:
                store4(scratch, place * JOINT + LOCAL, solved)


@inlined
def _turn_end(
    chains: Any, clamps: Any, number: int, values: Any, block: int, end_rotation: Any, weight: Any,
    scratch: Any,
) -> None:  # fmt: skip
    """Gives the end a rotation in the chain's frame, within its limits."""
    row, last = chains.first[number + 1] - 1, (_count(chains, number) - 1) * JOINT
    place_joints(scratch, _count(chains, number), LOCAL)
    turned = mul(conjugate(load4(scratch, last + TURN)), end_rotation)
    turned = limited(chains, clamps, row, turned, broadcast(ONE), scratch, last)
    write_joint(values, joint_at(values, block, chains.joint[row]), turned, weight)
    if chains.is_noted[number]:
        store(scratch, last + NOTED, load(scratch, last + CUT))


@inlined
def _distance(chains: Any, number: int, target: Any, known: Any, weight: Any, scratch: Any) -> Any:
    """The distance of the end from the target: what the solver knows, if that is all written."""
    if chains.solver[number] == LOOK_AT:
        return missed(chains, number, target, scratch)
    zero = broadcast(ZERO)
    unwritten = either(weight, broadcast(ONE) - weight, zero)
    if any_above(unwritten, zero) or any_above(zero, known):
        measured = length(minus(target, end_of(scratch, _count(chains, number))))
        known = where_below(known, zero, measured, where_below(zero, unwritten, measured, known))
    return known
