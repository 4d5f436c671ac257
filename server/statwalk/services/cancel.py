"""Cancels long work when its client disconnects or the server stops: the work checks its token every few
milliseconds.
"""

from __future__ import annotations

import threading
import time

from statwalk.errors import CancelledError, OverdueError

LOOK_SECONDS = 0.1
"""between two looks at the token while a log makes commands durable"""
SLICE_SECONDS = 0.005
"""the longest time that work runs between two checks of its token"""


class CancelToken:
    """Says whether the work for one client is cancelled; `ending` is set when the server stops.
    Thread-safe.
    """

    def __init__(self, ending: threading.Event | None = None) -> None:
        self._gone, self._ending = threading.Event(), ending or threading.Event()
        self._seconds = self._deadline = float("inf")

    def cancel(self) -> None:
        """Cancels the work: the client disconnected."""
        self._gone.set()

    def expire_after(self, seconds: float) -> None:
        """Gives the work so many seconds from now."""
        self._seconds, self._deadline = seconds, time.monotonic() + seconds

    @property
    def cancelled(self) -> bool:
        """Whether the client disconnected or the server stops."""
        return self._gone.is_set() or self._ending.is_set()

    def check(self) -> None:
        """Raises if the work is cancelled, or its time is over.

        :raises CancelledError: when the client disconnected or the server stops.
        :raises OverdueError: when the work has taken longer than it may.
        """
        if time.monotonic() > self._deadline:
            raise OverdueError(
                f"the work took longer than {self._seconds:g} s and was stopped; what a stage has stepped "
                "stays. Ask for less at once: fewer ticks, fewer actors, a shorter range"
            )
        if self.cancelled:
            raise CancelledError("the work is cancelled: its client disconnected, or the server stops")


NEVER = CancelToken()
"""the token of work that is never cancelled"""
