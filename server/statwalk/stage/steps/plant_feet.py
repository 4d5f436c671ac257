"""Step 8 of the tick for feet: planted feet stay where they stand, legs and pelvis give way."""

from __future__ import annotations

from typing import Any

from statwalk.maths.blending import member_phase, weigh
from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.scalar import sincos
from statwalk.maths.simd.lanes import LANES
from statwalk.maths.simd.pose_layout import end_row, first_row
from statwalk.rig.hierarchy import model_block
from statwalk.solve.chains import ROWS
from statwalk.solve.foot_fit import begin_fit, fit_foot
from statwalk.solve.foot_lock import begin_blend, step_foot
from statwalk.solve.foot_tables import OF_ACTOR, OF_FIT, OF_FOOT, OF_GROUND
from statwalk.solve.foot_targets import aim_leg, begin_pelvis, follow_ground, lower_pelvis, move_pelvis
from statwalk.solve.solve_block import solve_chain_block
from statwalk.stage.steps.foot_landings import next_landing
from statwalk.stage.steps.offset_clocks import remaining


@called
def plant_feet(
    f: Any, chains: Any, clamps: Any, m: Any, s: Any, o: Any, mem: Any, values: Any, position: Any,
    heading: Any, keep: Any, block: int, dt: float,
) -> None:  # fmt: skip
    """Moves the pelvis and the legs of a block's actors in `values`; chain k is the leg of foot k."""
    model_block(f.joints, f.parents, values, mem.legs, block)
    for row in range(first_row(block), end_row(block, s.state.shape[0])):
        sine, cosine = sincos(heading[row])
        follow_ground(f, keep, position, row, sine, cosine, dt)
        unit = f.unit[0]
        root = position[row, 0] / unit, position[row, 1] / unit, position[row, 2] / unit, sine, cosine
        if mem.seconds[row, 0] > 0.0:
            _begin_blend(f, keep, row)
        if f.fit[0] >= 0:
            _fit_feet(f, m, s, o, mem, position, heading, keep, row, root, dt)
        _step_feet(f, m, s, o, mem, keep, row, root, dt)
        weight = f.weight[0] if f.weight_parameter[0] < 0 else s.smoothed[row, f.weight_parameter[0]]
        weight = min(max(weight, 0.0), 1.0)
        drop = weight * lower_pelvis(f, mem.legs, keep, row, root, dt)
        move_pelvis(f, mem.legs, values, row, drop)
        left = remaining(o, row, 0, 0.0)[0]
        for foot in range(f.hip.shape[0]):
            aim_leg(f, mem.legs, keep, mem.leg_rows, row, foot, root, drop, left, weight)
    for foot in range(f.hip.shape[0]):
        at = foot * ROWS * LANES
        solve_chain_block(chains, clamps, foot, values, block, mem.leg_rows, at, mem.chain, keep)


@inlined
def _begin_blend(f: Any, keep: Any, row: int) -> None:
    begin_pelvis(f, keep, row)
    for foot in range(f.hip.shape[0]):
        begin_blend(keep, row, f.memory[0] + OF_ACTOR + foot * OF_FOOT)
        if f.fit[0] >= 0:
            begin_fit(keep, row, f.fit[0] + OF_GROUND + foot * OF_FIT)


@inlined
def _fit_feet(
    f: Any, m: Any, s: Any, o: Any, mem: Any, position: Any, heading: Any, keep: Any, row: int, root: Any,
    dt: float,
) -> None:  # fmt: skip
    """Brings an actor's animated feet to uneven ground."""
    member, left = _member(m, s, mem, row), remaining(o, row, 0, 0.0)[0]
    for foot in range(f.hip.shape[0]):
        landing = next_landing(f, m, s, mem, position, heading, row, member, foot)
        lock, fit = f.memory[0] + OF_ACTOR + foot * OF_FOOT, f.fit[0] + OF_GROUND + foot * OF_FIT
        fit_foot(f, mem.legs, keep, row, foot, lock, fit, root, landing, left, dt)


@inlined
def _step_feet(f: Any, m: Any, s: Any, o: Any, mem: Any, keep: Any, row: int, root: Any, dt: float) -> None:
    """Moves the memory of an actor's feet on by a tick; of two feet each waits for the other."""
    feet = f.hip.shape[0]
    member, blends = _member(m, s, mem, row), o.elapsed[row, 0] < o.duration[row, 0]
    for foot in range(feet):
        at = f.memory[0] + OF_ACTOR + foot * OF_FOOT
        other = f.memory[0] + OF_ACTOR + f.other[foot] * OF_FOOT if f.other[foot] >= 0 else -1
        is_down = member >= 0 and _is_planted(f, m, s, row, member, foot)
        step_foot(f, mem.legs, keep, row, foot, at, other, root, is_down, blends, dt)


@inlined
def _member(m: Any, s: Any, mem: Any, row: int) -> Any:
    """The member with the most weight of the motion that the base plays, -1 without motion."""
    state = s.state[row, 0]
    first, count = m.states[state, 0], m.states[state, 1]
    best = 0
    if count > 1:
        weigh(m, state, s.smoothed, row, mem.weights)
        for k in range(1, count):
            if mem.weights[k] > mem.weights[best]:
                best = k
    return first + best if count > 0 else -1


@inlined
def _is_planted(f: Any, m: Any, s: Any, row: int, member: int, foot: int) -> Any:
    """Whether the motion plants a foot now."""
    phase = member_phase(m, s.state[row, 0], member, s.time[row, 0])
    number, inside = member * f.hip.shape[0] + foot, False
    for k in range(f.first_span[number], f.first_span[number + 1]):
        down, up = f.span[k, 0], f.span[k, 1]
        inside |= down <= phase <= up or down <= phase + 1.0 <= up
    return inside
