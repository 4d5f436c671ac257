"""When else: the ticks before and after one in which an event would have fired, had it been sent then."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from statwalk.machine.ticking.step import step
from statwalk.stage.explaining.trying import longest
from statwalk.stage.fold import StageState
from statwalk.stage.given import given
from statwalk.stage.moving.surroundings import surroundings
from statwalk.stage.past.log import LogEntry
from statwalk.stage.stage import Stage

EARLIEST_S = 1.0
"""seconds before the tick in question that are looked at"""


def moments(stage: Stage, actor: int, event: str, tick: int) -> Iterator[int]:
    """The last tick before `tick`, and the first after it, in which the event fires when it is sent, if there are any."""
    state = stage.state_at(max(tick - 1 - round(EARLIEST_S * stage.rate), 0))
    before: list[StageState] = []
    while state.tick < tick - 1:
        before.append(state)
        state = stage.after(state)
    for one in reversed(before):
        if fires(stage, one, actor, event):
            yield one.tick + 1
            break
    for _ in range(longest(stage, state)):
        state = stage.after(state)
        if fires(stage, state, actor, event):
            yield state.tick + 1
            return


def fires(stage: Stage, state: StageState, actor: int, event: str) -> bool:
    """Whether the event, sent in the tick that follows a state, fires in it; only the actor's own machine is stepped."""
    found = state.find(actor)
    if found is None:
        return False
    cast, row = found
    own = [entry for entry in stage.entries(state.tick + 1) if entry.actor == actor]
    press = [LogEntry(state.tick + 1, "press", actor, event)] if event in cast.role.machine.events[:-1] else []
    dt = 1 / stage.rate
    told = given(cast.take(np.array([row])), state.raised, [*own, *press], dt)
    machine = told.cast.role.machine
    done = step(machine, told.cast.machine, dt, state.tick + 1, told.inputs, surroundings(told.cast, dt, stage.seed))
    return any(machine.events[one.event] == event and one.verdict == "taken" for one in done.verdicts)
