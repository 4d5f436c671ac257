"""Step 8 of the tick for the solvers of a machine file: their chains reach for their targets.

The pose offset of a transition is taken from the shown pose: what a solver had added is in the offset, and
dies out with it. Until then a solver adds what is missing to its weight, so the pose does not jump.
"""

from __future__ import annotations

from typing import Any

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.scalar import sincos
from statwalk.maths.simd.lanes import LANES
from statwalk.maths.simd.pose_layout import end_row, first_row, place_of
from statwalk.maths.springs import settled
from statwalk.rig.hierarchy import model_block
from statwalk.solve.carried_turns import forget_turns, keep_turns, no_turns, recall_turns
from statwalk.solve.chains import DISTANCE as SOLVED_DISTANCE
from statwalk.solve.chains import ROWS
from statwalk.solve.chains import WEIGHT as INPUT_WEIGHT
from statwalk.solve.reach_tables import CARRIED, DISTANCE, LAYER, SHOWN, SINCE, WEIGHT, WEIGHT_RATE
from statwalk.solve.reach_targets import distance_left, write_inputs
from statwalk.solve.solve_block import solve_chain_block
from statwalk.stage.steps.offset_clocks import remaining

ARRIVED, SLOW = 1e-4, 1e-3
"""a weight by state this near to its goal, and slower than this per second, has arrived"""


@called
def reach(
    r: Any, chains: Any, clamps: Any, s: Any, o: Any, mem: Any, values: Any, position: Any, heading: Any,
    keep: Any, block: int, dt: float,
) -> None:  # fmt: skip
    """Turns the chains of a block's actors in `values` towards their targets, one solver after the other."""
    first, end = first_row(block), end_row(block, s.state.shape[0])
    if r.joints.shape[0] > 0:
        model_block(r.joints, r.parents, values, mem.reach_joints, block)
    for k in range(r.memory.shape[0]):
        rows, number = mem.reach_rows[k], r.first_chain[0] + k
        if k > 0 and chains.is_moored[number] and r.travel[k] >= 0.0:
            model_block(r.joints, r.parents, values, mem.reach_joints, block)  # where its anchor is now
        for lane in range(LANES):
            rows[INPUT_WEIGHT, lane] = 0.0
            if lane >= end - first:
                no_turns(r, mem.chain, lane, k)
        for row in range(first, end):
            _aim(r, chains, s, o, mem, values, position, heading, keep, rows, row, k, dt)
        at = k * ROWS * LANES
        solve_chain_block(chains, clamps, number, values, block, mem.reach_rows, at, mem.chain, keep)
        for row in range(first, end):
            keep[row, r.memory[k] + DISTANCE] = rows[SOLVED_DISTANCE, row - first]
            keep_turns(r, keep, mem.chain, row, row - first, k, rows[INPUT_WEIGHT, row - first])


@inlined
def _aim(
    r: Any, chains: Any, s: Any, o: Any, mem: Any, values: Any, position: Any, heading: Any, keep: Any,
    rows: Any, row: int, k: int, dt: float,
) -> None:  # fmt: skip
    """Writes the inputs of a solver's chain for one actor."""
    weight, (_, lane) = _weight(r, s, values, keep, row, k, dt), place_of(row)
    root = _root(position, heading, row)
    write_inputs(r, chains, s.smoothed, mem.reach_joints, keep, rows, row, k, root, weight, dt)
    rows[INPUT_WEIGHT, lane] = _missing(r, o, mem, keep, row, k, weight)
    if weight <= 0.0:
        forget_turns(r, keep, row, k)
    recall_turns(r, keep, mem.chain, row, lane, k, dt)


@called
def measure_reached(
    r: Any, chains: Any, s: Any, mem: Any, values: Any, position: Any, heading: Any, keep: Any, block: int
) -> None:
    """Writes the distances that are left, where they are measured at last."""
    first, end = first_row(block), end_row(block, s.state.shape[0])
    if r.joints.shape[0] > 0:
        model_block(r.joints, r.parents, values, mem.reach_joints, block)
        for k in range(r.memory.shape[0]):
            for row in range(first, end):
                if r.is_measured[k] and keep[row, r.memory[k] + SHOWN] > 0.0:
                    root = _root(position, heading, row)
                    distance = distance_left(r, chains, s.smoothed, mem.reach_joints, row, k, root)
                    keep[row, r.memory[k] + DISTANCE] = distance


@inlined
def _root(position: Any, heading: Any, row: int) -> Any:
    """x, y, z of an actor, sine and cosine of its heading."""
    sine, cosine = sincos(heading[row])
    return position[row, 0], position[row, 1], position[row, 2], sine, cosine


@inlined
def _weight(r: Any, s: Any, values: Any, keep: Any, row: int, k: int, dt: float) -> Any:
    """The weight of a solver in this tick; by state: eased."""
    at = r.memory[k]
    goal = min(max(_wanted(r, s, values, row, k), 0.0), 1.0)
    weight, rate = goal, 0.0
    if keep[row, at + SINCE] > 0.0 and r.eagerness[k] > 0.0:
        left, rate = settled(keep[row, at + WEIGHT] - goal, keep[row, at + WEIGHT_RATE], r.eagerness[k], dt)
        weight = goal + left
        if abs(left) < ARRIVED and abs(rate) < SLOW:
            weight, rate = goal, 0.0
    keep[row, at + SINCE] = 1.0
    keep[row, at + WEIGHT], keep[row, at + WEIGHT_RATE] = weight, rate
    return min(max(weight, 0.0), 1.0)


@inlined
def _wanted(r: Any, s: Any, values: Any, row: int, k: int) -> Any:
    """The weight that the file asks for: a parameter, a channel of the pose, or a number."""
    state = s.state[row, 0]
    parameter, channel = r.weight_parameter[k, state], r.weight_channel[k, state]
    if parameter >= 0:
        return s.smoothed[row, parameter]
    if channel >= 0:
        block, lane = place_of(row)
        return float(values[block, channel, lane])
    return r.weight[k, state]


@inlined
def _missing(r: Any, o: Any, mem: Any, keep: Any, row: int, k: int, weight: float) -> Any:
    """The weight with which a solver has to work, so that `weight` is shown with what pose offsets carry."""
    at = r.memory[k]
    for layer in range(r.covers.shape[1]):
        if mem.seconds[row, layer] > 0.0 and r.covers[k, layer]:
            keep[row, at + CARRIED], keep[row, at + LAYER] = keep[row, at + SHOWN], layer
            forget_turns(r, keep, row, k)
    carried = keep[row, at + CARRIED]
    if carried > 0.0:
        layer = min(int(keep[row, at + LAYER]), r.covers.shape[1] - 1)  # an edit may have removed its layer
        carried *= remaining(o, row, layer, 0.0)[0]
        if carried <= 0.0:
            keep[row, at + CARRIED] = 0.0
    missing = weight
    if weight < 1.0 and carried > 0.0:
        missing = (weight - carried) / (1.0 - carried) if carried < weight else 0.0
    keep[row, at + SHOWN] = max(weight, carried)
    return missing
