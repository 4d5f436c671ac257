"""Searches all runs of a machine whose motions have given lengths, for the run that answers a question."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from functools import cached_property
from typing import NamedTuple

import numpy as np

from statwalk.machine.compile.machine import Machine
from statwalk.machine.model_checker.lengths import Lengths
from statwalk.machine.model_checker.program_in_ticks import program_in_ticks
from statwalk.machine.model_checker.search import Search, SearchStep, beginning, searched
from statwalk.machine.model_checker.state_space import IS_FIRST, NOTHING, STATE, WAITING
from statwalk.machine.model_checker.work import RUN_STEP_WORK, Work
from statwalk.maths.arrays import Floats


class TimedQuestion(NamedTuple):
    """Rows of the base from which and to which, the column of the event that comes (NOTHING: of entering),
    and ticks.
    """

    start: Collection[int]
    goals: Collection[int]
    event: int
    limit: int


class TimedAnswer(NamedTuple):
    """The longest it takes, ticks; and, where that is too long, a run of the actor from its beginning that
    shows it.
    """

    longest: float
    before: tuple[SearchStep, ...] = ()
    """to the start"""
    after: tuple[SearchStep, ...] = ()

    @property
    def steps(self) -> tuple[SearchStep, ...]:
        """The whole run."""
        return (*self.before, *self.after)


class Pace:
    """Searches all runs of a machine whose motions have these lengths."""

    def __init__(self, machine: Machine, motions_last: Lengths, work: Work) -> None:
        marked = {name for markers in machine.markers for name, _ in markers}
        self.world = sorted(
            {sense.event for sense in machine.senses} | {touch.event for touch in machine.touches}
        )
        self.every = [
            event for name, event in machine.columns.items() if event in self.world or name not in marked
        ]
        self.machine, self.lengths, self.work = machine, motions_last, work

    @cached_property
    def freely(self) -> Search:
        """Returns the search over all events, truths and draws; an event that waits in a blank cell may also
        come later, so it does not wait here.
        """
        program = program_in_ticks(self.machine, self.lengths, is_patient=False)
        return searched(program, beginning(program), (), self.every, self.work)

    def answer(self, question: TimedQuestion) -> TimedAnswer:
        """The longest it takes; -1 where it never begins."""
        return self._entering(question) if question.event == NOTHING else self._pressing(question)

    def _entering(self, question: TimedQuestion) -> TimedAnswer:
        """From every tick in which the start is entered."""
        start, goals, _, limit = question
        search, values = self.freely, self._longest(self.freely, goals)
        lasting = _lasting(search, question, values)
        ticks = np.flatnonzero(search.entering(start))
        most = lasting[ticks].max(initial=-1)
        if search.states[0] in start:
            at_once = 0.0 if search.states[0] in goals else float(values[0])
            most = max(most, at_once)
            if at_once > limit:
                return TimedAnswer(most, (), self._beyond(search, 0, question, values))
        if most <= limit:
            return TimedAnswer(most)
        tick = int(ticks[lasting[ticks] > limit][0])
        before = [*search.way(int(search.start[tick])), tick]
        after = self._beyond(search, int(search.end[tick]), question, values)
        return TimedAnswer(most, steps_of(search, before), after)

    def _pressing(self, question: TimedQuestion) -> TimedAnswer:
        """From every tick in which the event can come in the start, while nothing waits; after it only the
        world has a say.
        """
        start, goals, event, limit = question
        nodes = self.freely.space.node
        rows = np.flatnonzero(np.isin(nodes[:, STATE], list(start)) & (nodes[:, WAITING] == 0))
        if not len(rows):
            return TimedAnswer(-1)
        starts = nodes[rows]
        starts[:, IS_FIRST] = 1
        program = program_in_ticks(self.machine, self.lengths, is_patient=True)
        search = searched(program, starts, (event,), self.world, self.work)
        values = self._longest(search, goals)
        lasting = _lasting(search, question, values)[: search.first_tick[len(rows)]]
        most = lasting.max(initial=-1)
        if most <= limit:
            return TimedAnswer(most)
        tick = int(np.flatnonzero(lasting > limit)[0])
        before = steps_of(self.freely, self.freely.way(int(rows[search.start[tick]])))
        after = self._beyond(search, int(search.end[tick]), question, values)
        return TimedAnswer(most, (*before, search.step(tick)), after)

    def _longest(self, search: Search, goals: Collection[int]) -> Floats:
        self.work.spend(search.work)
        return search.longest(goals)

    def _beyond(
        self, search: Search, node: int, question: TimedQuestion, values: Floats
    ) -> tuple[SearchStep, ...]:
        self.work.spend(question.limit * RUN_STEP_WORK)
        return steps_of(search, search.beyond(node, question.goals, values, question.limit))


def _lasting(search: Search, question: TimedQuestion, values: Floats) -> Floats:
    """(T,) how long it takes after each tick: 0 where a goal is there in the same tick, no sooner than the
    start.
    """
    is_over = np.isin(search.states[search.end], list(question.goals)) | search.entering_after(
        question.goals, question.start
    )
    return np.where(is_over, 0.0, values[search.end])


def steps_of(search: Search, ticks: Sequence[int]) -> tuple[SearchStep, ...]:
    """The ticks of a search in a form to be told."""
    # a run that goes round passes the same few ticks many times
    step_of = {tick: search.step(tick) for tick in dict.fromkeys(ticks)}
    return tuple(step_of[tick] for tick in ticks)
