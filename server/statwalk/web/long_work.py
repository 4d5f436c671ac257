"""Limits how many long requests run at once, so that short requests find a free thread.

A request that waits holds no thread. Requests about one thing, such as one stage, wait for each other anyway:
they leave places to the others.
"""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

from statwalk.errors import CancelledError
from statwalk.web.errors import Problem

MOST_RUNNING = 4
MOST_WAITING = 32
MOST_ABOUT_ONE = 2
"""long requests about one thing that run at once"""
WAIT_SECONDS = 60.0


class _Waiter:
    """A request that waits for its place, or has it; `about` is empty if it is about nothing special."""

    def __init__(self, about: str) -> None:
        self.about = about
        self.has_place: asyncio.Future[None] = asyncio.get_running_loop().create_future()


class LongWork:
    """The places in which long requests run, and the queue before them; one for the server.

    Use it in the thread of the event loop only.
    """

    def __init__(
        self, running: int = MOST_RUNNING, waiting: int = MOST_WAITING, about_one: int = MOST_ABOUT_ONE
    ) -> None:
        self.most_running, self.most_waiting, self.most_about_one = running, waiting, about_one
        self._running: list[_Waiter] = []
        self._waiting: list[_Waiter] = []

    @property
    def running(self) -> int:
        """The number of requests that have a place."""
        return len(self._running)

    @property
    def waiting(self) -> int:
        """The number of requests that wait."""
        return len(self._waiting)

    @asynccontextmanager
    async def place(self, disconnected: asyncio.Future[None], about: str = "") -> AsyncIterator[None]:
        """Holds a place for one request, first come first served among those that may run; `disconnected` is
        done when its client disconnects, `about` says what the request is about.

        :raises Problem: 503, when too many requests wait already, or this one has waited too long.
        :raises CancelledError: when the client disconnects before a place is free.
        """
        waiter = _Waiter(about)
        self._waiting.append(waiter)
        self._fill()
        try:
            await self._wait(waiter, disconnected)
            yield
        finally:
            for requests in (self._running, self._waiting):
                if waiter in requests:
                    requests.remove(waiter)
            self._fill()

    async def _wait(self, waiter: _Waiter, disconnected: asyncio.Future[None]) -> None:
        if not waiter.has_place.done() and len(self._waiting) > self.most_waiting:
            raise _refusal("too many long requests wait already; try again")
        await asyncio.wait(
            {waiter.has_place, disconnected}, timeout=WAIT_SECONDS, return_when=asyncio.FIRST_COMPLETED
        )
        if waiter.has_place.done():
            return
        if disconnected.done():
            raise CancelledError("the work is cancelled: its client disconnected")
        raise _refusal(f"other long requests kept this one waiting for {WAIT_SECONDS:g} s; try again")

    def _fill(self) -> None:
        """Gives free places to those that wait."""
        for waiter in [*self._waiting]:
            if len(self._running) < self.most_running and self._may_run(waiter.about):
                self._waiting.remove(waiter)
                self._running.append(waiter)
                waiter.has_place.set_result(None)

    def _may_run(self, about: str) -> bool:
        return not about or sum(other.about == about for other in self._running) < self.most_about_one


def _refusal(detail: str) -> Problem:
    return Problem(503, detail, headers={"Retry-After": "1"}, limit="long requests")
