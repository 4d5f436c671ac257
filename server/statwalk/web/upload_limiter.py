"""Limits the uploads that arrive at once, and the child processes that read and rig models."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from anyio import CapacityLimiter
from fastapi import Request

from statwalk.web.errors import Problem

MOST_AT_ONCE = 8
MOST_CHILDREN = 2


class UploadLimiter:
    """Limits the uploads that arrive at once, and the child processes that read them. The app has one."""

    def __init__(self) -> None:
        self.arriving = 0
        self.children = CapacityLimiter(MOST_CHILDREN)

    @contextmanager
    def place(self) -> Iterator[None]:
        """Counts one upload as arriving while the context is open.

        :raises Problem: 503, when too many uploads are arriving.
        """
        if self.arriving >= MOST_AT_ONCE:
            raise Problem(503, f"{MOST_AT_ONCE} uploads are arriving already; try again later")
        self.arriving += 1
        try:
            yield
        finally:
            self.arriving -= 1


def upload_limiter_of(request: Request) -> UploadLimiter:
    """Returns the app's limiter."""
    state = request.app.state
    if not hasattr(state, "upload_limiter"):
        state.upload_limiter = UploadLimiter()
    limiter: UploadLimiter = state.upload_limiter
    return limiter
