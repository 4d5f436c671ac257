"""The values of conditions: each condition is evaluated at most once a tick for an actor and layer, on the
state after the tick before and on the smoothed parameters of this tick.

`p` Program, `s` MachineState, `around` Measurements, `c` ConditionValues, `i` the actor.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numba import types
from numpy.typing import NDArray

from statwalk.machine.conditions.variables import COUNT_MEASURED, NAMES, PARAMETER, PHASE, TIME
from statwalk.maths.compiling import write
from statwalk.maths.formula.evaluate import number, result
from statwalk.maths.reference import called, inlined

UNKNOWN, FALSE, TRUE = 0, 1, 2
"""the truth of a condition"""


class ConditionValues(NamedTuple):
    """What the conditions of one actor have read in a tick."""

    truths: NDArray[np.uint8]
    """(L, C) truth of each condition: UNKNOWN, FALSE or TRUE"""
    observed: NDArray[np.float64]
    """(5,) the rows of OBSERVED in NAMES, of the layer at hand"""
    values: NDArray[np.float64]
    """(V,) values of the variables"""
    stack: NDArray[np.float64]
    """stack on which a condition is evaluated"""


CONDITION_VALUES = types.BaseTuple.from_types(
    (write(types.uint8, 2), *(write(types.float64, 1),) * 3), ConditionValues
)
"""the type of ConditionValues in kernels"""


def condition_values(layers: int, conditions: int, variables: int, steps: int) -> ConditionValues:
    """Returns ConditionValues in which nothing is known; `steps`: the most that a condition may have."""
    return ConditionValues(
        np.zeros((layers, conditions), np.uint8),
        np.zeros(len(NAMES)),
        np.zeros(variables),
        np.zeros(max(1, steps)),
    )


@inlined
def forget_truths(c: ConditionValues) -> None:
    """Sets the truth of every condition to UNKNOWN."""
    for layer in range(c.truths.shape[0]):
        for condition in range(c.truths.shape[1]):
            c.truths[layer, condition] = UNKNOWN


@inlined
def observe(p: Any, c: ConditionValues, state: int, time: float, age: int, dt: float) -> None:
    """Writes what the machine knows of a layer that is in a state for `age` ticks of `dt` seconds, `time`
    seconds into its motion.
    """
    duration = p.duration[state]
    c.observed[PHASE] = time / (duration if duration > 0 else 1.0)
    c.observed[TIME] = age * dt


@called
def value(p: Any, s: Any, around: Any, c: ConditionValues, i: int, variable: int) -> float:
    """Returns a variable as it was after the tick before; parameters are the smoothed ones of this tick."""
    kind = p.variable_kind[variable]
    if kind == PARAMETER:
        return float(s.smoothed[i, variable])
    return float(around.measured[kind, i] if kind < COUNT_MEASURED else c.observed[kind])


@called
def is_true(p: Any, s: Any, around: Any, c: ConditionValues, i: int, layer: int, condition: int) -> bool:
    """Returns whether a condition is true for actor `i` in a layer; evaluates the condition if its truth is
    UNKNOWN.
    """
    if c.truths[layer, condition] == UNKNOWN:
        for k in range(p.asks[condition], p.asks[condition + 1]):
            variable = p.asked[k]
            c.values[variable] = number(value(p, s, around, c, i, variable))
        first, end = p.code[condition], p.code[condition + 1]
        answer = result(p.opcode, p.operand, first, end, c.values, c.stack)
        c.truths[layer, condition] = TRUE if answer != 0 else FALSE
    return bool(c.truths[layer, condition] == TRUE)
