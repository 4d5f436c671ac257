"""Explores all nodes of an actor: every tick is a run of `step_actor`, with what comes from outside, truths
and draws chosen freely.
"""

from __future__ import annotations

from numba import types

from statwalk.machine.compile.alternatives import BLANK, MIXED
from statwalk.machine.compile.program import PROGRAM, Program
from statwalk.machine.conditions.condition_values import UNKNOWN
from statwalk.machine.model_checker.found_ticks import EVERYTHING, PAUSED, TOO_MUCH, add_tick, room
from statwalk.machine.model_checker.guesses import guess_nothing, guess_otherwise, is_asked, make_known
from statwalk.machine.model_checker.node_rows import (
    NOW,
    put_in_place,
    read_node,
    write_node,
)
from statwalk.machine.model_checker.state_space import (
    GUESSES,
    IS_FIRST,
    MOST_WAITING,
    OF_EXPANDED,
    OF_NODES,
    OF_TAKEN,
    OF_TICKS,
    OF_WORK,
    QUEUE,
    STATE,
    STATE_SPACE,
    WAITING,
    Guesses,
    StateSpace,
)
from statwalk.machine.runtime.effects import EFFECTS, MachineEffects
from statwalk.machine.runtime.scratch import CHANGES, DRAWS, DT, TICK
from statwalk.machine.runtime.state import FOR_END, MachineState
from statwalk.machine.runtime.state import STATE as MACHINE
from statwalk.machine.runtime.step_actor import step_actor
from statwalk.machine.runtime.surroundings import INPUTS, SURROUNDINGS, Inputs, Measurements
from statwalk.maths.arrays import Ints
from statwalk.maths.compiling import kernel, read
from statwalk.maths.reference import by_reference, called

_PRESSES = read(types.int64, 1)


@called
def _add_ticks(
    p: Program,
    s: MachineState,
    around: Measurements,
    inputs: Inputs,
    out: MachineEffects,
    m: StateSpace,
    g: Guesses,
    row: int,
    ticks: int,
    most_work: int,
) -> int:
    """All ticks of a node in which an event comes (or nothing), whatever conditions and chance say.

    `ticks`: the first of the node.
    """
    press, is_first, height = inputs.event[0], m.node[row, IS_FIRST], 1
    if press >= 0 and not is_first and _means_nothing(p, m, row, press):
        return EVERYTHING
    guess_nothing(g)
    while height > 0:
        end = room(m, out)
        if end != EVERYTHING:
            return end
        m.counts[OF_WORK] += 1
        _run(p, s, around, inputs, out, m, g, row, height - 1)
        is_free = _is_free(p, out, g, height - 1)
        height = guess_otherwise(p, out, g, height - 1)
        waiting = s.waiting[0, 0]
        if height < 0 or m.counts[OF_WORK] > most_work or (press < 0 and waiting > MOST_WAITING):
            return TOO_MUCH
        if press < 0 or waiting <= max(m.node[row, WAITING], 1):
            write_node(s, out.work.scratch[CHANGES], g.now)
            add_tick(m, out, g.now, row, ticks, press, is_free)
    return EVERYTHING


@called
def _means_nothing(p: Program, m: StateSpace, row: int, press: int) -> bool:
    """Whether an event is sure to be dropped: it means nothing in the state, which nothing can change before
    it is looked up.
    """
    state = m.node[row, STATE]
    target = p.target[state, press]
    if target >= 0 or target == MIXED or (target == BLANK and p.buffer[press] > 0):
        return False
    for slot in range(m.node[row, WAITING]):
        if m.node[row, QUEUE + 3 * slot + 1] != FOR_END:
            return False
    for marker in range(p.markers[state], p.markers[state + 1]):  # noqa: SIM110 - kernels know no generators
        if p.marker_event[marker] >= 0:
            return False
    return True


@called
def _run(
    p: Program,
    s: MachineState,
    around: Measurements,
    inputs: Inputs,
    out: MachineEffects,
    m: StateSpace,
    g: Guesses,
    row: int,
    guess: int,
) -> None:
    """A tick of the actor."""
    read_node(m, row, s)
    make_known(g, guess, out)
    for kind in range(out.counts.shape[0]):
        out.counts[kind] = 0
    out.work.scratch[CHANGES], out.work.scratch[DRAWS] = 0, 0
    step_actor(p, s, around, inputs, out, 0, 0, 1 if inputs.event[0] >= 0 else 0)


@called
def _is_free(p: Program, out: MachineEffects, g: Guesses, guess: int) -> bool:
    """Whether conditions or chance have decided something."""
    if out.work.scratch[DRAWS] > 0:
        return True
    for condition in range(g.truths.shape[1]):
        if g.truths[guess, condition] != UNKNOWN or is_asked(p, out, g, guess, condition):
            return True
    return False


@kernel(
    PROGRAM,
    MACHINE,
    SURROUNDINGS,
    INPUTS,
    EFFECTS,
    STATE_SPACE,
    GUESSES,
    _PRESSES,
    _PRESSES,
    types.int64,
    types.int64,
    returns=types.int64,
)
def explore(
    p: Program,
    s: MachineState,
    around: Measurements,
    inputs: Inputs,
    out: MachineEffects,
    m: StateSpace,
    g: Guesses,
    first: Ints,
    presses: Ints,
    most_work: int,
    pause: int,
) -> int:
    """Adds all ticks of all nodes, and the nodes that they lead to; after `pause` units of work it returns,
    and the next call goes on.

    In each one of `presses` comes; where IS_FIRST one of `first`.
    """
    program, state, surroundings, given = (
        by_reference(p),
        by_reference(s),
        by_reference(around),
        by_reference(inputs),
    )
    effects, space, guesses = by_reference(out), by_reference(m), by_reference(g)
    out.work.scratch[TICK], out.work.clock[DT] = NOW, 1.0
    put_in_place(space, g.now)
    until = m.counts[OF_WORK] + pause
    while m.counts[OF_EXPANDED] < m.counts[OF_NODES]:
        row, ticks, taken = m.counts[OF_EXPANDED], m.counts[OF_TICKS], m.counts[OF_TAKEN]
        is_first = m.node[row, IS_FIRST]
        for k in range(first.shape[0] if is_first else presses.shape[0]):
            inputs.event[0] = first[k] if is_first else presses[k]
            end = _add_ticks(
                program, state, surroundings, given, effects, space, guesses, row, ticks, most_work
            )
            if end != EVERYTHING:
                m.counts[OF_TICKS], m.counts[OF_TAKEN] = ticks, taken
                return end
        m.counts[OF_EXPANDED] = row + 1
        if m.counts[OF_WORK] > until:
            return PAUSED
    return EVERYTHING
