"""Lets the requests of one client begin one after another.

Requests that begin at once keep the event loop for as long as they take together, and meanwhile nobody gets a
frame.
"""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

TURN_SECONDS = 0.005
"""after which the next request begins though the one before has no answer yet"""


class Turns:
    """The newest request of each client. Use it in the thread of the event loop only."""

    def __init__(self) -> None:
        self._newest: dict[str, asyncio.Event] = {}

    @asynccontextmanager
    async def of(self, client: str) -> AsyncIterator[None]:
        """Waits for the turn of a request, which lasts until the block ends, but at most `TURN_SECONDS`; no
        request without a client waits.
        """
        if not client:
            yield
            return
        before, over = self._newest.get(client), asyncio.Event()
        self._newest[client] = over
        try:
            if before is not None:
                await before.wait()
            timer = asyncio.get_running_loop().call_later(TURN_SECONDS, over.set)
            try:
                yield
            finally:
                timer.cancel()
        finally:
            over.set()
            if self._newest.get(client) is over:
                del self._newest[client]
