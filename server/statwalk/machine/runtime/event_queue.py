"""Rule 3: the queue of pending events of an actor and layer, at most 16, by arrival."""

from __future__ import annotations

from statwalk.machine.compile.program import Program
from statwalk.machine.runtime.effects import MachineEffects
from statwalk.machine.runtime.reasons import DROPPED, STATE_WAS_LEFT, TOO_MANY_WAIT
from statwalk.machine.runtime.record import record_verdict_on
from statwalk.machine.runtime.state import FOR_END, FOR_MOMENT, LOOK_UP, MOST_WAITING, UNSET, MachineState
from statwalk.maths.reference import called, inlined


@inlined
def place_of(s: MachineState, i: int, layer: int, event: int) -> int:
    """Returns the place of a pending event in the queue, -1 if the event does not wait."""
    for slot in range(s.waiting[i, layer]):
        if s.waiting_event[i, layer, slot] == event:
            return slot
    return -1


@called
def forget(s: MachineState, out: MachineEffects, i: int, layer: int, slot: int) -> None:
    """Removes the event at `slot` from the queue (-1: does nothing); later events move up, and the last place
    is cleared.
    """
    if slot < 0:
        return
    due, last = out.work.due, s.waiting[i, layer] - 1
    for k in range(slot, last):
        s.waiting_event[i, layer, k] = s.waiting_event[i, layer, k + 1]
        s.waiting_for[i, layer, k] = s.waiting_for[i, layer, k + 1]
        s.waiting_until[i, layer, k] = s.waiting_until[i, layer, k + 1]
        s.waiting_held[i, layer, k] = s.waiting_held[i, layer, k + 1]
        s.waiting_other[i, layer, k] = s.waiting_other[i, layer, k + 1]
        due[k] = due[k + 1]
    s.waiting_event[i, layer, last], s.waiting_for[i, layer, last], s.waiting_until[i, layer, last] = -1, 0, 0
    s.waiting_held[i, layer, last], s.waiting_other[i, layer, last] = False, -1
    due[last] = 0
    s.waiting[i, layer] = last


@called
def append(
    s: MachineState,
    out: MachineEffects,
    i: int,
    layer: int,
    event: int,
    reason: int,
    until: int,
    held: bool,
    other: int,
) -> None:
    """Appends an event to the queue; if the queue is full, the oldest event is dropped."""
    if s.waiting[i, layer] == MOST_WAITING:
        oldest, by = s.waiting_event[i, layer, 0], s.waiting_other[i, layer, 0]
        forget(s, out, i, layer, 0)
        record_verdict_on(out, i, layer, oldest, DROPPED, TOO_MANY_WAIT, s.state[i, layer], by)
    slot = s.waiting[i, layer]
    s.waiting_event[i, layer, slot], s.waiting_for[i, layer, slot], s.waiting_until[i, layer, slot] = (
        event,
        reason,
        until,
    )
    s.waiting_held[i, layer, slot], s.waiting_other[i, layer, slot] = held, other
    out.work.due[slot] = 0
    s.waiting[i, layer] = slot + 1


@called
def wait_again(p: Program, s: MachineState, out: MachineEffects, i: int, layer: int) -> None:
    """Appends every held input to the queue, in the order in which the inputs went down; a held input that
    already waits keeps the rest of its buffer.
    """
    order = 0
    while True:
        event = _next_held(p, s, i, layer, order)
        if event < 0:
            return
        order = s.held[i, event]
        if place_of(s, i, layer, event) < 0:
            append(s, out, i, layer, event, LOOK_UP, UNSET, True, -1)


@inlined
def _next_held(p: Program, s: MachineState, i: int, layer: int, order: int) -> int:
    """Returns the held event that went down next after `order` and that the layer receives; -1 none."""
    earliest = -1
    for event in range(s.held.shape[1]):
        down = s.held[i, event]
        if down > order and p.received[event, layer] and (earliest < 0 or down < s.held[i, earliest]):
            earliest = event
    return earliest


@called
def leave(p: Program, s: MachineState, out: MachineEffects, i: int, layer: int, old: int) -> None:
    """Drops the events that waited for a moment of the old motion, and appends the held inputs again."""
    slot = 0
    while slot < s.waiting[i, layer]:
        kind, event, other = (
            s.waiting_for[i, layer, slot],
            s.waiting_event[i, layer, slot],
            s.waiting_other[i, layer, slot],
        )
        if kind in (FOR_END, FOR_MOMENT):
            forget(s, out, i, layer, slot)
            if s.held[i, event] == 0:
                record_verdict_on(out, i, layer, event, DROPPED, STATE_WAS_LEFT, old, other)
        else:
            slot += 1
    wait_again(p, s, out, i, layer)
