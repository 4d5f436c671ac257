"""Rule 2: an event of one actor and layer is looked up in the table, and is taken, waits or is dropped."""

from __future__ import annotations

import math

from statwalk.machine.compile.alternatives import AT_END, BLANK, NOW, OFF, UNDEFINED
from statwalk.machine.compile.program import Program
from statwalk.machine.runtime.choose import NO_ALTERNATIVE, choose
from statwalk.machine.runtime.effects import MOST_CHANGES, MachineEffects
from statwalk.machine.runtime.event_queue import append, forget
from statwalk.machine.runtime.reasons import (
    AFTER_THE_END,
    AT_ITS_MOMENT,
    AT_ONCE,
    BLANK_AND_OVER,
    BLANK_CELL,
    CHANGES_ARE_MADE,
    DROPPED,
    FOR_ITS_MOMENT,
    NO_STATE,
    NOTHING_TRUE,
    NOTHING_TRUE_AND_OVER,
    OFF_CELL,
    WAITS,
)
from statwalk.machine.runtime.record import record_verdict
from statwalk.machine.runtime.scratch import CHANGES, DT, ENDING, FIRST_TRIED, OWED, PAST_TRIED, TICK
from statwalk.machine.runtime.state import FOR_BUFFER, FOR_END, FOR_MOMENT, LOOK_UP, UNSET, MachineState
from statwalk.machine.runtime.state_change import take
from statwalk.machine.runtime.surroundings import Measurements
from statwalk.machine.runtime.timing import is_its_moment
from statwalk.maths.reference import called


@called
def decide(
    p: Program,
    s: MachineState,
    around: Measurements,
    out: MachineEffects,
    i: int,
    layer: int,
    event: int,
    slot: int,
    other: int,
    fleeting: int,
) -> None:
    """Looks up one event, which waits at `slot` of the queue (-1: it does not wait).

    A `fleeting` event (a marker) does not wait.
    """
    scratch, current = out.work.scratch, s.state[i, layer]
    target, first = p.target[current, event], p.alternatives[current * p.target.shape[1] + event]
    scratch[FIRST_TRIED] = scratch[PAST_TRIED] = first
    if slot >= 0 and s.waiting_until[i, layer, slot] == UNSET:
        s.waiting_until[i, layer, slot] = over(p, out, event)
    if scratch[CHANGES] == MOST_CHANGES:
        if slot < 0:
            append(s, out, i, layer, event, LOOK_UP, over(p, out, event), False, other)
        record_verdict(
            p, s, around, out, i, layer, event, WAITS, CHANGES_ARE_MADE, NO_ALTERNATIVE, other, -1, 0
        )
    elif target == BLANK:
        _wait_for_buffer(p, s, around, out, i, layer, event, slot, other, BLANK_CELL)
    elif target == OFF:
        drop(p, s, around, out, i, layer, event, slot, other, OFF_CELL, NO_ALTERNATIVE)
    elif target == UNDEFINED:
        drop(p, s, around, out, i, layer, event, slot, other, NO_STATE, first)
    elif not is_its_moment(p, s, out, i, layer, event):
        kind = FOR_END if p.when[current, event] == AT_END else FOR_MOMENT
        _wait(p, s, around, out, i, layer, event, slot, other, kind, FOR_ITS_MOMENT)
    else:
        when = p.when[current, event]
        reason = AT_ONCE if when == NOW else AFTER_THE_END if when == AT_END else AT_ITS_MOMENT
        fire(p, s, around, out, i, layer, event, slot, other, fleeting, reason, NO_ALTERNATIVE)


@called
def fire(
    p: Program,
    s: MachineState,
    around: Measurements,
    out: MachineEffects,
    i: int,
    layer: int,
    event: int,
    slot: int,
    other: int,
    fleeting: int,
    reason: int,
    repeated: int,
) -> int:
    """Takes the alternative of a cell whose moment has come; if no alternative is true, the event waits or is
    dropped.

    Returns the row of the alternative that was taken, else NO_ALTERNATIVE. `repeated`: the alternative that
    the same held input took in the tick before; taking it again gives no second verdict.
    """
    chosen = choose(p, s, around, out, i, layer, event)
    if chosen == NO_ALTERNATIVE and not fleeting:
        _wait_for_buffer(p, s, around, out, i, layer, event, slot, other, NOTHING_TRUE)
    elif chosen == NO_ALTERNATIVE:
        if out.work.scratch[ENDING]:  # a marker gets no verdict
            drop(p, s, around, out, i, layer, event, slot, other, NOTHING_TRUE, NO_ALTERNATIVE)
    elif p.to[chosen] == UNDEFINED:
        drop(p, s, around, out, i, layer, event, slot, other, NO_STATE, chosen)
        return NO_ALTERNATIVE
    elif chosen == repeated:
        forget(s, out, i, layer, slot)
    else:
        forget(s, out, i, layer, slot)
        take(p, s, around, out, i, layer, event, chosen, reason, other)
    return chosen


@called
def drop(
    p: Program,
    s: MachineState,
    around: Measurements,
    out: MachineEffects,
    i: int,
    layer: int,
    event: int,
    slot: int,
    other: int,
    reason: int,
    alternative: int,
) -> None:
    """Removes an event from the queue, with the verdict DROPPED."""
    by = s.waiting_other[i, layer, slot] if slot >= 0 else other
    forget(s, out, i, layer, slot)
    record_verdict(p, s, around, out, i, layer, event, DROPPED, reason, alternative, by, -1, 0)


@called
def _wait_for_buffer(
    p: Program,
    s: MachineState,
    around: Measurements,
    out: MachineEffects,
    i: int,
    layer: int,
    event: int,
    slot: int,
    other: int,
    reason: int,
) -> None:
    """Rule 3: in a blank cell an event waits until its buffer runs out. The buffer counts from the arrival of
    the event, through changes of state.
    """
    until = s.waiting_until[i, layer, slot] if slot >= 0 else over(p, out, event)
    if out.work.scratch[TICK] < until:
        _wait(p, s, around, out, i, layer, event, slot, other, FOR_BUFFER, reason)
        return
    kind = s.waiting_for[i, layer, slot] if slot >= 0 else LOOK_UP
    has_waited = kind == FOR_BUFFER or (kind != LOOK_UP and p.buffer[event] > 0)
    if has_waited:
        reason = BLANK_AND_OVER if reason == BLANK_CELL else NOTHING_TRUE_AND_OVER
    drop(p, s, around, out, i, layer, event, slot, other, reason, NO_ALTERNATIVE)


@called
def _wait(
    p: Program,
    s: MachineState,
    around: Measurements,
    out: MachineEffects,
    i: int,
    layer: int,
    event: int,
    slot: int,
    other: int,
    kind: int,
    reason: int,
) -> None:
    """Keeps the event in its place in the queue, or appends it; gives a verdict if the reason for waiting is
    new.
    """
    if slot < 0:
        append(s, out, i, layer, event, kind, over(p, out, event), False, other)
    elif s.waiting_for[i, layer, slot] == kind:
        return
    else:
        s.waiting_for[i, layer, slot] = kind
        if out.work.scratch[OWED] and s.waiting_held[i, layer, slot]:
            return
    record_verdict(p, s, around, out, i, layer, event, WAITS, reason, NO_ALTERNATIVE, other, -1, 0)


@called
def over(p: Program, out: MachineEffects, event: int) -> int:
    """Returns the tick in which the buffer of an event that arrives in this tick runs out."""
    return int(out.work.scratch[TICK] + math.ceil(p.buffer[event] / out.work.clock[DT] - 1e-4))
