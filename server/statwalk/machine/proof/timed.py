"""`A leads to B within T`, and `from A, EVENT reaches B within T`: proved, refuted with a run that can be replayed, or undecided.

In the first, whatever comes from outside, one event a tick, B follows every entry of A in time; it counts as soon as it is entered. In
the second the event comes once, in any moment of A in which nothing waits, and after it nothing but what senses raise. Conditions, senses
and weights are free choices, and of what comes from outside at most one event waits. A column named after a marker comes with the marker
alone. Time counts in ticks of 1/60 s; what a tick cuts off a motion, a parameter or a blend leaves open is looked at from both sides.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from functools import cached_property
from typing import NamedTuple

from statwalk.errors import MachineError
from statwalk.machine.authored.definition import MachineDefinition
from statwalk.machine.built.build import build
from statwalk.machine.built.buildstates import MotionFacts
from statwalk.machine.built.runform import Machine
from statwalk.machine.proof.lengths import TICKS_PER_SECOND, Lengths, depends, lengths
from statwalk.machine.proof.moments import NOBODY, Node
from statwalk.machine.proof.search import TICK_WORK, Search, Step, TooManyError, Work, way
from statwalk.machine.proof.tick import Ticks
from statwalk.machine.proof.worded import Refuted, refuted, seconds

MOST_SECONDS = 600.0


class Question(NamedTuple):
    """Rows of the base from which and to which, the column of the event that comes (NOBODY: of entering), and ticks."""

    start: Collection[int]
    goals: Collection[int]
    event: int
    limit: int


class Answer(NamedTuple):
    """The longest it takes, ticks; and, where that is too long, a run of the actor from its beginning that shows it."""

    longest: float
    before: list[Step]
    """to the start"""
    after: list[Step]


class Timed:
    """A machine whose properties with a time are asked for, with its motions; what is found is kept."""

    def __init__(self, machine: Machine, motions: Mapping[str, MotionFacts]) -> None:
        self.machine, self.motions = machine, motions
        self.work = Work()

    @cached_property
    def paces(self) -> tuple[Pace, ...]:
        """The machine as slow as it can be, and, if that is not the same, as quick as it can be."""
        slow, quick = (lengths(self.machine, self.motions, is_slow) for is_slow in (True, False))
        return tuple(Pace(self.machine, one, self.work) for one in dict.fromkeys((slow, quick)))

    def answer(self, question: Question) -> str | Refuted:
        """`proved …` or `undecided: …`, or how it is refuted."""
        if question.limit > MOST_SECONDS * TICKS_PER_SECOND:
            return f"undecided: more than {MOST_SECONDS:g} s are not looked at"
        try:
            answers = [pace.answer(question) for pace in self.paces]
        except TooManyError:
            return "undecided: there are too many moments to look at; the motions are long, or the table is large"
        slow, quick = answers[0], answers[-1]
        if slow.longest <= question.limit:
            return f"proved (at most {seconds(slow.longest)})" if slow.longest >= 0 else "proved (it is never there)"
        if quick.longest > question.limit:
            return refuted(self.machine, question.goals, quick.before, quick.after)
        return f"undecided: it takes {seconds(quick.longest)} at the least, and at the most {seconds(slow.longest)}{self.reasons(slow)}"

    def reasons(self, answer: Answer) -> str:
        """What the states of a run depend on."""
        states = dict.fromkeys(step.node.state for step in answer.after)
        return "".join(f"; {why}" for state in states if (why := depends(self.machine, self.motions, state)))


class Pace:
    """A machine whose motions last so long."""

    def __init__(self, machine: Machine, motions_last: Lengths, work: Work) -> None:
        marked = {name for markers in machine.markers for name, _ in markers}
        world = {sense.event for sense in machine.senses} | {touch.event for touch in machine.touches}
        every = [event for name, event in machine.columns.items() if event in world or name not in marked]
        self.freely = Search(Ticks(machine, motions_last, patient=False), every, work)
        self.quietly = Search(Ticks(machine, motions_last, patient=True), sorted(world), work)
        self.begin = Node(machine.initial, 0)

    @cached_property
    def reached(self) -> dict[Node, tuple[Node, Step] | None]:
        """All that the actor can come to, whatever happens."""
        return self.freely.reached(self.begin)

    def entering(self, states: Collection[int]) -> Iterator[Run]:
        """Every tick in which one of the states is entered, by the time at which it can first come about."""
        if self.begin.state in states:
            yield Run(None, Step(NOBODY, self.begin, ((NOBODY, self.begin.state),)))
        for node in self.reached:
            yield from (Run(node, step) for step in self.freely.following(node) if step.enters(states))

    def pressing(self, states: Collection[int], event: int) -> Iterator[Run]:
        """Every tick in which the event can come in one of the states, while nothing waits."""
        for node in self.reached:
            if node.state in states and not node.queue:
                self.quietly.work.spend(TICK_WORK)
                yield from (Run(node, Step(event, now.node, now.changes)) for now in self.quietly.ticks.after(node, event))

    def answer(self, question: Question) -> Answer:
        """The longest it takes; -1 where it never begins."""
        start, goals, event, limit = question
        search = self.freely if event == NOBODY else self.quietly
        runs = list(self.entering(start) if event == NOBODY else self.pressing(start, event))
        values = search.longest([run.step.node for run in runs if not run.is_over(start, goals)], goals)
        lasting = [(0.0 if run.is_over(start, goals) else values[run.step.node], run) for run in runs]
        run = next((run for ticks, run in lasting if ticks > limit), None)
        longest = max((ticks for ticks, _ in lasting), default=-1.0)
        if run is None:
            return Answer(longest, [], [])
        before = [] if run.node is None else [*way(self.reached, run.node), run.step]
        return Answer(longest, before, search.beyond(run.step.node, goals, values, limit))


class Run(NamedTuple):
    """The tick from which the time counts."""

    node: Node | None
    """the actor before it; None: it is where all begins"""
    step: Step

    def is_over(self, start: Collection[int], goals: Collection[int]) -> bool:
        """Whether a goal is there in the same tick, no sooner than the start."""
        states = [state for _, state in self.step.changes]
        first = next((number for number, state in enumerate(states) if state in start), 0)
        return self.step.node.state in goals or any(state in goals for state in states[first:])


def timed(definition: MachineDefinition, motions: Mapping[str, MotionFacts] | None) -> Timed | str:
    """What answers questions about a machine; or why nothing can."""
    if motions is None:
        return "undecided: how long the motions last is not known here"
    try:
        return Timed(build(definition, motions), motions)
    except MachineError as error:
        return f"undecided: the machine cannot be built: {error.message}"
