"""Writes what happens into the effects: verdicts with the values of their conditions, motions that start,
actions.
"""

from __future__ import annotations

from statwalk.machine.compile.program import NO_CONDITION, Program
from statwalk.machine.conditions.condition_values import value
from statwalk.machine.runtime.effects import (
    OF_ACTIONS,
    OF_CHANGES,
    OF_VALUES,
    OF_VERDICTS,
    MachineEffects,
)
from statwalk.machine.runtime.scratch import FIRST_TRIED, NOTE, PAST_TRIED
from statwalk.machine.runtime.state import MachineState
from statwalk.machine.runtime.surroundings import Measurements
from statwalk.maths.reference import called


@called
def record_verdict(
    p: Program,
    s: MachineState,
    around: Measurements,
    out: MachineEffects,
    i: int,
    layer: int,
    event: int,
    verdict: int,
    reason: int,
    alternative: int,
    other: int,
    to: int,
    arrived: int,
) -> None:
    """Appends a verdict on the current event, in the actor's present state, with the values that the tried
    conditions have read.
    """
    scratch = out.work.scratch
    first = out.counts[OF_VALUES]
    for row in range(scratch[FIRST_TRIED], scratch[PAST_TRIED]):
        condition = p.condition[row]
        if condition != NO_CONDITION:
            for k in range(p.asks[condition], p.asks[condition + 1]):
                _note_value(p, s, around, out, i, p.asked[k], first)
    _verdict(
        out,
        i,
        layer,
        event,
        verdict,
        reason,
        s.state[i, layer],
        to,
        alternative,
        other,
        scratch[NOTE],
        arrived,
    )


@called
def _note_value(
    p: Program, s: MachineState, around: Measurements, out: MachineEffects, i: int, variable: int, first: int
) -> None:
    last = out.counts[OF_VALUES]
    for row in range(first, last):
        if out.variable[row] == variable:
            return
    out.variable[last], out.value[last] = variable, value(p, s, around, out.work.conditions, i, variable)
    out.counts[OF_VALUES] = last + 1


@called
def record_verdict_on(
    out: MachineEffects, i: int, layer: int, event: int, verdict: int, reason: int, current: int, other: int
) -> None:
    """Appends a verdict on an event other than the current one, without values."""
    _verdict(out, i, layer, event, verdict, reason, current, -1, -1, other, -1, 0)


@called
def _verdict(
    out: MachineEffects,
    i: int,
    layer: int,
    event: int,
    verdict: int,
    reason: int,
    current: int,
    to: int,
    alternative: int,
    other: int,
    note: int,
    arrived: int,
) -> None:
    row = out.counts[OF_VERDICTS]
    table = out.verdicts
    table[row, 0], table[row, 1], table[row, 2], table[row, 3], table[row, 4], table[row, 5] = (
        i,
        layer,
        event,
        verdict,
        reason,
        current,
    )
    table[row, 6], table[row, 7], table[row, 8], table[row, 9], table[row, 10] = (
        to,
        alternative,
        other,
        note,
        arrived,
    )
    table[row, 11] = out.counts[OF_VALUES]
    out.counts[OF_VERDICTS] = row + 1


@called
def record_action(out: MachineEffects, i: int, layer: int, action: int, other: int) -> None:
    """Appends an action."""
    row = out.counts[OF_ACTIONS]
    out.actions[row, 0], out.actions[row, 1], out.actions[row, 2], out.actions[row, 3] = (
        i,
        layer,
        action,
        other,
    )
    out.counts[OF_ACTIONS] = row + 1


@called
def record_change(
    p: Program,
    out: MachineEffects,
    i: int,
    layer: int,
    event: int,
    current: int,
    to: int,
    alternative: int,
    seconds: float,
) -> None:
    """Appends a motion that starts, `seconds` after its beginning."""
    row = out.counts[OF_CHANGES]
    table = out.changes
    table[row, 0], table[row, 1], table[row, 2], table[row, 3], table[row, 4] = i, layer, event, current, to
    table[row, 5], table[row, 6], table[row, 7] = p.action[alternative], current == to, p.curve[alternative]
    out.blend[row], out.start[row], out.carried[row] = p.blend[alternative], seconds, 0.0
    out.counts[OF_CHANGES] = row + 1
