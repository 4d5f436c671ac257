"""Cancels long work when its client disconnects or the server stops: the work checks its token every few
milliseconds.
"""

from __future__ import annotations

import threading

from statwalk.errors import CancelledError

SLICE_SECONDS = 0.005
"""the longest time that work runs between two checks of its token"""


class CancelToken:
    """Says whether the work for one client is cancelled; `ending` is set when the server stops.
    Thread-safe.
    """

    def __init__(self, ending: threading.Event | None = None) -> None:
        self._gone, self._ending = threading.Event(), ending or threading.Event()

    def cancel(self) -> None:
        """Cancels the work: the client disconnected."""
        self._gone.set()

    @property
    def cancelled(self) -> bool:
        """Whether the client disconnected or the server stops."""
        return self._gone.is_set() or self._ending.is_set()

    def check(self) -> None:
        """Raises if the work is cancelled.

        :raises CancelledError: when the client disconnected or the server stops.
        """
        if self.cancelled:
            raise CancelledError("the work is cancelled: its client disconnected, or the server stops")


NEVER = CancelToken()
"""the token of work that is never cancelled"""
