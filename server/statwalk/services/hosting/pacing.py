"""Shares the time of the thread that steps stages: where it does not suffice, the costliest stages slow down.

A stage that would need more than its share runs as much slower as fits into it, and the others run on time.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable
from statistics import median

TICKS = 31
"""of which the median cost counts: a single slow tick slows nothing down"""
LOOK_SECONDS = 0.5
FORGET_SECONDS = 2.0
"""after which a stage that takes no steps has no share"""
SLOWEST = 0.01
"""the slowest pace: a stage never stands still"""


def fair_share(loads: Iterable[float], most: float) -> float:
    """Returns the largest load that no stage may exceed so that all together are at most `most`: those that
    need less than an equal part leave the rest to the others.
    """
    left, waiting = most, sorted(loads)
    for number, load in enumerate(waiting):
        share = left / (len(waiting) - number)
        if load > share:
            return share
        left -= load
    return float("inf")


class TickCost:
    """The costs of a stage's newest ticks, in seconds."""

    def __init__(self) -> None:
        self._costs: deque[float] = deque(maxlen=TICKS)

    def add(self, seconds: float, ticks: int) -> None:
        """Adds ticks that took so many seconds together."""
        self._costs.extend([seconds / ticks] * min(ticks, TICKS))

    def median(self) -> float:
        """Returns the median; 0 until there are enough ticks."""
        return median(self._costs) if len(self._costs) == TICKS else 0.0


class Pacing:
    """Gives each stage its pace, in `(0, 1]`; `most` is the part of the thread's time that all stages may
    use. Only the thread that steps the stages may call it.
    """

    def __init__(self, most: float) -> None:
        self.most = most
        self._loads: dict[str, tuple[float, float]] = {}
        self._share, self._looked = float("inf"), float("-inf")

    def pace(self, stage: str, load: float, now: float) -> float:
        """Returns the pace of a stage that would need `load` of the thread's time (1: all of it) at its full
        speed; `now` in seconds.
        """
        self._loads[stage] = now, load
        if now - self._looked > LOOK_SECONDS:
            self._looked = now
            self._loads = {
                name: (at, needed) for name, (at, needed) in self._loads.items() if now - at < FORGET_SECONDS
            }
            self._share = fair_share((needed for _, needed in self._loads.values()), self.most)
        return max(SLOWEST, self._share / load) if load > self._share else 1.0
