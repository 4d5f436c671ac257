"""Rule 1: the events of a tick in their order: pending events, markers, senses, inputs.

END comes last, see `at_end`.
"""

from __future__ import annotations

from statwalk.machine.compile.program import Program
from statwalk.machine.runtime.choose import NO_ALTERNATIVE
from statwalk.machine.runtime.decide import over
from statwalk.machine.runtime.effects import MachineEffects
from statwalk.machine.runtime.event_queue import forget, place_of
from statwalk.machine.runtime.reasons import DROPPED, HELD_ALREADY, ONLY_MOTIONS_END, RELEASED
from statwalk.machine.runtime.record import record_verdict
from statwalk.machine.runtime.scratch import (
    EVENT,
    FIRST_TRIED,
    FLEETING,
    NOTE,
    OTHER,
    PAST_TRIED,
    PHASE_OF_EVENTS,
    PLACE,
    SLOT,
    STATE_BEFORE,
)
from statwalk.machine.runtime.state import LOOK_UP, MachineState
from statwalk.machine.runtime.surroundings import HOLD, PRESS, RELEASE, TRAVEL, Inputs, Measurements
from statwalk.machine.runtime.timing import is_before_seam, is_crossed
from statwalk.maths.reference import called, inlined

WAITING, MARKERS, SENSES, INPUTS, OVER = range(5)
"""the kind of event that comes next in a tick"""


@inlined
def mark_due(s: MachineState, out: MachineEffects, i: int, layer: int, kind: int) -> None:
    """Marks the pending events of one `kind` (-1: of all kinds) as due in this tick."""
    for slot in range(s.waiting[i, layer]):
        out.work.due[slot] = kind < 0 or s.waiting_for[i, layer, slot] == kind


@inlined
def next_due(s: MachineState, out: MachineEffects, i: int, layer: int, held_only: int) -> int:
    """Returns the place of the next due event in the queue, -1 none; with `held_only` only of held inputs."""
    for slot in range(s.waiting[i, layer]):
        if out.work.due[slot] and (not held_only or s.held[i, s.waiting_event[i, layer, slot]] != 0):
            out.work.due[slot] = 0
            return slot
    return -1


@called
def next_event(
    p: Program,
    s: MachineState,
    around: Measurements,
    inputs: Inputs,
    out: MachineEffects,
    i: int,
    layer: int,
    first: int,
    past: int,
) -> bool:
    """Puts the next event of the tick into EVENT, SLOT, OTHER, FLEETING and NOTE; returns whether an event is
    left.

    `first`, `past`: the rows of the actor's inputs.
    """
    scratch = out.work.scratch
    while scratch[PHASE_OF_EVENTS] == WAITING:
        slot = next_due(s, out, i, layer, 0)
        if slot >= 0:
            return _hand(out, s.waiting_event[i, layer, slot], slot, s.waiting_other[i, layer, slot], 0)
        scratch[PHASE_OF_EVENTS], scratch[PLACE] = MARKERS, 0
    while scratch[PHASE_OF_EVENTS] == MARKERS:
        event = _next_marker(p, s, out, i, layer)
        if event >= 0:
            return _hand(out, event, place_of(s, i, layer, event), -1, 1)
        scratch[PHASE_OF_EVENTS], scratch[PLACE] = SENSES, 0
    while scratch[PHASE_OF_EVENTS] == SENSES or scratch[PHASE_OF_EVENTS] == INPUTS:
        event, kind, other = _next_input(p, inputs, out, first, past)
        if scratch[PHASE_OF_EVENTS] != OVER and _is_received(p, s, around, out, i, layer, event, kind, other):
            return _hand(out, event, place_of(s, i, layer, event), other, 0)
    return False


@inlined
def _hand(out: MachineEffects, event: int, slot: int, other: int, fleeting: int) -> bool:
    scratch = out.work.scratch
    scratch[EVENT], scratch[SLOT], scratch[OTHER], scratch[FLEETING] = event, slot, other, fleeting
    return True


@called
def _next_marker(p: Program, s: MachineState, out: MachineEffects, i: int, layer: int) -> int:
    """Returns the event of the next crossed marker, by time, -1 none; markers before the seam of a loop come
    first.

    Each marker comes once.
    """
    scratch, first = out.work.scratch, p.markers[out.work.scratch[STATE_BEFORE]]
    count = p.markers[scratch[STATE_BEFORE] + 1] - first
    while scratch[PLACE] < 2 * count:
        marker, again = first + scratch[PLACE] % count, scratch[PLACE] >= count
        scratch[PLACE] += 1
        if (
            p.marker_event[marker] >= 0
            and is_crossed(p, s, out, i, layer, marker)
            and is_before_seam(p, s, out, i, layer, marker) != again
        ):
            return p.marker_event[marker]
    return -1


@called
def _next_input(
    p: Program, inputs: Inputs, out: MachineEffects, first: int, past: int
) -> tuple[int, int, int]:
    """Returns event, kind and other of the next sense that raises its event, or of the next input."""
    scratch = out.work.scratch
    while scratch[PHASE_OF_EVENTS] == SENSES and scratch[PLACE] < p.sense_event.shape[0]:
        sense = scratch[PLACE]
        scratch[PLACE] += 1
        if out.work.sensed[sense]:
            scratch[NOTE] = sense
            return int(p.sense_event[sense]), PRESS, -1
    if scratch[PHASE_OF_EVENTS] == SENSES:
        scratch[PHASE_OF_EVENTS], scratch[PLACE], scratch[NOTE] = INPUTS, first, -1
    row = scratch[PLACE]
    if row >= past:
        scratch[PHASE_OF_EVENTS] = OVER
        return -1, PRESS, -1
    scratch[PLACE] = row + 1
    return inputs.event[row], inputs.kind[row], inputs.other[row]


@called
def _is_received(
    p: Program,
    s: MachineState,
    around: Measurements,
    out: MachineEffects,
    i: int,
    layer: int,
    event: int,
    kind: int,
    other: int,
) -> bool:
    """Returns whether a sense or input is to be looked up. Keys go down and come up here, and the buffer of
    an event that already waits starts again.
    """
    if kind == TRAVEL:
        if layer == 0:
            s.goal[i] = event
        return False
    scratch, slot, is_received = out.work.scratch, place_of(s, i, layer, event), p.received[event, layer] != 0
    scratch[FIRST_TRIED] = scratch[PAST_TRIED] = 0
    if kind == RELEASE:
        s.held[i, event], s.stayed[i, layer, event] = 0, -1
        if slot >= 0 and s.waiting_held[i, layer, slot]:
            by = s.waiting_other[i, layer, slot]
            forget(s, out, i, layer, slot)
            record_verdict(p, s, around, out, i, layer, event, DROPPED, RELEASED, NO_ALTERNATIVE, by, -1, 0)
        return False
    if event == p.target.shape[1] - 1 or (kind == HOLD and s.held[i, event] != 0):
        if is_received:
            reason = HELD_ALREADY if s.held[i, event] != 0 else ONLY_MOTIONS_END
            record_verdict(p, s, around, out, i, layer, event, DROPPED, reason, NO_ALTERNATIVE, -1, -1, 0)
        return False
    if kind == HOLD:
        s.held[i, event], s.stayed[i, layer, event] = _last_down(s, i) + 1, -1
    if slot >= 0 and is_received:
        s.waiting_for[i, layer, slot], s.waiting_until[i, layer, slot] = LOOK_UP, over(p, out, event)
        s.waiting_held[i, layer, slot], s.waiting_other[i, layer, slot] = False, other
    return is_received


@inlined
def _last_down(s: MachineState, i: int) -> int:
    """Returns the number of the input that went down last, 0 if none is held."""
    last = 0
    for event in range(s.held.shape[1]):
        last = max(last, s.held[i, event])
    return last
