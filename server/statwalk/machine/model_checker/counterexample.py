"""A run that refutes a property, in words, and as what must come from outside to see it."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from itertools import groupby
from typing import NamedTuple

from statwalk.machine.compile.machine import Machine
from statwalk.machine.model_checker.lengths import TICKS_PER_SECOND
from statwalk.machine.model_checker.search import SearchStep
from statwalk.machine.model_checker.state_space import NOTHING

MOST_CHANGES_SAID = 12


class Refuted(NamedTuple):
    """A counterexample."""

    message: str
    replay: tuple[tuple[int, str], ...]
    """(tick, event) of each input; `replay` sends the inputs to a fresh stage"""
    ticks: int
    """after so many ticks a fresh stage has shown it"""


def seconds(ticks: float) -> str:
    """`2.35 s`, or `for ever`."""
    return f"{ticks / TICKS_PER_SECOND:.4g} s" if math.isfinite(ticks) else "for ever"


def refuted(
    machine: Machine, goals: Collection[int], before: Sequence[SearchStep], after: Sequence[SearchStep]
) -> Refuted:
    """The counterexample with these steps: to the start, and on from there without a goal."""
    goal = " or ".join(machine.states[one] for one in sorted(goals))
    rest = f"{in_words(machine, after, len(before))} and after {seconds(len(after))} not in {goal}"
    return shown(machine, (*before, *after), f"{in_words(machine, before, 0)}{rest}")


def shown(machine: Machine, steps: Sequence[SearchStep], words: str = "") -> Refuted:
    """The counterexample with these steps; `words` describe the steps, if an event's name does not."""
    chance = ", if conditions and chance will have it" if any(step.is_free for step in steps) else ""
    return Refuted(
        f"refuted: {machine.states[machine.initial]}{words or in_words(machine, steps, 0)}{chance}",
        inputs(machine, steps),
        len(steps),
    )


def inputs(machine: Machine, steps: Sequence[SearchStep]) -> tuple[tuple[int, str], ...]:
    """(tick, event) of each input of these steps."""
    return tuple(
        (tick, machine.events[step.press]) for tick, step in enumerate(steps, 1) if step.press != NOTHING
    )


def in_words(machine: Machine, steps: Sequence[SearchStep], since: int) -> str:
    """` -LEFT 0.5 s-> TLFT`, for each change and each event from outside; `since` ticks went before."""
    parts: list[str] = []
    told = [
        (tick, step) for tick, step in enumerate(steps, since + 1) if step.changes or step.press != NOTHING
    ]
    for (press, is_change), several in groupby(told, lambda one: (one[1].press, bool(one[1].changes))):
        some = list(several)
        if is_change:
            changes = [(tick, *change) for tick, step in some for change in step.changes]
            parts += [
                f" -{machine.events[event]} {seconds(tick)}-> {machine.states[state]}"
                for tick, event, state in changes
            ]
        else:
            again = f" to {seconds(some[-1][0])}" if len(some) > 1 else ""
            parts.append(f" -{machine.events[press]} {seconds(some[0][0])}{again}-")
    if len(parts) > MOST_CHANGES_SAID:
        parts = [*parts[: MOST_CHANGES_SAID - 1], " …"]
    return "".join(parts)
