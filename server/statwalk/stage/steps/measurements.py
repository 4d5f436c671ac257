"""Measurements of how actors move, after the tick before: values of conditions, and speed factors of blends.
For explanations; a tick measures in `step_machines`.
"""

from __future__ import annotations

from typing import Any

from numba import types

from statwalk.character.pose_tables import POSES
from statwalk.machine.compile.program import PROGRAM
from statwalk.machine.runtime.state import STATE
from statwalk.machine.runtime.surroundings import SURROUNDINGS, Measurements
from statwalk.maths.compiling import FLOAT, kernel, read
from statwalk.maths.packed import ADDRESSES, PackedColumns, opened
from statwalk.motion.tables.motion_tables import MOTIONS
from statwalk.stage.state.cast import Cast
from statwalk.stage.steps._kernels import measure
from statwalk.stage.steps.memory import MEMORY, Memory

_program, _motions, _poses, _state = opened(PROGRAM), opened(MOTIONS), opened(POSES), opened(STATE)
_memory, _surroundings = opened(MEMORY), opened(SURROUNDINGS)


def surroundings(cast: Cast, memory: Memory, dt: float, seed: int) -> PackedColumns[Measurements]:
    """Returns the surroundings of a cast's machines in the next tick, in `memory`, valid until its
    next use.
    """
    role, around = cast.role, memory.surroundings
    memory.key(cast.ids, seed)
    if role.measures:
        machine, places = (
            memory.machine(cast.machine).argument,
            (cast.shown.values, cast.position, cast.root_delta),
        )
        _measure_all(*role.packed.arguments[:3], machine, memory.poses.argument, *places, around.argument, dt)
    return around


@kernel(
    ADDRESSES, ADDRESSES, ADDRESSES, ADDRESSES, ADDRESSES, read(FLOAT, 3), read(types.float64, 2),
    read(types.float64, 2), ADDRESSES, types.float64,
)  # fmt: skip
def _measure_all(
    program: Any,
    motions: Any,
    poses: Any,
    machine: Any,
    memory: Any,
    shown: Any,
    position: Any,
    root_delta: Any,
    around: Any,
    dt: float,
) -> None:
    p, m, t, s, mem = _program(program), _motions(motions), _poses(poses), _state(machine), _memory(memory)
    out = _surroundings(around)
    for row in range(s.state.shape[0]):
        measure(p, m, t, s, mem, shown, position, root_delta, out, row, dt)
