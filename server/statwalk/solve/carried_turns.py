"""The turns that a force has given to the joints of a chain, carried from tick to tick.

A force pulls the end a little in each tick, from where it has brought it before (RTCA 2.4). So the joints
move on, and never jump from one way of bending to another. A joint that the force does not need goes back to
its motion.

`keep` the solvers' memory; `scratch` the chain's memory (`chain_lanes`); `k` the solver.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.simd.lane_quat import conjugate, mul, normalized
from statwalk.maths.simd.lanes import LANES, broadcast
from statwalk.maths.simd.pose_lanes import ROTATION, joint_at, load4, store4
from statwalk.solve.chain_lanes import JOINT, LOCAL, TURNED
from statwalk.solve.iterate import limited
from statwalk.solve.reach_tables import OF_SOLVER

BACK = 1.5
"""1/s: how fast a joint goes back to its motion"""
ZERO, ONE = np.float32(0), np.float32(1)


@inlined
def forget_turns(r: Any, keep: Any, row: int, k: int) -> None:
    """Begins again at the motion."""
    first = r.memory[k] + OF_SOLVER
    for place in range(r.turned[k]):
        for part in range(4):
            keep[row, first + 4 * place + part] = 1.0 if part == 3 else 0.0


@called
def recall_turns(r: Any, keep: Any, scratch: Any, row: int, lane: int, k: int, dt: float) -> None:
    """Writes the carried turns of an actor, a little nearer to none, into its lane of the scratch."""
    first, part = r.memory[k] + OF_SOLVER, 1.0 / (1.0 + BACK * dt)
    for place in range(r.turned[k]):
        at = first + 4 * place
        x, y, z, w = (
            keep[row, at] * part,
            keep[row, at + 1] * part,
            keep[row, at + 2] * part,
            keep[row, at + 3],
        )
        size = 1.0 / math.sqrt(max(x * x + y * y + z * z + w * w, 1e-12))
        size = -size if w < 0.0 else size
        lanes = place * JOINT + TURNED + lane
        scratch[lanes], scratch[lanes + LANES] = x * size, y * size
        scratch[lanes + 2 * LANES], scratch[lanes + 3 * LANES] = z * size, w * size


@inlined
def no_turns(r: Any, scratch: Any, lane: int, k: int) -> None:
    """Writes no turns into a lane without an actor."""
    for place in range(r.turned[k]):
        for part in range(4):
            scratch[place * JOINT + TURNED + part * LANES + lane] = 1.0 if part == 3 else 0.0


@inlined
def keep_turns(r: Any, keep: Any, scratch: Any, row: int, lane: int, k: int, weight: float) -> None:
    """Keeps what the solver has left in an actor's lane, if it had a weight."""
    first = r.memory[k] + OF_SOLVER
    for place in range(r.turned[k] if weight > 0.0 else 0):
        for part in range(4):
            lanes = place * JOINT + TURNED + part * LANES + lane
            keep[row, first + 4 * place + part] = scratch[lanes]


@called
def add_turns(chains: Any, clamps: Any, number: int, scratch: Any) -> None:
    """Gives the joints of a chain their carried turns, within their limits."""
    first = chains.first[number]
    for place in range(chains.first[number + 1] - first - 1):
        if chains.sensitivity[first + place] > ZERO:
            at = place * JOINT
            q = normalized(mul(load4(scratch, at + LOCAL), load4(scratch, at + TURNED)))
            q = limited(chains, clamps, first + place, q, broadcast(ONE), scratch, at)
            store4(scratch, at + LOCAL, q)


@called
def take_turns(chains: Any, number: int, values: Any, block: int, scratch: Any) -> None:
    """Writes the turns from the pose to the solved rotations."""
    first = chains.first[number]
    for place in range(chains.first[number + 1] - first - 1):
        at, where = place * JOINT, joint_at(values, block, chains.joint[first + place])
        turn = mul(conjugate(load4(values, where + ROTATION)), load4(scratch, at + LOCAL))
        store4(scratch, at + TURNED, normalized(turn))
