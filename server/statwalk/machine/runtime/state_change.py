"""Rules 5 and 6: a cell fires, its action is output, and a motion starts in the same tick."""

from __future__ import annotations

from statwalk.machine.compile.program import Program
from statwalk.machine.conditions.variables import COUNT_MEASURED, PHASE
from statwalk.machine.runtime.effects import MachineEffects
from statwalk.machine.runtime.event_queue import leave
from statwalk.machine.runtime.reasons import TAKEN
from statwalk.machine.runtime.record import record_action, record_change, record_verdict
from statwalk.machine.runtime.scratch import AT_END, CARRIED, CHANGES, ENDING, ENTERED, RESTARTED
from statwalk.machine.runtime.state import MachineState
from statwalk.machine.runtime.surroundings import Measurements
from statwalk.machine.runtime.timing import begin_motion, entry
from statwalk.maths.reference import called, inlined


@called
def take(
    p: Program,
    s: MachineState,
    around: Measurements,
    out: MachineEffects,
    i: int,
    layer: int,
    event: int,
    alternative: int,
    reason: int,
    other: int,
) -> None:
    """Takes an alternative: records its verdict and action, and changes the state."""
    current, target = s.state[i, layer], _target_of(p, s, i, alternative)
    starts = target != current or p.restart[alternative]
    arrived = layer == 0 and target == s.goal[i]
    record_verdict(
        p,
        s,
        around,
        out,
        i,
        layer,
        event,
        TAKEN,
        reason,
        alternative,
        other,
        target if starts else -1,
        arrived,
    )
    if p.action[alternative] >= 0:
        record_action(out, i, layer, p.action[alternative], other)
    if starts:
        _change(p, s, around, out, i, layer, event, alternative, target)


@inlined
def _target_of(p: Program, s: MachineState, i: int, alternative: int) -> int:
    """Returns the state that an alternative leads to; for a composite state with history the inner state that
    was left last.
    """
    resume = p.resume[alternative]
    if resume >= 0 and s.last[i, resume] >= 0:
        return s.last[i, resume]
    return p.to[alternative]


@inlined
def _keep_entry_values(
    p: Program, s: MachineState, around: Measurements, out: MachineEffects, i: int, layer: int, target: int
) -> None:
    """Keeps the values that the motion of `target` is blended over, until the state is entered again: as
    shown at the tick before, the phase as the old motion is left.
    """
    for k in range(p.entry_state.shape[0]):
        if p.entry_state[k] == target:
            kind, duration = p.entry_kind[k], p.duration[s.state[i, layer]]
            value = out.work.conditions.observed[kind]
            if kind < COUNT_MEASURED:
                value = around.measured[kind, i]
            elif kind == PHASE:
                value = s.time[i, layer] / duration if duration > 0 else 0.0
            s.smoothed[i, s.parameters.shape[1] + k] = value


@called
def _change(
    p: Program,
    s: MachineState,
    around: Measurements,
    out: MachineEffects,
    i: int,
    layer: int,
    event: int,
    alternative: int,
    target: int,
) -> None:
    """Clears END and markers of the old motion, and starts the new motion."""
    scratch, current = out.work.scratch, s.state[i, layer]
    seconds = entry(p, s, i, layer, alternative, target)
    scratch[CHANGES] += 1
    scratch[CARRIED] = scratch[ENDING]
    scratch[RESTARTED] = target == current and (scratch[AT_END] or scratch[RESTARTED])
    if target != current:
        _keep_entry_values(p, s, around, out, i, layer, target)
    s.state[i, layer] = target
    begin_motion(s, out.work, i, layer, seconds)
    record_change(p, out, i, layer, event, current, target, alternative, seconds)
    if target == current:
        return
    scratch[ENTERED] = 1
    for history in range(p.inside.shape[1]):
        if p.inside[current, history] and not p.inside[target, history]:
            s.last[i, history] = current
    leave(p, s, out, i, layer, current)
