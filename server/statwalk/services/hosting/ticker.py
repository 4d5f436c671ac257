"""The thread that steps the real-time stages on an absolute schedule.

The timers of the event loop are late while it sends to many viewers; a thread that sleeps until the next step
is on time.
"""

from __future__ import annotations

import logging
import threading
import time
from collections.abc import Callable, Iterable
from typing import Protocol

LONGEST_SLEEP = 0.25
SHORTEST_SLEEP = 0.001
"""the pause between steps, even if steps are slow: a request that waits for the stage gets the lock then"""
log = logging.getLogger("statwalk.ticker")


class Ticked(Protocol):
    """An object that the ticker steps."""

    def advance_to(self, now: float) -> float:
        """Takes the steps that are due at `now` (perf_counter seconds); returns the seconds until the next
        one.
        """
        ...


class Ticker:
    """Steps the stages from `start` until `stop`; it calls `stages` in each round, so the list may change."""

    def __init__(self, stages: Callable[[], Iterable[Ticked]]) -> None:
        self.stages = stages
        self.stopping = False
        self.woken = threading.Event()
        self.thread = threading.Thread(target=self.run, name="ticker", daemon=True)

    def start(self) -> None:
        """Starts the thread."""
        self.thread.start()

    def stop(self) -> None:
        """Ends the thread after its current step."""
        self.stopping = True
        self.woken.set()
        self.thread.join(timeout=2.0)

    def wake(self) -> None:
        """Starts the next round now, because a stage is new or its clock changed."""
        self.woken.set()

    def run(self) -> None:
        """Steps the stages in rounds until `stop`; runs in the thread."""
        while not self.stopping:
            self.woken.clear()
            due = min(
                [self.advance(stage) for stage in self.stages()], default=time.perf_counter() + LONGEST_SLEEP
            )
            self.woken.wait(max(due - time.perf_counter(), SHORTEST_SLEEP))  # the steps took time too

    def advance(self, stage: Ticked) -> float:
        """Takes the due steps of one stage; returns when its next step is due (perf_counter seconds).

        Logs a defect of a stage, so that the other stages go on.
        """
        now = time.perf_counter()
        try:
            return now + min(stage.advance_to(now), LONGEST_SLEEP)
        except Exception:
            log.exception("a stage failed in its step")
            return now + LONGEST_SLEEP
