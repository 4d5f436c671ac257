"""Limits how many long requests run at once, so that short requests find a free thread."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

from statwalk.errors import CancelledError
from statwalk.web.errors import Problem

MOST_RUNNING = 4
MOST_WAITING = 32


class LongWork:
    """The places in which long requests run, and the queue before them; one for the server.

    Use it in the thread of the event loop only.
    """

    def __init__(self, running: int = MOST_RUNNING, waiting: int = MOST_WAITING) -> None:
        self.free, self.room = asyncio.Semaphore(running), waiting

    @asynccontextmanager
    async def place(self, disconnected: asyncio.Future[None]) -> AsyncIterator[None]:
        """Holds a place for one request, first come first served; `disconnected` is done when its client
        disconnects.

        :raises Problem: 503, when too many requests wait already.
        :raises CancelledError: when the client disconnects before a place is free.
        """
        acquired = asyncio.ensure_future(self._acquire())
        try:
            await self._wait(acquired, disconnected)
            yield
        finally:
            if not acquired.cancel():
                self.free.release()

    async def _acquire(self) -> None:
        await self.free.acquire()

    async def _wait(self, acquired: asyncio.Future[None], disconnected: asyncio.Future[None]) -> None:
        if self.free.locked() and self.room <= 0:
            raise Problem(503, "too many long requests wait already; try again")
        self.room -= 1
        try:
            await asyncio.wait({acquired, disconnected}, return_when=asyncio.FIRST_COMPLETED)
        finally:
            self.room += 1
        if not acquired.done():
            raise CancelledError("the work is cancelled: its client disconnected")
