"""uvicorn's sans-io WebSocket, which also disconnects a viewer that no longer reads.

A peer with full buffers blocks every `send`, and `close` too: uvicorn then waits for a flush that
never comes, and so does its shutdown. Only `transport.abort()` ends the connection (pipecat issue
5789 reports the same).
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Sequence

from uvicorn._types import ASGIReceiveEvent, ASGISendEvent
from uvicorn.protocols.utils import ClientDisconnected
from uvicorn.protocols.websockets.websockets_sansio_impl import WebSocketsSansIOProtocol
from websockets.exceptions import InvalidState

from statwalk.web.request_log import note_cut
from statwalk.web.socket.messages import CLOSE_CODES
from statwalk.web.turns import TURN_SECONDS

UNWRITABLE_SECONDS = 5.0
GOODBYE_SECONDS = 1.0
MOST_UNREAD = 4
"""messages of a viewer that wait for their turn, before the server stops reading what it sends"""


class ViewerProtocol(WebSocketsSansIOProtocol):
    """Aborts a connection that is not writable for 5 s, or that does not end 1 s after the close frame."""

    abort_timer: asyncio.TimerHandle | None = None
    give_back: Callable[[], None] | None = None
    """gives the place of the connection back"""
    leaving = False
    taken = 0.0
    """when the last message was taken, in seconds of the loop"""

    def _end_after(self, seconds: float, end: Callable[[], None]) -> None:
        """Calls `end`, which aborts the connection, after `seconds`, unless the timer runs already."""
        if self.abort_timer is None:
            self.abort_timer = self.loop.call_later(seconds, end)

    def _cut(self) -> None:
        """Aborts the connection of a peer that does not read; it counts as one that got the close code."""
        note_cut(self.scope, CLOSE_CODES["slow"], "slow")
        self.transport.abort()

    def stop_timer(self) -> None:
        """Stops the timer that aborts the connection."""
        if self.abort_timer is not None:
            self.abort_timer.cancel()
            self.abort_timer = None

    def leave(self) -> None:
        """Gives the peer a second to take the close frame, then aborts the connection."""
        self.stop_timer()
        self.leaving = True
        self._end_after(GOODBYE_SECONDS, self.transport.abort)

    def pause_writing(self) -> None:
        """Starts the timer: the buffers of the peer and of the server are full."""
        super().pause_writing()
        self._end_after(UNWRITABLE_SECONDS, self._cut)

    def resume_writing(self) -> None:
        """Stops the timer: the peer reads again."""
        super().resume_writing()
        if not self.leaving:
            self.stop_timer()

    async def send(self, message: ASGISendEvent) -> None:
        """Sends a message of the application; waits at most a second for the peer to take a close frame.

        A `websocket.send` may have `texts`, encoded: they and its `bytes` go out in one write.

        :raises ClientDisconnected: when the connection is closing.
        """
        if message["type"] == "websocket.send":
            if self.close_sent:
                raise ClientDisconnected
            self._queue(message.get("texts", []))  # type: ignore[arg-type]
        await super().send(message)
        if message["type"] == "websocket.close":
            self.leave()
        elif message["type"] == "websocket.http.response.body" and not message.get("more_body"):
            self.handshake_complete = True  # a refused upgrade is an answer too; uvicorn would log an error

    def _queue(self, texts: Sequence[bytes]) -> None:
        """Has the next write send the texts before all else.

        :raises ClientDisconnected: when the peer has closed the connection.
        """
        try:
            for text in texts:
                self.conn.send_text(text)
        except InvalidState:
            raise ClientDisconnected from None

    def send_receive_event_to_app(self) -> None:
        """Queues a message that has come whole, and stops reading when `MOST_UNREAD` wait.

        uvicorn stops after each message, which takes two system calls for every acknowledgement.
        """
        if self.read_paused or self.queue.qsize() >= MOST_UNREAD - 1:
            super().send_receive_event_to_app()
            return
        self.read_paused = True  # as far as uvicorn knows
        super().send_receive_event_to_app()
        self.read_paused = False

    async def receive(self) -> ASGIReceiveEvent:
        """Returns what the peer sends; between messages that came together, others have as much time as the
        last one took, as between requests (`web/turns`).
        """
        message = await super().receive()
        if not self.queue.empty():
            await asyncio.sleep(min(self.loop.time() - self.taken, TURN_SECONDS))
        self.taken = self.loop.time()
        return message

    def handle_parser_exception(self) -> None:
        """Closes the connection with the code that tells what is wrong with a frame."""
        if self.close_sent:
            self._discard_what_comes()
        else:
            self._close_in_order()

    def _close_in_order(self) -> None:
        """Sends the close frame, and discards for a second what the peer still sends.

        uvicorn closes at once; a socket that is closed with unread data is reset, and a reset takes the close
        frame from a peer that has not read it.
        """
        assert self.conn.close_sent is not None
        code, reason = self.conn.close_sent.code, self.conn.close_sent.reason
        self.queue.put_nowait({"type": "websocket.disconnect", "code": code, "reason": reason})
        self.transport.write(b"".join(self.conn.data_to_send()))
        self.close_sent = True
        self.leave()
        self.close_timer = self.abort_timer  # uvicorn does not close a connection that has this timer
        self._discard_what_comes()

    def _discard_what_comes(self) -> None:
        self.transport.resume_reading()
        if self.transport.can_write_eof():  # TLS cannot
            self.transport.write_eof()

    def keepalive_timeout(self) -> None:
        """Ends the connection: the peer does not answer pings, so that it does not read either, whatever it
        acknowledges.
        """
        if self.close_sent or self.transport.is_closing():
            return
        self.conn.send_close(CLOSE_CODES["slow"], "pings were not answered")
        self.transport.write(b"".join(self.conn.data_to_send()))
        self.close_sent = True
        self._cut()

    def shutdown(self) -> None:
        """Closes the connection with code 1012 when the server stops; aborts it if it is not writable."""
        if self.leaving:
            return  # it is being closed, and has a second for it
        if self.transport.is_closing() or not self.writable.is_set():
            self.transport.abort()
        elif not self.handshake_complete or self.close_sent:
            super().shutdown()
            self.leave()
        else:
            self.stop_keepalive()
            self.conn.send_close(1012)
            self._close_in_order()

    def connection_lost(self, exc: Exception | None) -> None:
        """Stops the timer: the connection is closed."""
        self.stop_timer()
        if self.give_back is not None:
            self.give_back()
        super().connection_lost(exc)
