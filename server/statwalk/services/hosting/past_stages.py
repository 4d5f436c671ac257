"""Keeps copies of a stage at past ticks: the next request for a nearby tick starts from a copy, not from the
first tick.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from statwalk.services.cancel import NEVER, CancelToken
from statwalk.stage.stage import Stage

MOST_COPIES = 4


def branch_at(past: Stage, tick: int, token: CancelToken) -> Stage:
    """Returns a fork of `past` at a tick; `past` is a copy, which goes to the tick.

    :raises StageError: when the stage has no such tick.
    :raises CancelledError: when the token is cancelled before the stage is at the tick.
    """
    past.before_tick = token.check
    if tick != past.tick:
        past.seek(tick)
    branch = past.fork()
    branch.before_tick = NEVER.check
    return branch


class PastStages:
    """The copies that no caller uses now, the most recently used last. Thread-safe."""

    def __init__(self, copy: Callable[[], Stage]) -> None:
        self._copy = copy
        self._idle: list[Stage] = []
        self._lock = threading.Lock()

    @contextmanager
    def at(self, tick: int, token: CancelToken) -> Iterator[Stage]:
        """Yields a stage with its playhead at `tick`; no other caller has it meanwhile.

        :raises StageError: when the stage has no such tick.
        :raises CancelledError: when the token is cancelled before the stage is at the tick.
        """
        stage = self._take(tick) or self._copy()
        stage.before_tick = token.check
        stage.seek(tick)
        yield stage
        with self._lock:
            self._idle = [*self._idle, stage][-MOST_COPIES:]

    def forget(self) -> None:
        """Drops the copies, and the snapshots that only the copies hold."""
        with self._lock:
            self._idle = []

    def _take(self, tick: int) -> Stage | None:
        """Returns the idle copy that reaches the tick soonest, or None.

        A copy whose newest tick is `tick` does not count: the stage may have got or lost actors there since.
        """
        with self._lock:
            usable = [stage for stage in self._idle if tick < stage.head]
            nearest = max(usable, key=lambda stage: (stage.tick <= tick, stage.tick), default=None)
            self._idle = [stage for stage in self._idle if stage is not nearest]
            return nearest
