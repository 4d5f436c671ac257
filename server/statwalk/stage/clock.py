"""The clock of a stage: which steps are due. The caller passes the time; the clock never reads the time and
never sleeps.
"""

from __future__ import annotations

from dataclasses import dataclass, field

LARGEST_CATCH_UP_S = 0.25
"""The most time that is caught up after a stall, so that a slow machine does not fall ever further behind."""
NEVER_S = 3600.0


@dataclass
class Clock:
    """Hands out steps of 1/`rate` seconds, `speed` times as fast as real time.

    clock = Clock(rate=60)
    stage.step(clock.due(now_in_seconds))
    """

    rate: float = 60.0
    speed: float = 1.0
    paused: bool = False
    pace: float = 1.0
    """a part of the speed: less than 1 while the computer is too slow"""
    _last: float | None = field(default=None, init=False)
    _owed: float = field(default=0.0, init=False)
    _lost: float = field(default=0.0, init=False)

    @property
    def _steps_a_second(self) -> float:
        return self.rate * self.speed * self.pace

    def due(self, now: float) -> int:
        """Returns the number of steps to take at `now` seconds (any origin, never backwards); time in a pause
        does not count.
        """
        since = 0.0 if self._last is None else max(now - self._last, 0.0)
        passed = min(since, LARGEST_CATCH_UP_S)
        self._last = now
        if self.paused:
            return 0
        self._lost += (since - passed) * self._steps_a_second
        self._owed += passed * self._steps_a_second
        steps = int(self._owed + 1e-9)
        self._owed = max(self._owed - steps, 0.0)
        return steps

    def stand(self) -> None:
        """Lets no time pass until the next call of `due`."""
        self._last = None

    def lateness(self, steps: int) -> list[float]:
        """Returns by how many seconds each of the `steps` that `due` has just handed out is late, the oldest
        first.
        """
        return [(self._owed + left) / self._steps_a_second for left in range(steps - 1, -1, -1)]

    def take_lost(self) -> int:
        """Returns the steps that are too late to be caught up since the last call."""
        lost = int(self._lost)
        self._lost -= lost
        return lost

    def wait(self, now: float) -> float:
        """Returns the seconds from `now` until the next step is due; 0 if a step is due, NEVER_S while
        paused.
        """
        if self.paused or self.speed <= 0:
            return NEVER_S
        passed = 0.0 if self._last is None else now - self._last
        return max((1 - self._owed) / self._steps_a_second - passed, 0.0)
