"""All that can happen to an actor, by breadth for what can be reached, by depth for the longest it can take."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Collection, Iterator, Mapping
from typing import NamedTuple

from statwalk.machine.built.runparts import BLANK, OFF, UNDEFINED
from statwalk.machine.proof.moments import NOBODY, Node
from statwalk.machine.proof.tick import Ticks

MOST_WORK = 1_000_000
"""steps that all properties of a machine may take together: one or two seconds"""
TICK_WORK = 12
"""steps that it is worth to work out a tick"""


class TooManyError(Exception):
    """The search was given up."""


class Work:
    """What is left to be done for a machine before the search is given up; the same on every computer."""

    def __init__(self, most: int = MOST_WORK) -> None:
        self.left = most

    def spend(self, steps: int) -> None:
        """Raises TooManyError where no more is left."""
        self.left -= steps
        if self.left < 0:
            raise TooManyError


class Step(NamedTuple):
    """What a tick leads to: the event that came from outside, and the actor after it."""

    press: int
    node: Node
    changes: tuple[tuple[int, int], ...] = ()
    """event and new state of each change"""

    def enters(self, states: Collection[int]) -> bool:
        """Whether one of those states is entered in the tick, perhaps to be left again in it."""
        return any(state in states for _, state in self.changes)


class Search:
    """What can follow what, each tick worked out once; `presses` are the events that may come from outside, at any tick."""

    def __init__(self, ticks: Ticks, presses: Collection[int], work: Work) -> None:
        self.ticks, self.presses, self.work = ticks, tuple(presses), work
        self.known: dict[Node, tuple[Step, ...]] = {}

    def following(self, node: Node) -> tuple[Step, ...]:
        """All steps from a node; the one in which nothing comes from outside first."""
        if node not in self.known:
            self.known[node] = tuple(self.steps(node))
        return self.known[node]

    def steps(self, node: Node) -> Iterator[Step]:
        """All steps from a node, worked out; none in which an event from outside would have to wait beside another."""
        begun, row = self.ticks.begun(node), self.ticks.machine.targets[node.state]
        for press in (NOBODY, *(one for one in self.presses if row[one] not in (BLANK, OFF, UNDEFINED))):
            most = max(len(node.queue), 1) if press != NOBODY else math.inf
            self.work.spend(TICK_WORK)
            steps = (Step(press, after.node, after.changes) for after in self.ticks.finished(begun, press))
            yield from dict.fromkeys(step for step in steps if len(step.node.queue) <= most)

    def reached(self, start: Node) -> dict[Node, tuple[Node, Step] | None]:
        """All that can be reached, in the order of time, each with what came before it on a shortest way."""
        before: dict[Node, tuple[Node, Step] | None] = {start: None}
        queue = deque([start])
        while queue:
            node = queue.popleft()
            self.work.spend(1)
            for step in self.following(node):
                if step.node not in before:
                    before[step.node] = (node, step)
                    queue.append(step.node)
        return before

    def longest(self, starts: Collection[Node], goals: Collection[int]) -> dict[Node, float]:
        """For each start, and all between, the most ticks that it can take to a state of `goals`; infinite where they can be avoided."""
        values: dict[Node, float] = {}
        for start in starts:
            if start not in values:
                self.descend(start, goals, values)
        return values

    def descend(self, start: Node, goals: Collection[int], values: dict[Node, float]) -> None:
        """Adds the values of all that follows `start`; who comes by again has found a way to go round for ever."""
        path, most = [(start, iter(self.following(start)))], {start: 0.0}
        while path:
            self.work.spend(1)
            node, steps = path[-1]
            step = next(steps, None)
            child = step.node if step else node
            if step is None:
                path.pop()
                values[node] = most.pop(node)
                if path:
                    most[path[-1][0]] = max(most[path[-1][0]], values[node] + 1)
            elif step.enters(goals):
                most[node] = max(most[node], 1.0)
            elif child in most:
                most[node] = math.inf
            elif child in values:
                most[node] = max(most[node], values[child] + 1)
            else:
                most[child] = 0.0
                path.append((child, iter(self.following(child))))

    def beyond(self, start: Node, goals: Collection[int], values: Mapping[Node, float], limit: int) -> list[Step]:
        """A run from `start` that is in no goal for `limit` ticks; from outside comes as little as will do, as late as it can."""
        run: list[Step] = []
        node = start
        while len(run) < limit:
            self.work.spend(1)
            some = (one for one in self.following(node) if not one.enters(goals))
            step = next(one for one in some if len(run) + 1 + values[one.node] > limit)
            run.append(step)
            node = step.node
        return run


def way(before: Mapping[Node, tuple[Node, Step] | None], goal: Node) -> list[Step]:
    """The steps to what was reached."""
    steps: list[Step] = []
    while (last := before[goal]) is not None:
        goal = last[0]
        steps.append(last[1])
    return steps[::-1]
