"""The way to a state: which events lead there soonest, by the time that motions, markers and windows make one wait.

A state is thought to be entered at the beginning of its motion. A cell with several outcomes takes as many tries as its chance says;
a condition is thought to hold some time, and an event that only the world raises (a sense, a touch) to come some time.
"""

from __future__ import annotations

import heapq
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.built.runform import Machine
from statwalk.machine.built.runparts import AT_END, AT_MARKER, IN_WINDOW, Outcome

AT_ONCE_S = 1 / 60
"""what an event costs that is taken now"""
CONDITION_S = 1.0
"""what it costs to hope for a condition"""
WORLD_S = 5.0
"""what it costs to wait for an event of the world"""
NEVER = np.inf


class Step(NamedTuple):
    """In `state`, `event` is sent (END: the motion's end is waited for); `seconds` until it fires, as expected."""

    state: str
    event: str
    seconds: float


class Plan(NamedTuple):
    """A way to `goal`, and how long it is expected to take."""

    steps: tuple[Step, ...]
    seconds: float
    goal: str


class Edge(NamedTuple):
    """From one state to another by a cell; `seconds` as expected."""

    here: int
    event: int
    there: int
    seconds: float


def plan(machine: Machine, here: int, goal: int) -> Plan | None:
    """The shortest way of the base layer from state `here` to state `goal`, by expected time; None where there is none."""
    first = first_edges(machine, goal)
    steps: list[Step] = []
    while here != goal:
        edge = first.get(here)
        if edge is None:
            return None
        steps.append(Step(machine.states[here], machine.events[edge.event], edge.seconds))
        here = edge.there
    return Plan(tuple(steps), sum(step.seconds for step in steps), machine.states[goal])


def events_towards(machine: Machine, goal: int) -> NDArray[np.int16]:
    """(S,) the event of the first step from each state to `goal`; -1 where there is no way, or one is there."""
    events = np.full(len(machine.states), -1, np.int16)
    for here, edge in first_edges(machine, goal).items():
        events[here] = edge.event
    return events


def reachable(machine: Machine, here: int) -> list[str]:
    """The states that can be reached from `here`, in the order of the table."""
    found, queue = {here}, [here]
    following: dict[int, list[int]] = {}
    for edge in edges(machine):
        following.setdefault(edge.here, []).append(edge.there)
    while queue:
        new = [state for state in following.get(queue.pop(), ()) if state not in found]
        found.update(new)
        queue.extend(new)
    return [machine.states[state] for state in sorted(found)]


def first_edges(machine: Machine, goal: int) -> dict[int, Edge]:
    """The first step from each state that has a way to `goal` (Dijkstra, from the goal back); the table's order decides between equals."""
    into: dict[int, list[Edge]] = {}
    for edge in edges(machine):
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


def edges(machine: Machine) -> Iterator[Edge]:
    """What every cell of the base can lead to, and how long that is expected to take."""
    world = {sense.event for sense in machine.senses} | {touch.event for touch in machine.touches}
    for (here, event), outcomes in sorted(machine.outcomes.items()):
        wait = waiting(machine, here, event)
        if machine.layer_of[here] != 0 or wait == NEVER:
            continue
        wait += WORLD_S if event in world else 0.0
        total = sum(outcome.weight or 0.0 for outcome in outcomes)
        for outcome in outcomes:
            if outcome.target >= 0 and outcome.target != here:
                yield Edge(here, event, outcome.target, tried(outcome, wait, total))


def tried(outcome: Outcome, seconds: float, total: float) -> float:
    """The time until one of a cell's outcomes comes about, each try taking `seconds`."""
    if outcome.weight is not None:
        return seconds * total / outcome.weight if outcome.weight > 0 else NEVER
    return seconds + (CONDITION_S if outcome.condition else 0.0)


def waiting(machine: Machine, state: int, event: int) -> float:
    """Seconds from the beginning of a motion until its cell fires: its own moment, and that at which the event comes."""
    factor = float(machine.speed[state])
    duration, when = float(machine.duration[state]), int(machine.when[state, event])
    markers = dict(machine.markers[state])
    comes = duration if event == machine.end else markers.get(machine.events[event], 0.0) * duration
    moment = machine.moments.get((state, event))
    if when == AT_END:
        comes = duration
    elif when == AT_MARKER:
        comes = max(comes, markers[moment.marker] * duration) if moment and moment.marker in markers else NEVER
    elif when == IN_WINDOW and moment:
        comes = max(comes, moment.first * duration)
    return max(comes / factor, AT_ONCE_S) if factor > 0 else (AT_ONCE_S if comes == 0 else NEVER)
