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

from statwalk.services.threads import Now

LONGEST_SLEEP = 0.25
SHORTEST_SLEEP = 0.001
"""the pause between steps, even if steps are slow: a request that waits for the stage gets the lock then"""
LONGEST_ROUND = 10.0
"""the seconds after which a round of steps counts as stuck"""
log = logging.getLogger("statwalk.ticker")


class Ticked(Protocol):
    """An object that the ticker steps."""

    def advance_to(self, now: float) -> float:
        """Takes the steps that are due at `now`; returns the seconds until the next
        one.
        """
        ...


class Ticker:
    """Steps the stages from `start` until `stop`; it calls `stages` in each round, so the list may change."""

    def __init__(self, stages: Callable[[], Iterable[Ticked]], now: Now = time.perf_counter) -> None:
        self.stages, self.now = stages, now
        self.stopping = False
        self.round_began = now()
        self.failing: set[Ticked] = set()
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

    def fault(self) -> str:
        """Returns why stages stand still although they should not; empty if they do not."""
        if not self.thread.is_alive():
            return "the thread that steps the stages does not run"
        if self.now() - self.round_began > LONGEST_ROUND:
            return f"the thread that steps the stages has stood still for more than {LONGEST_ROUND:g} s"
        failing = len(self.failing)
        return f"{failing} of the stages fail in their steps; the log says why" if failing else ""

    def run(self) -> None:
        """Steps the stages in rounds until `stop`; runs in the thread."""
        while not self.stopping:
            self.woken.clear()
            self.woken.wait(self.round())

    def round(self) -> float:
        """Takes the due steps of all stages; returns the seconds until the next round."""
        self.round_began = self.now()
        self.failing.intersection_update(self.stages())  # a closed stage fails no more
        due = min([self.advance(stage) for stage in self.stages()], default=self.now() + LONGEST_SLEEP)
        return max(due - self.now(), SHORTEST_SLEEP)  # the steps took time too

    def advance(self, stage: Ticked) -> float:
        """Takes the due steps of one stage; returns when its next step is due.

        Logs a defect of a stage, so that the other stages go on.
        """
        now = self.now()
        try:
            wait = stage.advance_to(now)
            self.failing.discard(stage)
            return now + min(wait, LONGEST_SLEEP)
        except Exception:
            log.exception("a stage failed in its step")
            self.failing.add(stage)
            return now + LONGEST_SLEEP
