"""Simulated time: events in order, chances that follow from one seed, and what happened last."""

import heapq
import random
from collections import deque
from collections.abc import Callable
from typing import Any

TRACE_LENGTH = 60
FIRST_WALL = 1_800_000_000.0
"""the time of day when a simulation begins, in seconds since 1970"""


class World:
    """`time` in seconds since the beginning, which no fault changes; `wall`: the time of day, which jumps."""

    def __init__(self, seed: int) -> None:
        self.seed, self.time, self.wall_offset = seed, 0.0, FIRST_WALL
        self.faults: list[str] = []
        """what does not keep to its promise; the simulation ends with the first"""
        self.trace: deque[str] = deque(maxlen=TRACE_LENGTH)
        self.events = 0
        self._due: list[tuple[float, int, Callable[..., object], tuple[Any, ...]]] = []

    @property
    def wall(self) -> float:
        return self.time + self.wall_offset

    def chance(self, name: str) -> random.Random:
        """Chances of their own for each part: a part that draws more changes no other part's."""
        return random.Random(f"{self.seed} {name}")

    def after(self, seconds: float, act: Callable[..., object], *arguments: Any) -> None:
        self.events += 1
        heapq.heappush(self._due, (self.time + seconds, self.events, act, arguments))

    def spend(self, seconds: float) -> None:
        """Time passes within an event: a slow computer."""
        self.time += seconds

    def run(self, until: float) -> None:
        """Runs the events up to a time, or to the first fault."""
        while self._due and self._due[0][0] <= until and not self.faults:
            due, _, act, arguments = heapq.heappop(self._due)
            self.time = max(self.time, due)
            act(*arguments)
        self.time = max(self.time, until)

    def note(self, text: str) -> None:
        self.trace.append(f"{self.time:9.3f} s  {text}")

    def fault(self, text: str) -> None:
        self.faults.append(text)
        self.note(f"FAULT: {text}")
