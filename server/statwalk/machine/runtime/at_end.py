"""Rule 4: END.

END is answered by the pending events, else by the END column, else by the idle event. Without an answer the
last pose holds or the loop goes on.
"""

from __future__ import annotations

from statwalk.machine.compile.alternatives import BLANK, MIXED, OFF, UNDEFINED
from statwalk.machine.compile.program import Program
from statwalk.machine.runtime.choose import NO_ALTERNATIVE
from statwalk.machine.runtime.decide import drop, fire
from statwalk.machine.runtime.effects import MOST_CHANGES, MachineEffects
from statwalk.machine.runtime.events_in_order import mark_due, next_due
from statwalk.machine.runtime.reasons import AT_ONCE, AT_THE_END, IDLE, NO_STATE
from statwalk.machine.runtime.scratch import AT_END, CHANGES, ENDING, RESTARTED
from statwalk.machine.runtime.scratch import OWED as IS_OWED
from statwalk.machine.runtime.state import FOR_END, OWED, RUNNING, MachineState
from statwalk.machine.runtime.surroundings import Measurements
from statwalk.maths.reference import called


@called
def answer_end(
    p: Program, s: MachineState, around: Measurements, out: MachineEffects, i: int, layer: int
) -> None:
    """Looks up everything that answers END, in order, until an answer changes the state.

    After a restart, also after one by an event before END in this tick, only held inputs answer.
    """
    scratch, current, stayed = out.work.scratch, s.state[i, layer], False
    scratch[ENDING], column = 1, BLANK
    mark_due(s, out, i, layer, FOR_END)
    while s.state[i, layer] == current and scratch[CHANGES] < MOST_CHANGES:
        slot = next_due(s, out, i, layer, scratch[RESTARTED])
        if slot < 0 and (stayed or scratch[RESTARTED]):
            break
        column = -1 if slot >= 0 else _next_column(p, s, around, out, i, layer, column)
        if slot < 0 and column < 0:
            return
        event, other, repeated, reason = (
            column,
            -1,
            NO_ALTERNATIVE,
            AT_ONCE if column == p.target.shape[1] - 1 else IDLE,
        )
        if slot >= 0:
            event, other, reason = (
                s.waiting_event[i, layer, slot],
                s.waiting_other[i, layer, slot],
                AT_THE_END,
            )
            if s.waiting_held[i, layer, slot]:
                repeated = s.stayed[i, layer, event] if scratch[IS_OWED] else NO_ALTERNATIVE
        chosen = fire(p, s, around, out, i, layer, event, slot, other, slot < 0, reason, repeated)
        if slot < 0 and chosen != NO_ALTERNATIVE:
            return
        if slot >= 0:
            stayed = stayed or chosen != NO_ALTERNATIVE
            s.stayed[i, layer, event] = (
                chosen if s.held[i, event] != 0 and scratch[AT_END] else NO_ALTERNATIVE
            )
    if stayed and scratch[AT_END]:
        s.ended[i, layer] = RUNNING if p.loop[current] else OWED


@called
def _next_column(
    p: Program, s: MachineState, around: Measurements, out: MachineEffects, i: int, layer: int, last: int
) -> int:
    """Returns the column that answers END if no pending event does: the END column, then the column of the
    idle event, if its cell is not blank; -1 none.
    """
    end, idle, current = p.target.shape[1] - 1, p.idle[0], s.state[i, layer]
    if last == BLANK:
        if p.target[current, end] >= 0 or p.target[current, end] == MIXED:
            return end
        if p.target[current, end] == UNDEFINED:
            drop(
                p, s, around, out, i, layer, end, -1, -1, NO_STATE, p.alternatives[current * (end + 1) + end]
            )
            return -1
    if last == idle or idle < 0 or p.target[current, end] == OFF:
        return -1
    return idle if p.target[current, idle] >= 0 or p.target[current, idle] == MIXED else -1
