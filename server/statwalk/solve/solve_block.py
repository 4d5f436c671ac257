"""Solves one chain for the sixteen actors of a block of poses: what step 8 of the tick calls.

solve_chain_block(chains, number, values, block, rows, at, scratch)

chains    a `Chains`
number    the chain
values    (B, C, 16) the values of a `PoseBuffer`; the chain's rotations are changed
block     the block in `values`
rows, at  an array, and the index in it of the chain's ROWS · 16 floats for this block: inputs, and outputs
          (`chains`)
scratch   at least `scratch_floats(joints of the chain)` float32
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.simd.lane_functions import any_above, either
from statwalk.maths.simd.lane_quat import conjugate, minus, mul
from statwalk.maths.simd.lane_turns import rotated
from statwalk.maths.simd.lane_vector import length
from statwalk.maths.simd.lanes import LANES, broadcast, load, spread, store
from statwalk.maths.simd.pose_lanes import joint_at, load3, load4, store4
from statwalk.solve.chain_lanes import (
    JOINT,
    LOCAL,
    OFFSET,
    TURN,
    base_frame,
    place_joints,
    read_chain,
    write_joint,
)
from statwalk.solve.chains import DISTANCE, ITERATIONS, POLE, POLE_POINT, ROTATION, TARGET, WEIGHT
from statwalk.solve.two_bone import solve_two_bone

ZERO = np.float32(0)


@called
def solve_chain_block(
    chains: Any, number: int, values: Any, block: int, rows: Any, at: int, scratch: Any
) -> None:
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
        iterations = _solve(chains, number, rows, at, position, to_base, target, scratch)
        end = _write(
            chains, number, values, block, mul(to_base, load4(rows, at + ROTATION * LANES)), weight, scratch
        )
        distance = length(minus(target, end))
    store(rows, at + DISTANCE * LANES, either(weight, distance, zero))
    store(rows, at + ITERATIONS * LANES, either(weight, iterations, zero))


@inlined
def _solve(
    chains: Any, number: int, rows: Any, at: int, position: Any, to_base: Any, target: Any, scratch: Any
) -> Any:
    """Runs the chain's solver, and returns its iterations."""
    count = chains.first[number + 1] - chains.first[number]
    softening, middle = spread(chains.softening, number), chains.middle[number]
    pole = load3(rows, at + POLE * LANES)
    if chains.pole_kind[number] == POLE_POINT:
        pole = minus(rotated(to_base, minus(pole, position)), load3(scratch, OFFSET))
    else:
        pole = rotated(to_base, pole)
    solve_two_bone(scratch, count, middle, target, pole, softening)
    return broadcast(ZERO)


@inlined
def _write(
    chains: Any, number: int, values: Any, block: int, rotation: Any, weight: Any, scratch: Any
) -> Any:
    """Writes the rotations into the pose; returns the place of the chain's end."""
    first, count = chains.first[number], chains.first[number + 1] - chains.first[number]
    for place in range(count - 1):
        if chains.sensitivity[first + place] > ZERO:
            where = joint_at(values, block, chains.joint[first + place])
            solved = write_joint(values, where, load4(scratch, place * JOINT + LOCAL), weight)
            store4(scratch, place * JOINT + LOCAL, solved)
    end = place_joints(scratch, count, LOCAL)
    if chains.turns_end[number]:
        where = joint_at(values, block, chains.joint[first + count - 1])
        above = conjugate(load4(scratch, (count - 1) * JOINT + TURN))
        write_joint(values, where, mul(above, rotation), weight)
    return end
