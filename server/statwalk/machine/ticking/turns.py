"""The turns of all who have something to decide: out of the arrays of a batch, one for all who are alike, and back into the arrays."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.built.runform import Machine
from statwalk.machine.ticking.advance import Advance
from statwalk.machine.ticking.alike import At, Members, alike
from statwalk.machine.ticking.asking import Answers
from statwalk.machine.ticking.given import Given
from statwalk.machine.ticking.moments import crossed
from statwalk.machine.ticking.record import Record, Waiting
from statwalk.machine.ticking.state import OWED, MachineState
from statwalk.machine.ticking.turn import Turn
from statwalk.maths.arrays import Bools, Floats


@dataclass(eq=False)
class Batch:
    """N actors in a tick."""

    machine: Machine
    state: MachineState
    """at the tick before, with parameters as smoothed by now"""
    moved: Advance
    measured: Floats
    """(3, N) see `Surroundings`"""
    key: NDArray[np.uint64]
    """(N,)"""
    tick: int
    dt: float


class Turns:
    """The turns of some actors in some layers, taken one for all who are alike."""

    def __init__(self, batch: Batch, some: Bools, given: Given) -> None:
        """`some` (N, L)."""
        self.batch, self.given = batch, given
        actors, layers = some.nonzero()
        self.at: At = (actors, layers)
        self.index = np.zeros(len(self.at[0]), np.intp)
        self.answers = [self._answers(layer) for layer in range(len(batch.machine.layers))]
        self.taken: list[Turn] = []
        self.members: list[Members] = []
        """for each turn that was taken, all those (places in `at`) for whom it counts"""
        groups = alike(batch.machine, batch.state, batch.moved, batch.tick, given, self.at)
        while groups:
            groups = self._take(groups)

    def _answers(self, layer: int) -> Answers:
        """What conditions say in a layer; keeps each turn's place among its actors."""
        batch, there = self.batch, np.flatnonzero(self.at[1] == layer)
        self.index[there] = np.arange(len(there))
        return Answers(batch.machine, batch.state, batch.measured, batch.dt, layer, self.at[0][there])

    def _take(self, groups: list[Members]) -> list[Members]:
        """The first of each group takes its turn; those for whom it would go another way come back as groups of their own."""
        rest: list[Members] = []
        for turn, members in zip(self._begun(np.array([group[0] for group in groups])), groups, strict=True):
            turn.run(self.given.sensed_by(turn.actor), self.given.inputs_of(turn.actor))
            same = members if len(members) == 1 else self._same(turn, members, rest)
            self.taken.append(turn)
            self.members.append(same)
        return rest

    def _same(self, turn: Turn, members: Members, rest: list[Members]) -> Members:
        """Those of whom all that the turn has asked says the same as of its actor; the others go to `rest`."""
        if turn.personal:
            rest += list(members[1:].reshape(-1, 1))
            return members[:1]
        agree = np.ones(len(members), bool)
        for condition, answer in turn.questions:
            agree &= turn.answers.truths(condition)[self.index[members]] == answer
        if not agree.all():
            rest.append(members[~agree])
        return members[agree]

    def _begun(self, which: Members) -> list[Turn]:
        """Turns, before they are run."""
        batch, at = self.batch, (self.at[0][which], self.at[1][which])
        machine, state, moved = batch.machine, batch.state, batch.moved
        columns = (
            *(part.tolist() for part in (*at, self.index[which], batch.key[at[0]])),
            *(part[at].tolist() for part in (state.state, moved.time, state.passed, moved.wraps)),
            self._crossed(at),
            *(part.tolist() for part in (moved.ended[at], moved.at_end[at], state.ended[at] == OWED)),
            queues_of(state, at),
            *(part[at[0]].tolist() for part in (state.held, state.last, state.goal)),
        )
        return [
            Turn(machine, Record(), self.answers[layer], batch.tick, batch.dt, actor, layer, *others)
            for actor, layer, *others in zip(*columns, strict=True)
        ]

    def _crossed(self, at: At) -> list[tuple[str, ...]]:
        """The markers that each motion has crossed."""
        machine, state, moved = self.batch.machine, self.batch.state, self.batch.moved
        if not any(machine.markers):
            return [()] * len(at[0])
        here = state.state[at]
        columns = (here, machine.duration[here], state.passed[at], moved.time[at], moved.wraps[at])
        return [crossed(machine.markers[one], *others) for one, *others in zip(*(column.tolist() for column in columns), strict=True)]


def queues_of(state: MachineState, at: At) -> list[list[Waiting]]:
    """What waits for each turn, by arrival."""
    event = state.waiting_event[at]
    queues: list[list[Waiting]] = [[] for _ in event]
    for row in np.flatnonzero(event[:, 0] >= 0).tolist():
        where = at[0][row], at[1][row]
        parts = (state.waiting_event, state.waiting_until, state.waiting_held, state.waiting_other)
        entries = enumerate(zip(*(part[where].tolist() for part in parts), strict=True))
        queues[row] = [Waiting(one, until, held, other, slot, until) for slot, (one, until, held, other) in entries if one >= 0]
    return queues
