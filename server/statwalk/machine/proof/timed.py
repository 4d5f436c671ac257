"""`A leads to B within T`, and `from A, EVENT reaches B within T`: proved, refuted with a run that can be replayed, or undecided.

In the first, whatever comes from outside at whatever tick, B follows every entry of A in time. In the second the event comes once, at
any moment of A with nothing waiting, and after it nothing but what senses raise. Conditions, senses and weights are free choices, and
at most one event waits. A column named after a marker comes with the marker alone. Time counts in ticks of 1/60 s.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from functools import cached_property
from typing import NamedTuple

from statwalk.errors import MachineError
from statwalk.machine.build import build
from statwalk.machine.buildstates import MotionFacts
from statwalk.machine.definition import MachineDefinition
from statwalk.machine.proof.lengths import TICKS_PER_SECOND, Lengths, depends, lengths
from statwalk.machine.proof.moments import EARLIER, NOBODY, Node
from statwalk.machine.proof.search import Search, Step, TooManyError, way
from statwalk.machine.proof.tick import Ticks
from statwalk.machine.proof.worded import Refuted, refuted, seconds
from statwalk.machine.runform import Machine

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

    @cached_property
    def paces(self) -> tuple[Pace, ...]:
        """The machine as slow as it can be, and, if that is not the same, as quick as it can be."""
        slow, quick = (lengths(self.machine, self.motions, is_slow) for is_slow in (True, False))
        return tuple(Pace(self.machine, one) for one in dict.fromkeys((slow, quick)))

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

    def __init__(self, machine: Machine, motions_last: Lengths) -> None:
        marked = {name for markers in machine.markers for name, _ in markers}
        world = {sense.event for sense in machine.senses} | {touch.event for touch in machine.touches}
        every = [event for name, event in machine.columns.items() if event in world or name not in marked]
        self.freely = Search(Ticks(machine, motions_last, patient=False), every)
        self.quietly = Search(Ticks(machine, motions_last, patient=True), sorted(world))
        self.begin = Node(machine.initial, 0)

    @cached_property
    def reached(self) -> dict[Node, tuple[Node, Step] | None]:
        """All that the actor can come to, whatever happens."""
        return self.freely.reached(self.begin)

    def answer(self, question: Question) -> Answer:
        """The longest it takes; -1 where it never begins."""
        if question.event == NOBODY:
            runs = [(node, Step(NOBODY, node, NOBODY)) for node in self.reached if node.begun != EARLIER and node.state in question.start]
            search = self.freely
        else:
            search, here = self.quietly, [one for one in self.reached if one.state in question.start and not one.queue]
            runs = [(node, step) for node in here for step in search.after(node, question.event)]
        values = search.longest([step.node for _, step in runs], question.goals)
        longest = max((values.get(step.node, 0.0) for _, step in runs), default=-1.0)
        if longest <= question.limit:
            return Answer(longest, [], [])
        node, step = next(one for one in runs if values.get(one[1].node, 0.0) > question.limit)
        before = [*way(self.reached, node), *([step] if question.event != NOBODY else [])]
        return Answer(longest, before, search.beyond(step.node, question.goals, values, question.limit))


def timed(definition: MachineDefinition, motions: Mapping[str, MotionFacts] | None) -> Timed | str:
    """What answers questions about a machine; or why nothing can."""
    if motions is None:
        return "undecided: how long the motions last is not known here"
    try:
        return Timed(build(definition, motions), motions)
    except MachineError as error:
        return f"undecided: the machine cannot be built: {error.message}"
