"""Lets the requests of one client begin one after another.

Requests that begin at once keep the event loop for as long as they take together, and meanwhile nobody gets a
frame. A client that always has a request waiting would keep it busy all the same: between two requests others
have as much time as the last one took.
"""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

TURN_SECONDS = 0.01
"""after which the next request begins though the one before has no answer yet"""


class Turns:
    """The newest request of each client. Use it in the thread of the event loop only."""

    def __init__(self) -> None:
        self._newest: dict[str, asyncio.Event] = {}

    @asynccontextmanager
    async def of(self, client: str) -> AsyncIterator[None]:
        """Waits for the turn of a request, which lasts twice as long as the block, but at most
        `TURN_SECONDS`; no request without a client waits.
        """
        if not client:
            yield
            return
        loop = asyncio.get_running_loop()
        before, over = self._newest.get(client), asyncio.Event()
        self._newest[client] = over
        pause = 0.0
        try:
            if before is not None:
                await before.wait()
            began = loop.time()
            loop.call_later(TURN_SECONDS, over.set)
            try:
                yield
            finally:
                pause = loop.time() - began
        finally:
            if self._newest.get(client) is over:
                del self._newest[client]
            loop.call_later(pause, over.set)
