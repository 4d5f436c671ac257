"""The whole tick of one actor's machine: rules 0 to 6 of "One tick", in order, layer by layer."""

from __future__ import annotations

from statwalk.machine.compile.program import Program
from statwalk.machine.conditions.condition_values import observe
from statwalk.machine.runtime.at_end import answer_end
from statwalk.machine.runtime.decide import decide
from statwalk.machine.runtime.effects import OF_CHANGES, MachineEffects
from statwalk.machine.runtime.event_queue import wait_again
from statwalk.machine.runtime.events_in_order import WAITING, mark_due, next_event
from statwalk.machine.runtime.pace import note_paces
from statwalk.machine.runtime.parameters import sense, smooth
from statwalk.machine.runtime.scratch import (
    AT_END,
    CARRIED,
    CARRY,
    CHANGES,
    DRAWS,
    DT,
    ENDING,
    ENTERED,
    EVENT,
    FLEETING,
    NOTE,
    OTHER,
    PHASE_OF_EVENTS,
    RESTARTED,
    SLOT,
    STATE_BEFORE,
)
from statwalk.machine.runtime.state import MachineState
from statwalk.machine.runtime.surroundings import Inputs, Measurements
from statwalk.machine.runtime.timing import advance, carry_on, crosses_marker
from statwalk.maths.reference import called, inlined


@called
def step_actor(
    p: Program,
    s: MachineState,
    around: Measurements,
    inputs: Inputs,
    out: MachineEffects,
    i: int,
    first: int,
    past: int,
) -> None:
    """Steps actor `i` by one tick; its inputs are the rows from `first` to before `past`.

    `out.work` holds the truths of conditions and the draws that are already known.
    """
    work = out.work
    note_paces(p, s, work, i, work.clock[DT])
    smooth(p, s, i, work.clock[DT])
    raised = sense(p, s, work, around, i)
    has_events = raised > 0 or past > first
    if has_events and s.state.shape[1] > 1:
        for event in range(s.held.shape[1]):
            work.held[event] = s.held[i, event]
    for layer in range(s.state.shape[1]):
        work.scratch[STATE_BEFORE] = s.state[i, layer]
        observe(p, work.conditions, s.state[i, layer], s.time[i, layer], s.age[i, layer], work.clock[DT])
        s.age[i, layer] += 1
        advance(p, s, out, work.pace[layer], i, layer)
        if (
            has_events
            or s.waiting[i, layer] > 0
            or _must_answer_end(p, s, out, i, layer)
            or crosses_marker(p, s, out, i, layer)
        ):
            if has_events and layer > 0:
                for event in range(s.held.shape[1]):
                    s.held[i, event] = work.held[event]
            _decide_layer(p, s, around, inputs, out, i, layer, first, past)
        else:
            s.passed[i, layer] = s.time[i, layer]


@inlined
def _must_answer_end(p: Program, s: MachineState, out: MachineEffects, i: int, layer: int) -> bool:
    """Returns whether END came and a cell or a held input may answer it."""
    if not out.work.scratch[AT_END]:
        return False
    if p.end_matters[s.state[i, layer]]:
        return True
    for event in range(s.held.shape[1]):  # noqa: SIM110 - compiled code knows no generators
        if s.held[i, event] != 0:
            return True
    return False


@called
def _decide_layer(
    p: Program,
    s: MachineState,
    around: Measurements,
    inputs: Inputs,
    out: MachineEffects,
    i: int,
    layer: int,
    first: int,
    past: int,
) -> None:
    """Looks up every event of the tick in one layer, END last."""
    scratch = out.work.scratch
    scratch[CHANGES], scratch[ENTERED], scratch[ENDING], scratch[CARRIED], scratch[RESTARTED] = 0, 0, 0, 0, 0
    scratch[DRAWS], scratch[NOTE] = 0, -1
    if scratch[AT_END]:
        wait_again(p, s, out, i, layer)
    mark_due(s, out, i, layer, -1)
    scratch[PHASE_OF_EVENTS] = WAITING
    while next_event(p, s, around, inputs, out, i, layer, first, past):
        decide(p, s, around, out, i, layer, scratch[EVENT], scratch[SLOT], scratch[OTHER], scratch[FLEETING])
    if scratch[AT_END] or scratch[RESTARTED]:
        answer_end(p, s, around, out, i, layer)
    if scratch[CHANGES] == 0:
        s.passed[i, layer] = s.time[i, layer]
    elif scratch[CARRIED]:
        carry_on(p, s, out.work, i, layer)
        last = out.counts[OF_CHANGES] - 1
        out.start[last], out.carried[last] = s.time[i, layer], out.work.clock[CARRY]
    if scratch[ENTERED]:
        s.age[i, layer] = 0
    if layer == 0 and s.goal[i] == s.state[i, layer]:
        s.goal[i] = -1
