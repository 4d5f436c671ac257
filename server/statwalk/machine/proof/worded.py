"""A run that refutes a property, in words, and as what must come from outside to see it."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from itertools import groupby, pairwise
from typing import NamedTuple

from statwalk.machine.built.runform import Machine
from statwalk.machine.built.runparts import MIXED
from statwalk.machine.proof.lengths import TICKS_PER_SECOND
from statwalk.machine.proof.moments import NOBODY
from statwalk.machine.proof.search import Step

MOST_CHANGES_SAID = 12


class Refuted(NamedTuple):
    """A counterexample."""

    message: str
    replay: tuple[tuple[int, str], ...]
    """(tick, event) of all that comes from outside, from a fresh stage"""


def seconds(ticks: float) -> str:
    """`2.35 s`, or `for ever`."""
    return f"{ticks / TICKS_PER_SECOND:.4g} s" if math.isfinite(ticks) else "for ever"


def refuted(machine: Machine, goals: Collection[int], before: Sequence[Step], after: Sequence[Step]) -> Refuted:
    """The counterexample that goes by those steps: to the start, and on from there."""
    name = machine.states[machine.initial]
    way = f"{name}{said(machine, before, 0)}"
    rest = said(machine, after, len(before))
    goal = " or ".join(machine.states[one] for one in sorted(goals))
    stays = f"{way}{rest} and after {seconds(len(after))} not in {goal}"
    replay = tuple((tick, machine.events[step.press]) for tick, step in enumerate((*before, *after), 1) if step.press != NOBODY)
    return Refuted(f"refuted: {stays}{permitting(machine, (*before, *after))}", replay)


def said(machine: Machine, steps: Sequence[Step], since: int) -> str:
    """` -LEFT 0.5 s-> TLFT`, for each change and each event from outside; `since` ticks went before."""
    parts: list[str] = []
    told = [(tick, step) for tick, step in enumerate(steps, since + 1) if step.changes or step.press != NOBODY]
    for (press, is_change), several in groupby(told, lambda one: (one[1].press, bool(one[1].changes))):
        some = list(several)
        if is_change:
            changes = [(tick, *change) for tick, step in some for change in step.changes]
            parts += [f" -{machine.events[event]} {seconds(tick)}-> {machine.states[state]}" for tick, event, state in changes]
        else:
            again = f" to {seconds(some[-1][0])}" if len(some) > 1 else ""
            parts.append(f" -{machine.events[press]} {seconds(some[0][0])}{again}-")
    if len(parts) > MOST_CHANGES_SAID:
        parts = [*parts[: MOST_CHANGES_SAID - 1], " …"]
    return "".join(parts)


def permitting(machine: Machine, steps: Sequence[Step]) -> str:
    """Whether the run is one among several that chance or conditions may choose."""
    places = [(one.node.state, event) for one, other in pairwise(steps) for event, _ in other.changes]
    return ", if conditions and chance will have it" if any(machine.target[place] == MIXED for place in places) else ""
