"""The thread that gives the real-time stages their ticks, on an absolute schedule.

The event loop's own timers are late whenever it sends to many viewers; a thread that sleeps until the next step is due is not.
"""

from __future__ import annotations

import logging
import threading
import time
from collections.abc import Callable, Iterable
from typing import Protocol

LONGEST_SLEEP = 0.25
SHORTEST_SLEEP = 0.001
"""even where the steps take longer than they last: whoever waits for a stage gets it in between"""
log = logging.getLogger("statwalk.pacer")


class Paced(Protocol):
    """Something that moves with time."""

    def advance_to(self, now: float) -> float:
        """Takes the steps that are due at `now` (perf_counter seconds); the seconds until the next one is."""
        ...


class Pacer:
    """Runs from `start` until `stop`; asks for the list of stages at each turn, so that they may come and go."""

    def __init__(self, stages: Callable[[], Iterable[Paced]]) -> None:
        self.stages = stages
        self.stopping = False
        self.woken = threading.Event()
        self.thread = threading.Thread(target=self.run, name="pacer", daemon=True)

    def start(self) -> None:
        """Starts the thread."""
        self.thread.start()

    def stop(self) -> None:
        """Ends the thread after the step it is in."""
        self.stopping = True
        self.woken.set()
        self.thread.join(timeout=2.0)

    def wake(self) -> None:
        """Looks at the stages now: one is new, or its clock changed."""
        self.woken.set()

    def run(self) -> None:
        """The thread."""
        while not self.stopping:
            self.woken.clear()
            due = min([self.advance(stage) for stage in self.stages()], default=time.perf_counter() + LONGEST_SLEEP)
            self.woken.wait(max(due - time.perf_counter(), SHORTEST_SLEEP))  # less what the steps themselves took

    def advance(self, stage: Paced) -> float:
        """One stage's steps; when its next one is due (perf_counter seconds). A defect is logged and does not stop the others."""
        now = time.perf_counter()
        try:
            return now + min(stage.advance_to(now), LONGEST_SLEEP)
        except Exception:
            log.exception("a stage failed in its step")
            return now + LONGEST_SLEEP
