"""The values that the conditions of an actor would read in its next tick; `stage/explain` searches for values
that would make a condition true.
"""

from __future__ import annotations

import numpy as np
from numba import types
from numpy.typing import NDArray

from statwalk.machine.compile.program import PROGRAM, Program
from statwalk.machine.conditions.condition_values import observe, value
from statwalk.machine.runtime.effects import WORKSPACE, Workspace, workspace_for
from statwalk.machine.runtime.parameters import smooth
from statwalk.machine.runtime.state import STATE, MachineState
from statwalk.machine.runtime.surroundings import SURROUNDINGS, Measurements
from statwalk.maths.compiling import kernel
from statwalk.maths.reference import by_reference


@kernel(PROGRAM, STATE, SURROUNDINGS, WORKSPACE, types.float64)
def _see(p: Program, s: MachineState, around: Measurements, w: Workspace, dt: float) -> None:
    program, state, surroundings, work = (
        by_reference(p),
        by_reference(s),
        by_reference(around),
        by_reference(w),
    )
    smooth(program, state, 0, dt)
    observe(program, work.conditions, s.state[0, 0], s.time[0, 0], s.age[0, 0], dt)
    for variable in range(p.variable_kind.shape[0]):
        w.conditions.values[variable] = value(program, state, surroundings, work.conditions, 0, variable)


def seen(
    program: Program, state: MachineState, around: Measurements, dt: float, row: int
) -> NDArray[np.float64]:
    """Returns (V,) the variables as the senses of actor `row` will read them; phase and time are of the base
    layer.
    """
    rows, work = np.array([row]), workspace_for(program)
    own = Measurements(np.ascontiguousarray(around.measured[:, rows]), around.key[rows])
    _see(program, state.take(rows), own, work, dt)
    return work.conditions.values
