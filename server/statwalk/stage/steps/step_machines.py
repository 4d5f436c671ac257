"""Steps 1 and 2 of the tick, time and decide: the motion of actors is measured, then their machines are
stepped, in one call of compiled code.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numba import types

from statwalk.character.pose_tables import POSES
from statwalk.machine.compile.program import PROGRAM, Program
from statwalk.machine.runtime.effects import EFFECTS, MachineEffects, doubled, effects_for
from statwalk.machine.runtime.state import STATE, MachineState
from statwalk.machine.runtime.step import step_from
from statwalk.machine.runtime.surroundings import INPUTS, SURROUNDINGS, Inputs, Measurements
from statwalk.maths.arrays import Floats
from statwalk.maths.compiling import FLOAT, LONG, kernel, read
from statwalk.maths.packed import ADDRESSES, PackedColumns, opened, packed
from statwalk.maths.reference import by_reference
from statwalk.stage.steps.measurements import measure

DOUBLE = types.float64
_program, _poses, _state = opened(PROGRAM), opened(POSES), opened(STATE)
_surroundings, _effects = opened(SURROUNDINGS), opened(EFFECTS)


class MeasuredFrom(NamedTuple):
    """The source of measurements: the pose tables as kernels take them, and what the tick before has shown.
    Without a block of poses, the measurements stay as they are.
    """

    poses: Any
    shown: Floats
    """(B, C, 16) float32"""
    position: Floats
    """(N, 3)"""
    root_delta: Floats
    """(N, 3)"""


NOT_MEASURED = MeasuredFrom(
    np.zeros(0, np.int64), np.zeros((0, 0, 0), np.float32), np.zeros((0, 3)), np.zeros((0, 3))
)


def step_machines(
    program: PackedColumns[Program],
    state: PackedColumns[MachineState],
    dt: float,
    tick: int,
    inputs: Inputs,
    around: PackedColumns[Measurements],
    effects: PackedColumns[MachineEffects],
    measured_from: MeasuredFrom = NOT_MEASURED,
) -> PackedColumns[MachineEffects]:
    """Steps the machines by `dt` seconds, in tick number `tick`; returns the effects.

    `state`, `around` and `effects` are written in place; if `effects` has too little room, larger effects are
    returned.
    """
    actors = len(state.values.state)
    if len(effects.values.before) != actors:
        effects = packed(effects_for(program.values, actors), EFFECTS)
    arguments = program.argument, state.argument, around.argument, *measured_from, inputs
    reached = _step_machines(*arguments, effects.argument, tick, dt, 0)
    while reached < actors:
        effects = packed(doubled(effects.values), EFFECTS)
        reached = _step_machines(*arguments, effects.argument, tick, dt, reached)
    return effects


@kernel(
    ADDRESSES, ADDRESSES, ADDRESSES, ADDRESSES, read(FLOAT, 3), read(DOUBLE, 2), read(DOUBLE, 2), INPUTS,
    ADDRESSES, LONG, DOUBLE, LONG, returns=LONG,
)  # fmt: skip
def _step_machines(
    program: Any, machine: Any, around: Any, poses: Any, shown: Any, position: Any, root_delta: Any,
    inputs: Inputs, effects: Any, tick: int, dt: float, row: int,
) -> int:  # fmt: skip
    """Runs `step_from` for the actors from `row` on; measures all actors first if `row` is 0."""
    p, s, surroundings, done = _program(program), _state(machine), _surroundings(around), _effects(effects)
    if row == 0 and shown.shape[0] > 0:
        for actor in range(s.state.shape[0]):
            measure(_poses(poses), shown, position, root_delta, surroundings, actor, dt)
    return int(step_from(p, s, surroundings, by_reference(inputs), done, tick, dt, row))
