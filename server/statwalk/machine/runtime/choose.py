"""Chooses the alternative of a cell: by its conditions, in order, or by chance."""

from __future__ import annotations

import numpy as np

from statwalk.machine.compile.alternatives import MIXED
from statwalk.machine.compile.program import NO_CONDITION, NO_WEIGHT, Program
from statwalk.machine.conditions.condition_values import is_true
from statwalk.machine.runtime.effects import MOST_DRAWS, MachineEffects
from statwalk.machine.runtime.scratch import DRAWS, FIRST_TRIED, PAST_TRIED, TICK
from statwalk.machine.runtime.state import MachineState
from statwalk.machine.runtime.surroundings import Measurements
from statwalk.maths.random import chance
from statwalk.maths.reference import called

NO_ALTERNATIVE = -1
"""row of an alternative: none"""


@called
def choose(
    p: Program, s: MachineState, around: Measurements, out: MachineEffects, i: int, layer: int, event: int
) -> int:
    """Returns the row of a cell's alternative: the first whose condition holds, or the one that chance draws;
    NO_ALTERNATIVE if no condition holds.
    """
    scratch, current = out.work.scratch, s.state[i, layer]
    cell = current * p.target.shape[1] + event
    first, past = p.alternatives[cell], p.alternatives[cell + 1]
    scratch[FIRST_TRIED] = scratch[PAST_TRIED] = first
    if p.target[current, event] != MIXED:
        return first
    if p.weight[first] != NO_WEIGHT:
        return _drawn(p, around, out, i, layer, event, first, past)
    for row in range(first, past):
        scratch[PAST_TRIED] = row + 1
        condition = p.condition[row]
        if condition == NO_CONDITION or is_true(p, s, around, out.work.conditions, i, layer, condition):
            return row
    return NO_ALTERNATIVE


@called
def _drawn(
    p: Program,
    around: Measurements,
    out: MachineEffects,
    i: int,
    layer: int,
    event: int,
    first: int,
    past: int,
) -> int:
    scratch, draw, total = out.work.scratch, np.nan, 0.0
    if scratch[DRAWS] < MOST_DRAWS:
        draw = out.work.draws[layer, scratch[DRAWS]]
    if np.isnan(draw):
        draw = chance(around.key[i], scratch[TICK], layer, event, scratch[DRAWS])
    scratch[DRAWS] += 1
    for row in range(first, past):
        total += p.weight[row]
    place = total * draw
    for row in range(first, past):
        place -= p.weight[row]
        if place < 0:
            return row
    return past - 1
