"""One tick of a cast: what statwalk does, on one page.

No clock, no file, no global random state: the same state and events give the same bits.

Python calls compiled code twice: for the machines, then for the poses. (If the machines have more effects
than the tick's memory holds, they go on with twice the room: one more call for each doubling.) The step
numbers are the design's; step 10, sense, is for the whole stage (`advance`).
"""

from __future__ import annotations

from typing import Any

from numba import types

from statwalk.character.pose_tables import POSES
from statwalk.machine.compile.program import PROGRAM
from statwalk.machine.runtime.effects import EFFECTS
from statwalk.machine.runtime.result import StepResult, result_of
from statwalk.machine.runtime.state import STATE
from statwalk.machine.runtime.surroundings import Inputs
from statwalk.maths.arrays import Ints
from statwalk.maths.clamp_table import CLAMP_TABLE
from statwalk.maths.compiling import FLOAT, LONG, kernel, write
from statwalk.maths.packed import ADDRESSES, opened
from statwalk.maths.simd.pose_layout import end_row, first_row
from statwalk.motion.layer_lanes import MASKS
from statwalk.motion.tables.motion_tables import MOTIONS
from statwalk.rig.hierarchy import model_block
from statwalk.rig.limit_lanes import limit_block
from statwalk.solve.chains import CHAINS
from statwalk.solve.foot_tables import FEET
from statwalk.solve.hanging import HANGING
from statwalk.solve.reach_tables import REACH
from statwalk.solve.solve_block import forget_notes
from statwalk.solve.spring_lanes import swing_block
from statwalk.stage.state.cast import Cast
from statwalk.stage.state.pose_offsets import OFFSETS
from statwalk.stage.steps._kernels import (
    express_block,
    hash_actor,
    keep_block,
    move_root,
    note_transitions,
    root_motion,
    sample_layers,
)
from statwalk.stage.steps.hang import hang
from statwalk.stage.steps.hash_lanes import hash_block
from statwalk.stage.steps.measurements import places_of
from statwalk.stage.steps.memory import MEMORY, Memory, memory_of
from statwalk.stage.steps.offset_apart import begin_transitions
from statwalk.stage.steps.offset_begin import begins_here
from statwalk.stage.steps.offset_clocks import advance_clocks, blend_root_delta, release_slots
from statwalk.stage.steps.offset_cuts import cuts_here, forget_cuts
from statwalk.stage.steps.offset_lanes import add_block
from statwalk.stage.steps.plant_feet import plant_feet
from statwalk.stage.steps.reach import measure_reached, reach
from statwalk.stage.steps.step_machines import NOT_MEASURED, MeasuredFrom, step_machines

DOUBLE = types.float64
_program, _motions, _poses, _masks, _state = (
    opened(PROGRAM),
    opened(MOTIONS),
    opened(POSES),
    opened(MASKS),
    opened(STATE),
)
_feet, _chains, _clamps = opened(FEET), opened(CHAINS), opened(CLAMP_TABLE)
_reach, _hanging = opened(REACH), opened(HANGING)
_offsets, _effects, _memory = opened(OFFSETS), opened(EFFECTS), opened(MEMORY)


def tick(
    cast: Cast, inputs: Inputs, dt: float, now: int, seed: int, is_looked_at: bool = False
) -> tuple[Cast, StepResult]:
    """Returns the cast one step of `dt` seconds later, as tick `now`, and the result of its machines; if
    `is_looked_at`, with the joints of its colliders in model space.

    Takes the cast over.
    """
    memory = memory_of(cast.role, len(cast.ids))
    memory.poses.values.old_state[:] = cast.machine.state
    memory.poses.values.clock[:] = now, dt
    result = decide(cast, memory, inputs, dt, now, seed)
    return pose(cast, memory, result.changes.actor, dt, is_looked_at), result


def decide(cast: Cast, memory: Memory, inputs: Inputs, dt: float, now: int, seed: int) -> StepResult:
    """Runs steps 1 time and 2 decide: measures how actors move, if a machine reads it; advances clip times,
    finds the markers and END that they cross, and looks up the events of every actor.
    """
    role, machine, measured_from = cast.role, memory.machine(cast.machine), NOT_MEASURED
    memory.key(cast.ids, seed)
    if role.measures:
        measured_from = MeasuredFrom(role.packed.poses.argument, *places_of(cast))
    around, effects = memory.surroundings, memory.effects
    memory.effects = step_machines(
        role.packed.program, machine, dt, now, inputs, around, effects, measured_from
    )
    return result_of(cast.machine, memory.effects.values)


def pose(cast: Cast, memory: Memory, changed: Ints, dt: float, is_looked_at: bool) -> Cast:
    """Runs steps 3 sample, 4 blend, 5 express, 6 limit and 7 world, for sixteen actors at a time; `changed`:
    the rows of the actors whose state has changed.
    """
    offsets = cast.offsets.with_room(changed) if len(changed) else cast.offsets
    work = memory.offsets(offsets).argument, memory.effects.argument, memory.poses.argument
    places = cast.position, cast.heading, cast.root_delta, cast.solver_memory, cast.hash
    buffers, machine = (cast.previous.values, cast.shown.values), memory.machine(cast.machine).argument
    _pose_blocks(
        *cast.role.packed.arguments,
        *cast.role.packed.solvers,
        machine,
        *work,
        *buffers,
        *places,
        cast.shown.used,
        dt,
        is_looked_at,
    )
    model = memory.model if is_looked_at else None
    return Cast(
        cast.ids, cast.machine, cast.previous, cast.shown, offsets, *places, role=cast.role, model=model
    )


@kernel(
    ADDRESSES, ADDRESSES, ADDRESSES, ADDRESSES, ADDRESSES, ADDRESSES, ADDRESSES, ADDRESSES, ADDRESSES,
    ADDRESSES, ADDRESSES, ADDRESSES, ADDRESSES, write(FLOAT, 3),
    write(FLOAT, 3), write(DOUBLE, 2), write(DOUBLE, 1), write(DOUBLE, 2), write(DOUBLE, 2),
    write(types.uint64, 1), LONG,
    DOUBLE, types.boolean,
)  # fmt: skip
def _pose_blocks(
    program: Any, motions: Any, poses: Any, moved: Any, feet: Any, links: Any, limits: Any, reached: Any,
    falling: Any, machine: Any,
    offsets: Any, effects: Any, memory: Any,
    previous: Any, shown: Any, position: Any, heading: Any, root_delta: Any, solver_memory: Any,
    hashes: Any, used: int, dt: float, is_looked_at: bool,
) -> None:  # fmt: skip
    """Writes the poses of all blocks into `previous`; `offsets` has room for all transitions that begin."""
    p, m, t, masks = _program(program), _motions(motions), _poses(poses), _masks(moved)
    f, chains, clamps = _feet(feet), _chains(links), _clamps(limits)
    r, h = _reach(reached), _hanging(falling)
    s, o, done, mem = _state(machine), _offsets(offsets), _effects(effects), _memory(memory)
    note_transitions(t, s, done, mem)
    for block in range(shown.shape[0]):
        # 3 sample: the local poses of the motions, upper layers over lower layers
        sample_layers(m, t, s, masks, mem, s.state, s.time, mem.coming, block)
        # 4 blend: the jump of a pose becomes an offset that decays; the root motion goes over into its new
        # velocity
        if cuts_here(mem, block):
            forget_cuts(p, m, t, s, o, masks, done, mem, shown, block, dt)
        if begins_here(mem, block):
            begin_transitions(p, m, t, s, o, masks, done, mem, previous, shown, block, root_delta, dt)
        for row in range(first_row(block), end_row(block, s.state.shape[0])):
            advance_clocks(o, row, dt)
            root_delta[row, 0], root_delta[row, 1], root_delta[row, 2] = root_motion(p, m, s, mem, done, row)
            blend_root_delta(o, row, root_delta)
            move_root(position, heading, root_delta, row)
            # a running hash of everything that can influence a later tick
            hashes[row] = hash_actor(hashes[row], s, o, position, heading, root_delta, solver_memory, row)
        add_block(o, masks, mem.coming, 0, block, 0.0, mem.scratch)
        release_slots(o, block)
        # 5 express: assignments to channels, in the order of their dependencies
        express_block(t.expressions, s.smoothed, 0.0, mem, mem.coming, block)
        # joints with springs lag behind, and settle
        if t.column.shape[0] > 0:
            first, end = first_row(block), end_row(block, s.state.shape[0])
            swing_block(t, solver_memory, root_delta, mem.coming, first, end, dt, mem.springs)
        # 6 limit: joints with limits are clamped, SK6
        limit_block(clamps, mem.coming, 0)
        keep_block(mem.coming, previous, block)
        # 8 reach: planted feet stay where they stand
        forget_notes(chains, solver_memory, block)
        if f.hip.shape[0] > 0:
            plant_feet(f, chains, clamps, m, s, o, mem, previous, position, heading, solver_memory, block, dt)
        # and the chains of the machine file reach for their targets
        if r.memory.shape[0] > 0:
            reach(r, chains, clamps, s, o, mem, previous, position, heading, solver_memory, block, dt)
        # chains hang between their anchors
        hang(h, r, chains, clamps, mem, previous, position, heading, root_delta, solver_memory, block, dt)
        measure_reached(r, chains, s, mem, previous, position, heading, solver_memory, block)
        # 7 world: the joints that colliders ride on, in model space, once for all readers
        # (`Cast.model`: touches, flocks); the matrices of all joints are computed when they are read
        # (`Actor.world`, the server's frames)
        if is_looked_at:
            model_block(t.model_joints, t.model_parents, previous, mem.model, block)
        hash_block(hashes, previous, used, o, block, mem.scratch)
