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

from collections.abc import Callable, Collection, Iterable
from functools import cached_property

from statwalk.errors import MachineError
from statwalk.machine.compile.machine import Machine
from statwalk.machine.compile.resolved_table import Motions
from statwalk.machine.model_checker.broken import entered_before, late, leading
from statwalk.machine.model_checker.counterexample import Refuted, refuted, seconds, shown
from statwalk.machine.model_checker.lengths import TICKS_PER_SECOND, Lengths, depends, lengths
from statwalk.machine.model_checker.played import MOST_TICKS, Candidate, Life, Play, Player, Told
from statwalk.machine.model_checker.search_at_pace import Pace, TimedAnswer, TimedQuestion
from statwalk.machine.model_checker.work import TooManyError, Work

MOST_SECONDS = 600.0


class Timed:
    """A machine whose properties with a time are asked for; what is found is kept."""

    def __init__(self, machine: Machine, work: Work, play: Play | None = None) -> None:
        self.machine, self.work, self.play = machine, work, play
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
        return tuple(map(self._at, found))

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
            as_set = {pace: answers.get(pace) or pace.answer(question) for pace in self.paces_as_set}
            found = self._played([*as_set, *answers], *late(self.machine, question))
        except TooManyError as error:
            return str(error)
        if found is not None:
            return found
        if all(one.longest > question.limit for one in as_set.values()):
            quickest = list(as_set.values())[-1]
            run = refuted(self.machine, question.goals, quickest.before, quickest.after)
            return self._unplayed(run, quickest.steps)
        return (
            f"undecided: it takes {seconds(least.longest)} at the least, and at the most "
            f"{seconds(most.longest)}{self.reasons(most)}"
        )

    def never(self, here: Collection[int], there: Collection[int]) -> str | Refuted:
        """Whether an event that is taken in one of the states `here` never leads to one of `there`."""
        return self._untimed(*leading(self.machine, here, there))

    def only_after(self, goals: Collection[int], gates: Collection[int]) -> str | Refuted:
        """Whether every goal comes after a gate."""
        return self._untimed(*entered_before(self.machine, goals, gates))

    def _untimed(self, candidate: Candidate, told: Told) -> str | Refuted:
        try:
            self.work.begin()
            paces = list(dict.fromkeys((*self.paces_as_set, *self.paces)))
            expected = next((steps for pace in paces if (steps := candidate(pace)) is not None), None)
            if expected is not None:
                found = self._played(paces, candidate, told)
                return found or self._unplayed(shown(self.machine, expected), expected)
        except TooManyError as error:
            return str(error)
        if len(paces) == 1:
            return "proved (the motions leave no time for it)"
        return "undecided: neither the slowest nor the quickest motions show it"

    def _played(self, paces: Iterable[Pace], candidate: Candidate, told: Told) -> Refuted | None:
        """The counterexample that a stage shows, if there is a stage."""
        if self.play is None:
            return None
        player = Player(self.machine, self.play, self._at, candidate, told)
        return next((found for pace in dict.fromkeys(paces) if (found := player.found(pace))), None)

    def _unplayed(self, found: Refuted, steps: Life) -> Refuted | str:
        """The answer where no stage shows a counterexample."""
        if self.play is None or len(steps) > MOST_TICKS or not steps:
            return found
        if any(step.is_free for step in steps):
            return Refuted(f"{found.message}; on a new stage they will not", (), 0)
        run = found.message.partition(": ")[2]
        return f"undecided: on a new stage the motions last otherwise than in {run}"

    def _at(self, motions_last: Lengths) -> Pace:
        if motions_last not in self._made:
            self._made[motions_last] = Pace(self.machine, motions_last, self.work)
        return self._made[motions_last]

    def reasons(self, answer: TimedAnswer) -> str:
        """What the states of a run depend on."""
        entered = (state for step in answer.before[-1:] + answer.after for _, state in step.changes)
        states = dict.fromkeys(entered if answer.before else (self.machine.initial, *entered))
        return "".join(f"; {why}" for state in states if (why := depends(self.machine, state)))


def timed(
    compiled: Callable[[], Machine], motions: Motions, work: Work, play: Play | None = None
) -> Timed | str:
    """What answers questions about the machine that `compiled` returns; or why nothing can. `play` plays what
    refutes them.
    """
    if motions is None:
        return "undecided: how long the motions last is not known here"
    try:
        return Timed(compiled(), work, play)
    except MachineError as error:
        return f"undecided: the machine cannot be built: {error.message}"
