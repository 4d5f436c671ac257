"""Stops a server: it says at once that it is not ready, ends what runs, and is gone after five seconds."""

from __future__ import annotations

import asyncio
import logging
import os
import socket
import threading
from types import FrameType

import uvicorn

from statwalk.web.client_protocol import ClientProtocol

DRAIN_SECONDS = 1.0
"""for which a server that stops still answers, above all that it is not ready"""
GRACE_SECONDS = 2
"""after which the requests that still run are cancelled"""
LAST_SECONDS, LAST_SECONDS_AFTER_SECOND_SIGNAL = 4.5, 0.8
"""after which the process ends whatever its threads do; what was acknowledged is kept"""
LOOK_SECONDS = 0.02
log = logging.getLogger("statwalk.shutdown")


class Server(uvicorn.Server):
    """A uvicorn server that sets `ending` as soon as it shall stop, so that long requests are cancelled, and
    that stays no longer than it says.
    """

    loop: asyncio.AbstractEventLoop | None = None

    def __init__(self, config: uvicorn.Config, ending: threading.Event) -> None:
        super().__init__(config)
        self.ending = ending

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        """Starts to listen."""
        self.loop = asyncio.get_running_loop()
        await super().startup(sockets)

    def handle_exit(self, sig: int, frame: FrameType | None) -> None:
        """Handles a signal: the first one stops the server in good order, a second one at once."""
        if self.should_exit:
            self.force_exit = True
        _end_process_after(LAST_SECONDS_AFTER_SECOND_SIGNAL if self.force_exit else LAST_SECONDS)
        if self.loop is not None:
            self.loop.call_soon_threadsafe(self.ending.set)
        super().handle_exit(sig, frame)

    async def shutdown(self, sockets: list[socket.socket] | None = None) -> None:
        """Cancels long requests, disconnects viewers, and waits for the other requests."""
        is_told = self.ending.is_set()
        self.ending.set()
        await self._drain(is_told)
        await super().shutdown(sockets)

    async def _drain(self, is_told: bool) -> None:
        """Waits a moment for the requests that run; new ones are answered meanwhile, with a refusal.

        `is_told`: by a signal. Whoever was connected may then ask for the whole moment whether it is ready.
        """
        running, connections = list(self.server_state.tasks), list(self.server_state.connections)
        for connection in connections:
            if not (isinstance(connection, ClientProtocol) and connection.is_idle):
                connection.shutdown()
        until = asyncio.get_running_loop().time() + DRAIN_SECONDS
        while not self.force_exit and asyncio.get_running_loop().time() < until:
            if all(task.done() for task in running) and not (is_told and connections):
                return
            await asyncio.sleep(LOOK_SECONDS)


def _end_process_after(seconds: float) -> None:
    """Ends the process after a while, in which it should have ended by itself."""

    def end() -> None:
        log.warning("threads still run; the process ends without them")
        logging.shutdown()
        os._exit(0)

    timer = threading.Timer(seconds, end)
    timer.daemon = True
    timer.start()
