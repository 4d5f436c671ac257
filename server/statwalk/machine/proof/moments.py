"""An actor in the search: between two ticks (`Node`), and within one (`Now`). Whole ticks, one layer."""

from __future__ import annotations

from typing import NamedTuple

from statwalk.machine.built.runform import Machine
from statwalk.machine.built.runparts import MIXED, Outcome
from statwalk.machine.ticking.state import RUNNING

NOBODY = -1
EARLIER = -1
FOR_MOMENT, FOR_END = -1, -2
"""an event waits until a marker or window of the motion, until its end"""
Queue = tuple[tuple[int, int], ...]
"""events that wait, by arrival: each with the ticks for which it goes on waiting in blank cells, or FOR_MOMENT, FOR_END"""


class Node(NamedTuple):
    """An actor after a tick."""

    state: int
    time: int
    """ticks into its motion"""
    begun: int = 0
    """where its motion began, if that was in this tick: markers from there on are still to come; EARLIER, if not"""
    ended: int = RUNNING
    queue: Queue = ()


class Now(NamedTuple):
    """An actor in the middle of a tick."""

    state: int
    time: int
    passed: float
    """ticks up to which markers and windows were met"""
    wraps: int
    crossed: tuple[str, ...]
    """markers"""
    ended: int
    at_end: bool
    queue: Queue
    rest: int = 0
    """ticks that were left after END"""
    ending: bool = False
    """END is being answered: the motion that follows takes over `rest`"""
    begun: int = EARLIER
    changes: tuple[tuple[int, int], ...] = ()
    """event and new state of each change in this tick"""

    @property
    def node(self) -> Node:
        """The actor after the tick."""
        return Node(self.state, self.time, self.begun, self.ended, self.queue)

    def forget(self, event: int) -> Now:
        """That event waits no longer."""
        return self._replace(queue=tuple(one for one in self.queue if one[0] != event)) if self.queue else self

    def left(self, event: int) -> int | None:
        """How long an event goes on waiting; None where it does not wait."""
        return next((left for waiting, left in self.queue if waiting == event), None)

    def wait(self, event: int, left: int) -> Now:
        """The event waits, in the place that it has or at the end."""
        if self.left(event) is None:
            return self._replace(queue=(*self.queue, (event, left)))
        return self._replace(queue=tuple((one, left if one == event else other) for one, other in self.queue))


def choices(machine: Machine, state: int, event: int) -> tuple[tuple[Outcome, ...], bool]:
    """What a cell may lead to, conditions and weights being free, and whether it may be that nothing in it is true."""
    several = machine.outcomes[state, event]
    if machine.targets[state][event] != MIXED:
        return several[:1], False
    if several[0].weight is not None:
        return tuple(one for one in several if one.weight), False
    always = next((number for number, one in enumerate(several) if one.condition is None), None)
    return (several, True) if always is None else (several[: always + 1], False)


def landings(machine: Machine, outcome: Outcome) -> list[int]:
    """The states that an outcome may lead to: several where an outer state is resumed."""
    if outcome.resume < 0:
        return [outcome.target]
    inside: list[int] = machine.inside[:, outcome.resume].nonzero()[0].tolist()
    return list(dict.fromkeys([outcome.target, *inside]))
