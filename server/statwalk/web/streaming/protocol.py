"""uvicorn's sans-io WebSocket, able to let go of a viewer that reads no more.

A peer whose buffers are full blocks every `send`, and `close` too: uvicorn then waits for a flush that never comes, and so does
its shutdown. Only `transport.abort()` ends it (see pipecat issue 5789 for the same finding).
"""

from __future__ import annotations

import asyncio

from uvicorn._types import ASGISendEvent
from uvicorn.protocols.websockets.websockets_sansio_impl import WebSocketsSansIOProtocol

UNWRITABLE_SECONDS = 5.0
GOODBYE_SECONDS = 1.0


class ViewerProtocol(WebSocketsSansIOProtocol):
    """Cuts a connection that was not writable for 5 s, or that does not end within 1 s of a goodbye."""

    abort_timer: asyncio.TimerHandle | None = None
    leaving = False

    def abort_after(self, seconds: float) -> None:
        """Starts the timer that ends the connection without a goodbye, unless it runs."""
        if self.abort_timer is None:
            self.abort_timer = self.loop.call_later(seconds, self.transport.abort)

    def keep(self) -> None:
        """Stops the timer."""
        if self.abort_timer is not None:
            self.abort_timer.cancel()
            self.abort_timer = None

    def leave(self) -> None:
        """A goodbye was said; the peer has a second to take it."""
        self.keep()
        self.leaving = True
        self.abort_after(GOODBYE_SECONDS)

    def pause_writing(self) -> None:
        """The peer's buffers and ours are full."""
        super().pause_writing()
        self.abort_after(UNWRITABLE_SECONDS)

    def resume_writing(self) -> None:
        """The peer reads again."""
        super().resume_writing()
        if not self.leaving:
            self.keep()

    async def send(self, message: ASGISendEvent) -> None:
        """What the application sends; its close is waited for no longer than a second."""
        await super().send(message)
        if message["type"] == "websocket.close":
            self.leave()
        elif message["type"] == "websocket.http.response.body" and not message.get("more_body"):
            self.handshake_complete = True  # a refusal is an answer too; uvicorn would log an error

    def keepalive_timeout(self) -> None:
        """The peer does not answer pings."""
        super().keepalive_timeout()
        self.leave()

    def shutdown(self) -> None:
        """The server stops: close code 1012, and no waiting for those that cannot take it."""
        if self.transport.is_closing() or not self.writable.is_set():
            self.transport.abort()
            return
        super().shutdown()
        self.leave()

    def connection_lost(self, exc: Exception | None) -> None:
        """The connection is over."""
        self.keep()
        super().connection_lost(exc)
