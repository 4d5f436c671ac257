"""One tick of N machines: motions advance, events are looked up, actions are output.

Implements "One tick" of the specification.
"""

from __future__ import annotations

from statwalk.machine.compile.program import Program
from statwalk.machine.conditions.condition_values import forget_truths
from statwalk.machine.runtime.effects import MOST_CHANGES, OF_VALUES, OF_VERDICTS, MachineEffects
from statwalk.machine.runtime.idle_step import passes_quietly
from statwalk.machine.runtime.scratch import DT, TICK
from statwalk.machine.runtime.state import MOST_WAITING, MachineState
from statwalk.machine.runtime.step_actor import step_actor
from statwalk.machine.runtime.surroundings import Inputs, Measurements
from statwalk.maths.reference import called


@called
def _most_verdicts(p: Program) -> int:
    """Returns an upper bound for the verdicts of an actor without inputs in a tick; it also bounds changes
    and actions.
    """
    markers = 0
    for state in range(p.target.shape[0]):
        markers = max(markers, p.markers[state + 1] - p.markers[state])
    handled = 2 * MOST_WAITING + 2 * markers + p.sense_event.shape[0] + 2
    return int(p.initials.shape[0] * (2 * handled + (MOST_CHANGES + 2) * (p.target.shape[1] + MOST_WAITING)))


@called
def step_from(
    program: Program,
    state: MachineState,
    around: Measurements,
    inputs: Inputs,
    effects: MachineEffects,
    tick: int,
    dt: float,
    row: int,
) -> int:
    """Steps the actors from `row` on; returns the row of the first actor that was not stepped, because its
    effects might not fit. The caller goes on from there with `doubled` effects.
    """
    effects.work.scratch[TICK], effects.work.clock[DT] = tick, dt
    if row == 0:
        for kind in range(4):
            effects.counts[kind] = 0
    next_input, most, layers, variables = (
        0,
        _most_verdicts(program),
        state.state.shape[1],
        program.variable_kind.shape[0],
    )
    while next_input < inputs.actor.shape[0] and inputs.actor[next_input] < row:
        next_input += 1
    for i in range(row, state.state.shape[0]):
        first = next_input
        while next_input < inputs.actor.shape[0] and inputs.actor[next_input] == i:
            next_input += 1
        if next_input == first and passes_quietly(program, state, effects, i, dt):
            continue
        need, counts = most + 2 * (next_input - first) * layers, effects.counts
        if (
            effects.verdicts.shape[0] - counts[OF_VERDICTS] < need
            or effects.value.shape[0] - counts[OF_VALUES] < need * variables
        ):
            return i
        forget_truths(effects.work.conditions)
        step_actor(program, state, around, inputs, effects, i, first, next_input)
    return int(state.state.shape[0])
