"""uvicorn's HTTP protocol, which also ends connections that send or read too slowly, or are too many.

uvicorn waits for ever for the first byte, for the rest of a header or a body, and for a client to read. While
an application works on a request, uvicorn keeps all that the client sends.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Any

import h11
import orjson
from uvicorn.protocols.http.flow_control import FlowControl
from uvicorn.protocols.http.h11_impl import H11Protocol, RequestResponseCycle

from statwalk.web.connections import Connections, Seat
from statwalk.web.errors import MEDIA_TYPE, members
from statwalk.web.socket.protocol import ViewerProtocol

WINDOW_SECONDS = 10.0
"""in each such window a body must bring `body_rate` bytes a second"""
UNREAD_SECONDS = 30.0
SOCKET_BYTES = 4_096
"""of a socket, read at once: uvicorn parses them all before any viewer gets its next frame"""
LATE_HEADER = "the header took too long; send it at once"
LATE_BODY = "the body came too slowly; send it faster, or in a smaller file"
STOPS = "the server stops; try again"
TOO_MANY = "your address has too many connections; close some, or send requests one after another on one"


class _RequestByRequest(FlowControl):
    """Stops reading while the next request waits for the answer to the request before it."""

    def __init__(self, transport: asyncio.Transport, conn: h11.Connection) -> None:
        super().__init__(transport)
        self._conn = conn

    def resume_reading(self) -> None:
        """Reads on, unless the next request waits for the answer to this one: an application asks for more
        even when it has the whole body.
        """
        conn = self._conn
        waits = conn.their_state is h11.DONE and conn.our_state is not h11.DONE
        if not (waits and conn.trailing_data[0]):
            super().resume_reading()


class ClientProtocol(H11Protocol):
    """One connection, with a timer for what the client has to do next."""

    def __init__(self, *arguments: Any, places: Connections, **options: Any) -> None:
        super().__init__(*arguments, **options)
        self.places = places
        self.place: Seat | None = None
        self.received = self.received_before = 0
        self.awaited = ""
        self.timer: asyncio.TimerHandle | None = None
        self.unread_timer: asyncio.TimerHandle | None = None

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Takes a place, and waits for a header; refuses the connection if there is no place."""
        super().connection_made(transport)
        self.flow = _RequestByRequest(transport, self.conn)
        self.place = self.places.open(self.client, transport)
        if self.place is None:
            self._refuse(429, TOO_MANY)
        else:
            self._await("header")

    def data_received(self, data: bytes) -> None:
        """Takes what the client sends."""
        if self.place is None or self.transport.is_closing():
            return
        self.received += len(data)
        super().data_received(data)
        self._look()

    def on_response_complete(self) -> None:
        """Waits for the next request."""
        super().on_response_complete()
        self._look()

    def handle_websocket_upgrade(self, event: h11.Request) -> None:
        """Hands the connection and its place over to the protocol of sockets."""
        self._await("")
        super().handle_websocket_upgrade(event)
        viewer = self.transport.get_protocol()
        if self.place is not None and isinstance(viewer, ViewerProtocol):
            self.transport.max_size = SOCKET_BYTES  # type: ignore[attr-defined]
            self.place.busy = True
            viewer.give_back = self._give_back

    def connection_lost(self, exc: Exception | None) -> None:
        """Stops the timers, and gives the place back."""
        self._await("")
        self._stop_unread()
        self._give_back()
        super().connection_lost(exc)

    @property
    def is_idle(self) -> bool:
        """Whether no request is under way; one may be on its way."""
        return self.awaited == "header"

    def shutdown(self) -> None:
        """Refuses a request whose body has not come whole: the server that stops does not wait for it."""
        if self.awaited == "body":
            self._refuse(503, STOPS)
        super().shutdown()

    def pause_writing(self) -> None:
        """Gives the client a while to read what it asked for."""
        super().pause_writing()
        self.unread_timer = self.loop.call_later(UNREAD_SECONDS, self.transport.abort)

    def resume_writing(self) -> None:
        """The client reads."""
        super().resume_writing()
        self._stop_unread()

    def _stop_unread(self) -> None:
        if self.unread_timer is not None:
            self.unread_timer.cancel()
            self.unread_timer = None

    def _give_back(self) -> None:
        if self.place is not None:
            self.places.close(self.place)

    def _look(self) -> None:
        """Waits for what the client has to send next: a header, the rest of a body, or nothing."""
        if self.transport.get_protocol() is not self:
            return  # a socket by now, for which h11 still waits for a body
        state = self.conn.their_state
        self._await({h11.IDLE: "header", h11.SEND_BODY: "body"}.get(state, ""))
        if self.place is not None:
            self.place.busy = state is not h11.IDLE

    def _await(self, what: str) -> None:
        """Starts the timer for a header or a body, or (empty) stops it; a timer that runs for it goes on."""
        if what == self.awaited:
            return
        self.awaited, self.received_before = what, self.received
        if self.timer is not None:
            self.timer.cancel()
            self.timer = None
        if what == "header":
            self._after(self.places.limits.header_seconds, self._end_header)
        elif what == "body":
            self._after(WINDOW_SECONDS, self._end_window)

    def _after(self, seconds: float, act: Callable[[], None]) -> None:
        self.timer = self.loop.call_later(seconds, act)

    def _end_header(self) -> None:
        self.places.timed_out += 1
        if self.received > self.received_before:
            self._refuse(408, LATE_HEADER)
        else:
            self.transport.close()  # it has asked for nothing

    def _end_window(self) -> None:
        """Looks what the body brought in a window; a window in which the application did not read counts as
        full.
        """
        came = self.received - self.received_before
        if self.flow.read_paused or came >= self.places.limits.body_rate * WINDOW_SECONDS:
            self.received_before = self.received
            self._after(WINDOW_SECONDS, self._end_window)
            return
        self.places.timed_out += 1
        self._refuse(408, LATE_BODY)

    def _refuse(self, status: int, detail: str) -> None:
        """Answers with a problem unless the request has its answer, and closes the connection."""
        cycle: RequestResponseCycle | None = self.cycle
        if self.awaited != "body" or (cycle and not cycle.response_started):
            self.transport.write(_raw_problem(status, detail))
        self.transport.close()


def _raw_problem(status: int, detail: str) -> bytes:
    """Returns a whole answer: there may be no request yet that the application could answer."""
    problem = members(status, detail)
    body = orjson.dumps(problem)
    head = (
        f"HTTP/1.1 {status} {problem['title']}\r\nContent-Type: {MEDIA_TYPE}\r\n"
        f"Content-Length: {len(body)}\r\nRetry-After: 1\r\nConnection: close\r\n\r\n"
    )
    return head.encode() + body
