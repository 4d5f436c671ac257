"""Poses of motions outside the tick: the poses of new actors, and the poses of motions some seconds ahead."""

from __future__ import annotations

from typing import Any

from numba import types

from statwalk.character.pose_tables import POSES
from statwalk.character.role import Role
from statwalk.machine.compile.program import PROGRAM
from statwalk.machine.runtime.state import STATE, MachineState
from statwalk.maths.clamp_table import CLAMP_TABLE
from statwalk.maths.compiling import FLOAT, kernel, write
from statwalk.maths.packed import ADDRESSES, opened, packed
from statwalk.maths.pose_buffer import PoseBuffer
from statwalk.motion.layer_lanes import MASKS
from statwalk.motion.tables.motion_tables import MOTIONS
from statwalk.rig.limit_lanes import limit_block
from statwalk.stage.state.cast import Cast
from statwalk.stage.state.pose_offsets import OFFSETS, PoseOffsets, offset_size
from statwalk.stage.steps._kernels import express_block, keep_block, look_ahead, sample_layers
from statwalk.stage.steps.memory import MEMORY, memory_of
from statwalk.stage.steps.offset_lanes import add_block

_program, _motions, _poses, _masks, _limits, _state = (
    opened(PROGRAM),
    opened(MOTIONS),
    opened(POSES),
    opened(MASKS),
    opened(CLAMP_TABLE),
    opened(STATE),
)
_offsets, _memory = opened(OFFSETS), opened(MEMORY)
Clock = tuple[int, float]
"""the number of a tick, and the seconds of a tick"""


def poses_ahead(
    role: Role,
    state: MachineState,
    seconds: float = 0.0,
    is_limited: bool = False,
    clock: Clock | None = None,
) -> PoseBuffer:
    """Returns the poses of the motions of N actors in `seconds`, if no event happens, without pose offsets;
    if `is_limited`, clamped to the limits of joints; with the machine's expressions at a `clock`, the number
    of a tick and the seconds of a tick.
    """
    actors, layers = state.state.shape
    size = offset_size(len(role.character.skeleton), role.character.bind_pose.weights.shape[-1])
    return _sampled(role, state, PoseOffsets.none(actors, layers, size), seconds, is_limited, clock)


def blended_poses(cast: Cast, clock: Clock) -> PoseBuffer:
    """Returns the poses of the tick `clock` after blending and expressions, before the limits of joints."""
    return _sampled(cast.role, cast.machine, cast.offsets, 0.0, False, clock)


def motion_poses(cast: Cast) -> PoseBuffer:
    """Returns the poses of this tick as blending leaves them, without expressions, limits and solvers."""
    return _sampled(cast.role, cast.machine, cast.offsets, 0.0, False, None)


def _sampled(
    role: Role,
    state: MachineState,
    offsets: PoseOffsets,
    seconds: float,
    is_limited: bool,
    clock: Clock | None,
) -> PoseBuffer:
    count = len(state.state)
    out, memory = PoseBuffer.at_rest(role.character.bind_pose, count), memory_of(role, count)
    memory.poses.values.clock[:] = clock or (0, 0.0)
    changing = packed(state, STATE).argument, packed(offsets, OFFSETS).argument, memory.poses.argument
    tables, options = (*role.packed.arguments, role.packed.clamps.argument), (is_limited, clock is not None)
    _sample_ahead(*tables, *changing, seconds, *options, out.values)
    return out


@kernel(
    ADDRESSES, ADDRESSES, ADDRESSES, ADDRESSES, ADDRESSES, ADDRESSES, ADDRESSES, ADDRESSES, types.float64,
    types.boolean, types.boolean, write(FLOAT, 3),
)  # fmt: skip
def _sample_ahead(
    program: Any, motions: Any, poses: Any, masks: Any, limited: Any, machine: Any, offsets: Any, memory: Any,
    seconds: float, is_limited: bool, is_expressed: bool, out: Any,
) -> None:  # fmt: skip
    """The poses of all blocks, `seconds` ahead."""
    p, m, t, s, mem = _program(program), _motions(motions), _poses(poses), _state(machine), _memory(memory)
    moved, o, limits = _masks(masks), _offsets(offsets), _limits(limited)
    for block in range(out.shape[0]):
        look_ahead(p, s, mem, block, seconds)
        sample_layers(m, t, s, moved, mem, s.state, mem.ahead, mem.coming, block)
        add_block(o, moved, mem.coming, 0, block, 0.0, mem.scratch)
        if is_expressed:
            express_block(t.expressions, s.smoothed, 0.0, mem, mem.coming, block)
        if is_limited:
            limit_block(limits, mem.coming, 0)
        keep_block(mem.coming, out, block)
