"""The values of conditions: each condition is evaluated at most once a tick for an actor and layer, on the
state after the tick before and on the smoothed parameters of this tick.
"""

from __future__ import annotations

from statwalk.machine.compile.program import (
    HEIGHT,
    PHASE,
    SPEED,
    TIME,
    TURNING,
    Program,
)
from statwalk.machine.runtime.effects import Workspace
from statwalk.machine.runtime.scratch import AGE, DT, STATE_BEFORE, TIME_BEFORE
from statwalk.machine.runtime.state import MachineState
from statwalk.machine.runtime.surroundings import Measurements
from statwalk.maths.formula.evaluate import number, result
from statwalk.maths.reference import called

UNKNOWN, FALSE, TRUE = 0, 1, 2
"""the truth of a condition"""


@called
def is_true(
    p: Program, s: MachineState, w: Workspace, around: Measurements, i: int, layer: int, condition: int
) -> bool:
    """Returns whether a condition is true for actor `i` in a layer; evaluates the condition if its truth is
    UNKNOWN.
    """
    if w.truths[layer, condition] == UNKNOWN:
        for k in range(p.asks[condition], p.asks[condition + 1]):
            variable = p.asked[k]
            w.values[variable] = number(value(p, s, w, around, i, variable))
        first, end = p.code[condition], p.code[condition + 1]
        answer = result(p.opcode, p.operand, first, end, w.values, w.stack)
        w.truths[layer, condition] = TRUE if answer != 0 else FALSE
    return bool(w.truths[layer, condition] == TRUE)


@called
def value(p: Program, s: MachineState, w: Workspace, around: Measurements, i: int, variable: int) -> float:
    """Returns a variable as it was after the tick before; parameters are the smoothed ones of this tick."""
    kind = p.measured[variable]
    if kind in (SPEED, TURNING, HEIGHT):
        return around.measured[kind, i]
    if kind == PHASE:
        duration = p.duration[w.scratch[STATE_BEFORE]]
        return w.clock[TIME_BEFORE] / (duration if duration > 0 else 1.0)
    if kind == TIME:
        return w.scratch[AGE] * w.clock[DT]
    return s.smoothed[i, variable]
