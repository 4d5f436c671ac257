"""Plans the path to a state: the events that lead to it soonest, by the expected time until each takes
effect.

A plan expects every state to be entered at the beginning of its motion. A cell with weights takes as many
tries as its weights imply, a condition takes CONDITION_S to become true, and an event of the world (a sense,
a touch) takes WORLD_S to come.
"""

from __future__ import annotations

import heapq
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.compile.alternatives import AT_END, AT_MARKER, IN_WINDOW, Alternative
from statwalk.machine.compile.machine import Machine

AT_ONCE_S = 1 / 60
"""seconds until an event that is sent now takes effect"""
CONDITION_S = 1.0
"""seconds until a condition is expected to be true"""
WORLD_S = 5.0
"""seconds until an event of the world is expected"""
NEVER = np.inf


class TravelStep(NamedTuple):
    """Send `event` in `state` (END: wait for the motion's end); `seconds` is the expected time until it
    fires.
    """

    state: str
    event: str
    seconds: float


class Plan(NamedTuple):
    """A path to `goal`, and its expected seconds."""

    steps: tuple[TravelStep, ...]
    seconds: float
    goal: str


class Edge(NamedTuple):
    """A transition from one state to another by a cell; `seconds` is its expected time."""

    here: int
    event: int
    there: int
    seconds: float


def plan(machine: Machine, here: int, goal: int) -> Plan | None:
    """Returns the shortest path of the base layer from state `here` to state `goal`, by expected time; None
    if no path exists.
    """
    first = _first_edges(machine, goal)
    steps: list[TravelStep] = []
    while here != goal:
        edge = first.get(here)
        if edge is None:
            return None
        steps.append(TravelStep(machine.states[here], machine.events[edge.event], edge.seconds))
        here = edge.there
    return Plan(tuple(steps), sum(step.seconds for step in steps), machine.states[goal])


def events_towards(machine: Machine, goal: int) -> NDArray[np.int16]:
    """Returns (S,) the event of the first step from each state to `goal`; -1 for the goal and for states
    without a path to it.
    """
    events = np.full(len(machine.states), -1, np.int16)
    for here, edge in _first_edges(machine, goal).items():
        events[here] = edge.event
    return events


def reachable(machine: Machine, here: int) -> list[str]:
    """Returns the names of the states that can be reached from state `here`, in the order of the table."""
    reached, queue = {here}, [here]
    following: dict[int, list[int]] = {}
    for edge in _edges(machine):
        following.setdefault(edge.here, []).append(edge.there)
    while queue:
        new = [state for state in following.get(queue.pop(), ()) if state not in reached]
        reached.update(new)
        queue.extend(new)
    return [machine.states[state] for state in sorted(reached)]


def _first_edges(machine: Machine, goal: int) -> dict[int, Edge]:
    """The first step from each state that has a path to `goal` (Dijkstra, from the goal back); the table's
    order decides between equals.
    """
    into: dict[int, list[Edge]] = {}
    for edge in _edges(machine):
        into.setdefault(edge.there, []).append(edge)
    first: dict[int, Edge] = {}
    done: set[int] = set()
    queue: list[tuple[float, int, Edge | None]] = [(0.0, goal, None)]
    while queue:
        seconds, state, by = heapq.heappop(queue)
        if state in done:
            continue
        done.add(state)
        if by is not None:
            first[state] = by
        for edge in into.get(state, ()):
            if edge.here not in done:
                heapq.heappush(queue, (seconds + edge.seconds, edge.here, edge))
    return first


def _edges(machine: Machine) -> Iterator[Edge]:
    world = {sense.event for sense in machine.senses} | {touch.event for touch in machine.touches}
    for (here, event), alternatives in sorted(machine.alternatives.items()):
        wait = _wait(machine, here, event)
        if machine.layer_of[here] != 0 or wait == NEVER:
            continue
        wait += WORLD_S if event in world else 0.0
        total = sum(alternative.weight or 0.0 for alternative in alternatives)
        for alternative in alternatives:
            if alternative.target >= 0 and alternative.target != here:
                yield Edge(here, event, alternative.target, _expected(alternative, wait, total))


def _expected(alternative: Alternative, seconds: float, total: float) -> float:
    """Seconds until a cell leads to one of its alternatives, each try taking `seconds`."""
    if alternative.weight is not None:
        return seconds * total / alternative.weight if alternative.weight > 0 else NEVER
    return seconds + (CONDITION_S if alternative.condition else 0.0)


def _wait(machine: Machine, state: int, event: int) -> float:
    """Seconds from the beginning of a motion until its cell fires: its own timing, or the arrival of the
    event if it is later.
    """
    factor = float(machine.speed[state])
    duration, when = float(machine.duration[state]), int(machine.when[state, event])
    markers = dict(machine.markers[state])
    comes = duration if event == machine.end else markers.get(machine.events[event], 0.0) * duration
    timing = machine.timings.get((state, event))
    if when == AT_END:
        comes = duration
    elif when == AT_MARKER:
        comes = (
            max(comes, markers[timing.marker] * duration) if timing and timing.marker in markers else NEVER
        )
    elif when == IN_WINDOW and timing:
        comes = max(comes, timing.first * duration)
    return max(comes / factor, AT_ONCE_S) if factor > 0 else (AT_ONCE_S if comes == 0 else NEVER)
