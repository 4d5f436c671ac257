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
from statwalk.stage.steps._kernels import keep_block, look_ahead, sample_layers
from statwalk.stage.steps.memory import MEMORY, memory_of

_program, _motions, _poses, _masks, _state = (
    opened(PROGRAM),
    opened(MOTIONS),
    opened(POSES),
    opened(MASKS),
    opened(STATE),
)
_memory = opened(MEMORY)


def poses_ahead(role: Role, state: MachineState, seconds: float = 0.0) -> PoseBuffer:
    """Returns the poses of the motions of N actors in `seconds`, if no event happens, without pose
    offsets.
    """
    count = len(state.state)
    out, memory = PoseBuffer.at_rest(role.character.bind_pose, count), memory_of(role, count)
    _sample_ahead(
        *role.packed.arguments, packed(state, STATE).argument, memory.poses.argument, seconds, out.values
    )
    return out


@kernel(ADDRESSES, ADDRESSES, ADDRESSES, ADDRESSES, ADDRESSES, ADDRESSES, types.float64, write(FLOAT, 3))
def _sample_ahead(
    program: Any, motions: Any, poses: Any, masks: Any, machine: Any, memory: Any, seconds: float, out: Any
) -> None:
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
        keep_block(mem.coming, out, block)
