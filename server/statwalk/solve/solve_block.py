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
from statwalk.maths.reference import called
from statwalk.maths.simd.lane_functions import any_above, either
from statwalk.maths.simd.lane_quat import conjugate, minus, mul, plus, rotated
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
from statwalk.solve.two_bone import clamp_limb, solve_two_bone

ZERO = np.float32(0)


@called
def solve_chain_block(
    chains: Any, clamps: Any, number: int, values: Any, block: int, rows: Any, at: int, scratch: Any,
    keep: Any,
) -> None:  # fmt: skip
    """Turns the joints of one chain of a block's actors, and writes its output rows; an actor of weight 0
    keeps its bits.
    """
    weight, zero = load(rows, at + WEIGHT * LANES), broadcast(ZERO)
    distance, iterations = zero, zero
    if any_above(weight, zero):
        position, rotation, scale = base_frame(chains, number, values, block)
        read_chain(chains, number, values, block, scale, scratch)
        to_base = conjugate(rotation)
        target = rotated(to_base, minus(load3(rows, at + TARGET * LANES), position))
        pole = rotated(to_base, load3(rows, at + POLE * LANES))
        start = load3(scratch, OFFSET)
        end = start
        if chains.pole_kind[number] == POLE_POINT:
            base = rotated(to_base, position)
            pole = minus(pole, plus(base, target if chains.is_moored[number] else start))
        if chains.is_moored[number]:  # the end stays: as seen from the start, it goes the other way
            end = end_of(scratch, _count(chains, number))
            target = minus(plus(start, end), target)
        if chains.is_carried[number]:
            add_turns(chains, clamps, number, scratch)
        iterations = _solve(chains, clamps, number, target, pole, weight, scratch)
        if chains.is_carried[number]:
            take_turns(chains, number, values, block, scratch)
        end_rotation = mul(to_base, load4(rows, at + ROTATION * LANES))
        distance = _write(chains, clamps, number, values, block, target, end_rotation, weight, scratch)
        if chains.is_moored[number]:
            away = minus(end, end_of(scratch, _count(chains, number)))
            _move_top(chains, number, values, block, rotated(rotation, away), weight)
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
    first = chains.first[number]
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
    """Runs the chain's solver, which leaves its rotations at LOCAL; returns its iterations."""
    solver, count = chains.solver[number], chains.first[number + 1] - chains.first[number]
    if solver == LOOK_AT:
        return solve_look_at(chains, clamps, number, target, weight, scratch)
    softening = spread(chains.softening, number)
    if solver == TWO_BONE:
        middle = chains.middle[number]
        at = 3 * number
        hinge = spread(chains.hinge, at), spread(chains.hinge, at + 1), spread(chains.hinge, at + 2)
        target = solve_two_bone(scratch, count, middle, target, pole, hinge, softening)
        if chains.is_free[number]:
            return broadcast(ZERO)
        clamp_limb(chains, clamps, number, middle, scratch)
    whole = chain_length(scratch, count)
    if solver != TWO_BONE:
        target = softened(target, load3(scratch, OFFSET), whole, softening)
    best = begin(chains, clamps, number, target, pole, whole, scratch)
    if solver == FABRIK:
        return solve_fabrik(chains, clamps, number, target, weight, best, whole, scratch)
    if solver == FORCE:
        return solve_force(chains, clamps, number, target, weight, best, whole, scratch)
    return solve_ccd(chains, clamps, number, target, weight, best, whole, scratch)


@inlined
def _write(
    chains: Any, clamps: Any, number: int, values: Any, block: int, target: Any, end_rotation: Any,
    weight: Any, scratch: Any,
) -> Any:  # fmt: skip
    """Writes the rotations into the pose; returns the distance from the target."""
    first, count = chains.first[number], chains.first[number + 1] - chains.first[number]
    is_look_at = chains.solver[number] == LOOK_AT
    for place in range(count if is_look_at else count - 1):
        if chains.sensitivity[first + place] > ZERO:
            where = joint_at(values, block, chains.joint[first + place])
            solved = write_joint(values, where, load4(scratch, place * JOINT + LOCAL), weight)
            store4(scratch, place * JOINT + LOCAL, solved)
    if is_look_at:
        return missed(chains, number, target, scratch)
    if chains.turns_end[number]:
        place_joints(scratch, count, LOCAL)
        where = joint_at(values, block, chains.joint[first + count - 1])
        above = conjugate(load4(scratch, (count - 1) * JOINT + TURN))
        last = (count - 1) * JOINT
        turned = limited(chains, clamps, first + count - 1, mul(above, end_rotation), scratch, last)
        write_joint(values, where, turned, weight)
        store(scratch, last + NOTED, load(scratch, last + CUT))
    return length(minus(target, end_of(scratch, count)))
