"""Counterexamples played on a stage: the search takes motions to last as long as they may, a stage knows how
long they last. Where the two part, the search is made again with the motion as long as on the stage.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from statwalk.machine.compile.machine import Machine
from statwalk.machine.model_checker.counterexample import Refuted, inputs
from statwalk.machine.model_checker.lengths import Lengths
from statwalk.machine.model_checker.search import SearchStep, Taken
from statwalk.machine.model_checker.search_at_pace import Pace
from statwalk.machine.model_checker.state_space import NOTHING

Inputs = Sequence[tuple[int, str]]
Play = Callable[[Inputs, int], Sequence[Sequence[tuple[str, str, str]]]]
"""plays (tick, event) inputs on a fresh stage for so many ticks; returns event, state and new state
(empty: it stays) of what the base layer takes in each tick
"""
Life = tuple[SearchStep, ...]
Candidate = Callable[[Pace], Life | None]
"""the run that refutes a property while the motions last so long, None where none does"""
Told = Callable[[Life], Refuted | None]
"""the counterexample in a life, None where the life does not break the property"""
MOST_TICKS = 3600
"""a longer run is not played"""
AFTERWARDS = 90
"""ticks that are played beyond a run, to see when a motion ends that lasts longer than expected"""
ROUNDS = 8
"""searches for one counterexample"""


class Player:
    """Plays the candidates for one counterexample; `paced` gives the search for other lengths."""

    def __init__(
        self, machine: Machine, play: Play, paced: Callable[[Lengths], Pace], candidate: Candidate, told: Told
    ) -> None:
        self.machine, self.play, self.paced = machine, play, paced
        self.candidate, self.told = candidate, told

    def found(self, pace: Pace) -> Refuted | None:
        """Returns what a stage shows of the candidates, from the one at `pace` on; None where it shows none.

        :raises TooManyError: when a search takes more work than is left.
        """
        for _ in range(ROUNDS):
            expected = self.candidate(pace)
            if not expected or len(expected) > MOST_TICKS:
                return None
            life = self.life(expected)
            found = self.told(life)
            if found is not None:
                return found
            lengths = _corrected(self.machine, pace.lengths, expected, life)
            if lengths is None:
                return None
            pace = self.paced(lengths)
        return None

    def life(self, expected: Life) -> Life:
        """What an actor goes through on a stage that gets the inputs of a run."""
        machine = self.machine
        events = {name: column for column, name in enumerate(machine.events)}
        states = {machine.states[row]: row for row in machine.rows(0)}
        ticks = self.play(inputs(machine, expected), len(expected) + AFTERWARDS)
        presses = [*(step.press for step in expected), *[NOTHING] * AFTERWARDS]
        return tuple(
            SearchStep(
                press,
                tuple(Taken(events[event], states[state], states.get(to, -1)) for event, state, to in taken),
            )
            for press, taken in zip(presses, ticks, strict=True)
        )


def _corrected(machine: Machine, lengths: Lengths, expected: Life, life: Life) -> Lengths | None:
    """Returns the lengths with the motion at which a life leaves the expected path as long as in the life;
    None where it does not leave it.
    """
    state = machine.initial
    for tick, (one, other) in enumerate(zip(expected, life, strict=False)):
        if one.changes != other.changes:
            change = _next_change(life, tick, tick + 1) - _next_change(expected, tick, len(expected))
            longer = max(lengths.ticks[state] + (change or 1), 1)
            return replace(lengths, ticks=_with(lengths.ticks, state, longer))
        state = one.changes[-1][1] if one.changes else state
    return None


def _next_change(steps: Life, since: int, otherwise: int) -> int:
    return next((tick for tick in range(since, len(steps)) if steps[tick].changes), otherwise)


def _with(ticks: tuple[int, ...], state: int, longer: int) -> tuple[int, ...]:
    return (*ticks[:state], longer, *ticks[state + 1 :])
