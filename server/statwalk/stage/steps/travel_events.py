"""Travelling: an actor with a goal gets, in each state, the event that leads to the goal soonest."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from weakref import WeakKeyDictionary

import numpy as np

from statwalk.machine import travel
from statwalk.machine.compile.machine import Machine
from statwalk.machine.runtime.surroundings import PRESS, TRAVEL
from statwalk.stage.state.cast import Cast

AGAIN_S = 0.25
"""seconds after which an event that has not led on is sent again: its condition may have become true"""

Row = tuple[int, int, int, int]
"""row of the cast, event (or state), kind, other: an input"""

_WAYS: WeakKeyDictionary[Machine, dict[int, list[int]]] = WeakKeyDictionary()


def presses(cast: Cast, inputs: Iterable[Row], dt: float) -> list[Row]:
    """Returns the inputs of travelling actors in a tick; travel commands among `inputs` start or end a
    journey.
    """
    goals = {row: int(cast.machine.goal[row]) for row in np.flatnonzero(cast.machine.goal >= 0).tolist()}
    new = {row: goal for row, goal, kind, _ in inputs if kind == TRAVEL}
    again = max(round(AGAIN_S / dt), 1)
    return [
        (row, event, PRESS, -1)
        for row, goal in sorted((goals | new).items())
        if goal >= 0 and (row in new or cast.machine.age[row, 0] % again == 0)
        for event in _next(cast, row, goal)
    ]


def _next(cast: Cast, row: int, goal: int) -> Iterator[int]:
    """The event to send; none if the journey waits for END, if the event already waits, or if the goal can no
    longer be reached.
    """
    machine = cast.role.machine
    ways = _WAYS.setdefault(machine, {})
    if goal not in ways:
        ways[goal] = travel.events_towards(machine, goal).tolist()
    event = ways[goal][int(cast.machine.state[row, 0])]
    if event >= 0 and event != machine.end and event not in cast.machine.waiting_event[row, 0].tolist():
        yield event
