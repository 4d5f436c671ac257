"""Step 8 of the tick for hanging chains: they fall and swing between their anchors (SK4)."""

from __future__ import annotations

from typing import Any

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.scalar import sincos
from statwalk.maths.simd.pose_layout import end_row, first_row
from statwalk.solve.foot_points import on_stage
from statwalk.solve.hanging import OF_CHAIN, OF_JOINT
from statwalk.solve.hanging_lanes import hang_block
from statwalk.solve.reach_tables import WEIGHT, X_RATE, X


@called
def hang(
    h: Any, r: Any, chains: Any, clamps: Any, mem: Any, values: Any, position: Any, heading: Any,
    root_delta: Any, keep: Any, block: int, dt: float,
) -> None:  # fmt: skip
    """Turns the hanging chains of a block's actors in `values`; ends that nothing holds are where the solvers
    that take hold of them begin.
    """
    if h.chain.shape[0] == 0:
        return
    first, end = first_row(block), end_row(block, keep.shape[0])
    hang_block(
        h, r, chains, clamps, keep, root_delta, mem.coming, values, block, first, end, dt, mem.chain,
        mem.hanging,
    )  # fmt: skip
    for k in range(h.chain.shape[0]):
        for number in range(h.first_holder[k], h.first_holder[k + 1]):
            solver = h.holder[number]
            if r.travel[solver] >= 0.0:
                for row in range(first, end):
                    if keep[row, r.memory[solver] + WEIGHT] <= 0.0:
                        _begin_here(h, r, chains, keep, position, heading, k, solver, row)


@inlined
def _begin_here(
    h: Any, r: Any, chains: Any, keep: Any, position: Any, heading: Any, k: int, solver: int, row: int
) -> None:
    """Lets the end of a solver begin its way where the end of a hanging chain is, with its velocity."""
    number, to = h.chain[k], r.memory[solver]
    joints = chains.first[number + 1] - chains.first[number]
    at = h.memory[k] + OF_CHAIN + (joints - 1) * OF_JOINT
    place = keep[row, at], keep[row, at + 1], keep[row, at + 2]
    speed = keep[row, at + 3], keep[row, at + 4], keep[row, at + 5]
    if r.in_stage[solver]:
        sine, cosine = sincos(heading[row])
        root = position[row, 0], position[row, 1], position[row, 2], sine, cosine
        place = on_stage(place[0], place[1], place[2], root)
        speed = on_stage(speed[0], speed[1], speed[2], (0.0, 0.0, 0.0, sine, cosine))
    for axis in range(3):
        keep[row, to + X + axis], keep[row, to + X_RATE + axis] = place[axis], speed[axis]
