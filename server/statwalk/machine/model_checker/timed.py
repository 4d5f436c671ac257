"""`A leads to B within T`, and `from A, EVENT reaches B within T`: proved, refuted with a run that can be
replayed, or undecided.

In the first, whatever comes from outside, one event a tick, B follows every entry of A in time; it counts as
soon as it is entered. In the second the event comes once, in any node of A in which nothing waits, and
after it nothing but what senses raise. Conditions, senses and weights are free choices, and of what comes
from outside at most one event waits. A column named after a marker comes with the marker alone. Time counts
in ticks of 1/60 s; what a tick cuts off a motion, a parameter or a blend leaves open is looked at from both
sides. What is refuted fails with the parameters' defaults, so that its run goes so on a new stage.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from functools import cached_property
from typing import NamedTuple

import numpy as np

from statwalk.errors import MachineError
from statwalk.machine.compile.machine import Machine
from statwalk.machine.compile.resolved_table import Motions
from statwalk.machine.model_checker.counterexample import Refuted, refuted, seconds, shown
from statwalk.machine.model_checker.lengths import TICKS_PER_SECOND, Lengths, depends, lengths
from statwalk.machine.model_checker.program_in_ticks import program_in_ticks
from statwalk.machine.model_checker.search import Search, SearchStep, beginning, searched
from statwalk.machine.model_checker.state_space import IS_FIRST, NOTHING, STATE, WAITING
from statwalk.machine.model_checker.work import RUN_STEP_WORK, TooManyError, Work
from statwalk.maths.arrays import Floats

MOST_SECONDS = 600.0


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


class Timed:
    """A machine whose properties with a time are asked for; what is found is kept."""

    def __init__(self, machine: Machine, work: Work) -> None:
        self.machine, self.work = machine, work
        self._made: dict[Lengths, Pace] = {}

    @cached_property
    def paces(self) -> tuple[Pace, ...]:
        """The machine as slow as it can be, and, if that is not the same, as quick as it can be."""
        return self._paces(as_set=False)

    @cached_property
    def paces_as_set(self) -> tuple[Pace, ...]:
        """The same while all parameters have their defaults, as on a new stage."""
        return self._paces(as_set=True)

    def _paces(self, as_set: bool) -> tuple[Pace, ...]:
        found = dict.fromkeys(lengths(self.machine, is_slow, as_set) for is_slow in (True, False))
        for one in found:
            self._made.setdefault(one, Pace(self.machine, one, self.work))
        return tuple(self._made[one] for one in found)

    def answer(self, question: TimedQuestion) -> str | Refuted:
        """`proved …` or `undecided: …`, or how it is refuted."""
        if question.limit > MOST_SECONDS * TICKS_PER_SECOND:
            return f"undecided: more than {MOST_SECONDS:g} s are not looked at"
        try:
            self.work.begin()
            answers = {pace: pace.answer(question) for pace in self.paces}
            by_length = sorted(answers.values(), key=lambda one: one.longest)
            least, most = by_length[0], by_length[-1]
            if most.longest < 0:
                return "proved (it is never there)"
            if most.longest <= question.limit:
                return f"proved (at most {seconds(most.longest)})"
            as_set = [answers.get(pace) or pace.answer(question) for pace in self.paces_as_set]
        except TooManyError as error:
            return str(error)
        if all(one.longest > question.limit for one in as_set):
            return refuted(self.machine, question.goals, as_set[-1].before, as_set[-1].after)
        return (
            f"undecided: it takes {seconds(least.longest)} at the least, and at the most "
            f"{seconds(most.longest)}{self.reasons(most)}"
        )

    def never(self, here: Collection[int], there: Collection[int]) -> str | Refuted:
        """Whether an event that is taken in one of the states `here` never leads to one of `there`."""

        def shortest(search: Search) -> list[int] | None:
            taken = search.space.taken
            to = np.where(taken[:, 2] < 0, taken[:, 1], taken[:, 2])
            every = np.ones(len(search.start), bool)
            return search.shortest(
                search.ticks_of(np.isin(taken[:, 1], list(here)) & np.isin(to, list(there))), every
            )

        return self._untimed(shortest)

    def only_after(self, goals: Collection[int], gates: Collection[int]) -> str | Refuted:
        """Whether every goal comes after a gate."""

        def shortest(search: Search) -> list[int] | None:
            shut = [gate for gate in gates if gate not in goals]
            if search.states[0] in goals:
                return []
            return search.shortest(search.entering_before(goals, shut), ~search.entering(shut))

        return self._untimed(shortest)

    def _untimed(self, shortest: Callable[[Search], list[int] | None]) -> str | Refuted:
        try:
            self.work.begin()
            paces = tuple(dict.fromkeys((*self.paces_as_set, *self.paces)))
            for pace in paces:
                ticks = shortest(pace.freely)
                self.work.spend(pace.freely.work)
                if ticks is not None:
                    return shown(self.machine, _steps(pace.freely, ticks))
        except TooManyError as error:
            return str(error)
        if len(paces) == 1:
            return "proved (the motions leave no time for it)"
        return "undecided: neither the slowest nor the quickest motions show it"

    def reasons(self, answer: TimedAnswer) -> str:
        """What the states of a run depend on."""
        entered = (state for step in answer.before[-1:] + answer.after for _, state in step.changes)
        states = dict.fromkeys(entered if answer.before else (self.machine.initial, *entered))
        return "".join(f"; {why}" for state in states if (why := depends(self.machine, state)))


class Pace:
    """A machine whose motions last so long."""

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
        return TimedAnswer(most, _steps(search, before), after)

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
        before = _steps(self.freely, self.freely.way(int(rows[search.start[tick]])))
        after = self._beyond(search, int(search.end[tick]), question, values)
        return TimedAnswer(most, (*before, search.step(tick)), after)

    def _longest(self, search: Search, goals: Collection[int]) -> Floats:
        self.work.spend(search.work)
        return search.longest(goals)

    def _beyond(
        self, search: Search, node: int, question: TimedQuestion, values: Floats
    ) -> tuple[SearchStep, ...]:
        self.work.spend(question.limit * RUN_STEP_WORK)
        return _steps(search, search.beyond(node, question.goals, values, question.limit))


def _lasting(search: Search, question: TimedQuestion, values: Floats) -> Floats:
    """(T,) how long it takes after each tick: 0 where a goal is there in the same tick, no sooner than the
    start.
    """
    is_over = np.isin(search.states[search.end], list(question.goals)) | search.entering_after(
        question.goals, question.start
    )
    return np.where(is_over, 0.0, values[search.end])


def _steps(search: Search, ticks: Sequence[int]) -> tuple[SearchStep, ...]:
    # a run that goes round passes the same few ticks many times
    step_of = {tick: search.step(tick) for tick in dict.fromkeys(ticks)}
    return tuple(step_of[tick] for tick in ticks)


def timed(compiled: Callable[[], Machine], motions: Motions, work: Work) -> Timed | str:
    """What answers questions about the machine that `compiled` returns; or why nothing can."""
    if motions is None:
        return "undecided: how long the motions last is not known here"
    try:
        return Timed(compiled(), work)
    except MachineError as error:
        return f"undecided: the machine cannot be built: {error.message}"
