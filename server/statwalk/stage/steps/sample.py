"""Poses of motions outside the tick: the poses of new actors, and the poses of motions some seconds ahead."""

from __future__ import annotations

from typing import Any

from numba import types

from statwalk.character.pose_tables import POSES
from statwalk.character.role import Role
from statwalk.machine.compile.program import PROGRAM
from statwalk.machine.runtime.state import STATE, MachineState
from statwalk.maths.compiling import FLOAT, kernel, write
from statwalk.maths.packed import ADDRESSES, opened, packed
from statwalk.maths.pose_buffer import PoseBuffer
from statwalk.motion.layer_lanes import MASKS
from statwalk.motion.tables.motion_tables import MOTIONS
from statwalk.stage.steps._kernels import express_block, keep_block, look_ahead, sample_layers
from statwalk.stage.steps.memory import MEMORY, memory_of

_program, _motions, _poses, _masks, _state = (
    opened(PROGRAM),
    opened(MOTIONS),
    opened(POSES),
    opened(MASKS),
    opened(STATE),
)
_memory = opened(MEMORY)


def poses_ahead(
    role: Role, state: MachineState, seconds: float = 0.0, clock: tuple[int, float] | None = None
) -> PoseBuffer:
    """Returns the poses of the motions of N actors in `seconds`, if no event happens, without pose offsets;
    with the machine's expressions at a `clock`, the number of a tick and the seconds of a tick.
    """
    count = len(state.state)
    out, memory = PoseBuffer.at_rest(role.character.bind_pose, count), memory_of(role, count)
    memory.poses.values.clock[:] = clock or (0, 0.0)
    tables, now = role.packed.arguments, packed(state, STATE).argument
    _sample_ahead(*tables, now, memory.poses.argument, seconds, clock is not None, out.values)
    return out


@kernel(
    ADDRESSES, ADDRESSES, ADDRESSES, ADDRESSES, ADDRESSES, ADDRESSES, types.float64, types.boolean,
    write(FLOAT, 3),
)  # fmt: skip
def _sample_ahead(
    program: Any, motions: Any, poses: Any, masks: Any, machine: Any, memory: Any, seconds: float,
    is_expressed: bool, out: Any,
) -> None:  # fmt: skip
    """The poses of all blocks, `seconds` ahead."""
    p, m, t, s, mem, moved = (
        _program(program),
        _motions(motions),
        _poses(poses),
        _state(machine),
        _memory(memory),
        _masks(masks),
    )
    for block in range(out.shape[0]):
        look_ahead(p, m, s, mem, block, seconds)
        sample_layers(m, t, s, moved, mem, s.state, mem.ahead, mem.coming, block)
        if is_expressed:
            express_block(t.expressions, s.smoothed, 0.0, mem, mem.coming, block)
        keep_block(mem.coming, out, block)
