"""The ticks before and after the tick of a question in which the event would have fired."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from statwalk.character.role import Role
from statwalk.machine.runtime.reasons import TAKEN
from statwalk.stage.effects.words import lines
from statwalk.stage.explain.counterfactual import Budget
from statwalk.stage.explain.past_states import PastStates
from statwalk.stage.state.cast import Cast
from statwalk.stage.state.commands import Edit, Press
from statwalk.stage.state.stage_state import StageState
from statwalk.stage.steps.input_batch import input_batch
from statwalk.stage.steps.memory import Memory
from statwalk.stage.tick import decide

AFTER_SHARE = 0.5
"""share of the budget that may be spent on ticks after the tick of the question"""


def moments(past: PastStates, event: str, budget: Budget) -> Iterator[int]:
    """Yields the last tick before the tick of the question, and the first tick after it, in which the event
    would fire; each only if it exists.
    """
    probe = Probe(past, event)
    for tick in range(past.tick - 1, past.first, -1):
        if probe.fires(past.look_at(tick - 1)):
            yield tick
            break
    state = past.at(past.tick - 1)
    for _ in budget.watch("moment", AFTER_SHARE):
        state, _ = past.stage.after(state)
        if probe.fires(state):
            past.keep(state)
            yield state.tick + 1
            return


class Probe:
    """Sends an event to an actor's machine in many ticks and reads the verdict; poses are not computed."""

    def __init__(self, past: PastStates, event: str) -> None:
        self.stage, self.actor, self.event = past.stage, past.actor, event
        self.memories: dict[Role, Memory] = {}

    def fires(self, state: StageState) -> bool:
        """Returns whether the event, sent in the tick after a state, fires in that tick."""
        place = state.find(self.actor)
        if place is None:
            return False
        key, row = place
        role = self.stage.roles[key]
        if self.event not in role.machine.events:
            return False
        cast = Cast.of(role, state.casts[key].take(np.array([row])))
        own = [
            command
            for command in self.stage.commands(state.tick + 1)
            if not isinstance(command, Edit) and command.actor == self.actor
        ]
        sent = [Press(self.actor, self.event)] if self.event in role.machine.events[:-1] else []
        dt = 1 / self.stage.rate
        batch = input_batch(cast, state.inbox, [*own, *sent], dt)
        if role not in self.memories:
            self.memories[role] = Memory(role, 1)
        result = decide(batch.cast, self.memories[role], batch.inputs, dt, state.tick + 1, self.stage.seed)
        column = role.machine.events.index(self.event)
        return any((line.event, line.verdict) == (column, TAKEN) for line in lines(result.verdicts))
