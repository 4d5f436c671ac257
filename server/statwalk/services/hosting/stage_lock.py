"""The lock of one stage: threads take it for short work, and for a slice of long work at a time."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from statwalk.errors import BusyError
from statwalk.services.cancel import SLICE_SECONDS
from statwalk.services.threads import Now

BUSY_SECONDS = 20.0
RETRY_SECONDS = 0.001
"""until a step that is due is tried again, when another thread holds the stage; a whole tick would be seen"""


class StageLock:
    """A lock that a thread holds only for a moment."""

    def __init__(self, now: Now = time.perf_counter) -> None:
        self.lock, self.now = threading.Lock(), now

    @contextmanager
    def held(self) -> Iterator[None]:
        """Holds the lock.

        :raises BusyError: when another thread holds the stage for 20 s.
        """
        if not self.lock.acquire(timeout=BUSY_SECONDS):
            raise BusyError("the stage is busy with a long step; try again")
        try:
            yield
        finally:
            self.lock.release()

    @contextmanager
    def tried(self) -> Iterator[bool]:
        """Holds the lock if no other thread does; yields whether it does."""
        is_held = self.lock.acquire(blocking=False)
        try:
            yield is_held
        finally:
            if is_held:
                self.lock.release()

    def in_slices(self, work: Iterator[int], check: Callable[[], None]) -> None:
        """Runs long work, holding the lock for 5 ms at a time; what is done stays if `check` raises.

        `check` is called before each slice, and raises to cancel the work.
        """
        unfinished = True
        while unfinished:
            check()
            with self.held():
                slice_end = self.now() + SLICE_SECONDS
                while unfinished and self.now() < slice_end:
                    unfinished = next(work, None) is not None
            time.sleep(0)  # lets a thread that waits for the lock run
