"""The fast path for an actor with nothing to decide: its motions advance."""

from __future__ import annotations

from statwalk.machine.compile.program import Program
from statwalk.machine.runtime.effects import MachineEffects
from statwalk.machine.runtime.pace import note_paces, speed_of
from statwalk.machine.runtime.state import MachineState
from statwalk.machine.runtime.timing import NEARLY
from statwalk.maths.reference import inlined


@inlined
def passes_quietly(p: Program, s: MachineState, out: MachineEffects, i: int, dt: float) -> bool:
    """Advances the motions of an actor without inputs and returns True, if no END, marker, sense, pending
    event or parameter on its way needs a decision.

    Otherwise returns False and changes nothing; `step_actor` must step the actor, with the same result for a
    quiet one.
    """
    if p.sense_event.shape[0] > 0:
        return False
    for k in range(s.parameters.shape[1]):
        if s.smoothed[i, k] != s.parameters[i, k] or s.smoothed_rate[i, k] != 0:
            return False
    for layer in range(s.state.shape[1]):
        current = s.state[i, layer]
        if s.waiting[i, layer] > 0 or p.markers[current] != p.markers[current + 1]:
            return False
    note_paces(p, s, out.work, i, dt)
    for layer in range(s.state.shape[1]):
        current = s.state[i, layer]
        time = s.time[i, layer] + dt * (speed_of(p, s, i, current) * out.work.pace[layer])
        if time >= p.duration[current] - NEARLY:
            return False
    for layer in range(s.state.shape[1]):
        before = s.time[i, layer]
        time = before + dt * (speed_of(p, s, i, s.state[i, layer]) * out.work.pace[layer])
        out.before[i, layer], out.reached[i, layer], out.wraps[i, layer] = before, time, 0
        s.time[i, layer], s.passed[i, layer] = time, time
        s.age[i, layer] += 1
    return True
