"""Runs the application with uvicorn, with limits for stalled viewers."""

from __future__ import annotations

import gc
import signal
import socket
import sys
import threading
from types import FrameType

import uvicorn
from starlette.types import ASGIApp, Receive, Scope, Send

from statwalk.web.dependencies import ENDING
from statwalk.web.settings import LARGEST_MESSAGE_BYTES
from statwalk.web.socket.protocol import ViewerProtocol

SEND_BUFFER_BYTES = 128 << 10  # a viewer that was stalled first gets this much of old frames at most
DEAD_PEER_MILLISECONDS = 10_000
GRACE_SECONDS = 3
SWITCH_SECONDS = 0.0005  # lets the ticker's thread run while the event loop sends to many viewers


def listening_socket(host: str, port: int) -> socket.socket:
    """Returns a listening TCP socket; the connections that it accepts inherit its options.

    :raises OSError: when the address is in use, or is no address of this computer.
    """
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    listener = socket.socket(
        family, socket.SOCK_STREAM, socket.IPPROTO_TCP
    )  # only where TCP is named does asyncio set TCP_NODELAY
    try:
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, SEND_BUFFER_BYTES)
        if hasattr(socket, "TCP_USER_TIMEOUT"):
            listener.setsockopt(socket.IPPROTO_TCP, socket.TCP_USER_TIMEOUT, DEAD_PEER_MILLISECONDS)
        listener.bind((host, port))
        listener.listen(128)
    except OSError:
        listener.close()
        raise
    return listener


class Server(uvicorn.Server):
    """A uvicorn server that sets `ending` when it stops, so that long requests are cancelled."""

    def __init__(self, config: uvicorn.Config, ending: threading.Event) -> None:
        super().__init__(config)
        self.ending = ending

    async def shutdown(self, sockets: list[socket.socket] | None = None) -> None:
        """Cancels long requests, then waits for the running requests."""
        self.ending.set()
        await super().shutdown(sockets)


def _with_ending(app: ASGIApp, ending: threading.Event) -> ASGIApp:
    """Returns the application with the event `ending` in the scope of every request."""

    async def app_with_ending(scope: Scope, receive: Receive, send: Send) -> None:
        await app({**scope, ENDING: ending}, receive, send)

    return app_with_ending


def server(app: ASGIApp) -> uvicorn.Server:
    """Returns a uvicorn server with `ViewerProtocol`, without compression; its stop does not wait for stalled
    viewers.

    It uses asyncio's own loop, whose timers are finer than uvloop's milliseconds.
    """
    ending = threading.Event()
    return Server(
        uvicorn.Config(
            _with_ending(app, ending),
            loop="asyncio",
            ws=ViewerProtocol,
            ws_max_size=LARGEST_MESSAGE_BYTES,
            ws_per_message_deflate=False,
            timeout_graceful_shutdown=GRACE_SECONDS,
            limit_concurrency=1_000,
            server_header=False,
            proxy_headers=False,
            access_log=False,
            log_level="warning",
        ),
        ending,
    )


def run(app: ASGIApp, listener: socket.socket) -> None:
    """Serves until SIGTERM or SIGINT, then shuts down cleanly."""

    uvicorn_server = server(app)

    def stop(_: int, __: FrameType | None) -> None:
        """Handles a signal before uvicorn installs its own handlers; later uvicorn raises each signal again,
        which then has no effect.
        """
        uvicorn_server.should_exit = True

    sys.setswitchinterval(SWITCH_SECONDS)
    gc.freeze()  # what is loaded now stays: a full collection that looks at it stops all threads for 0.1 s
    for number in (signal.SIGTERM, signal.SIGINT):
        signal.signal(number, stop)
    uvicorn_server.run(sockets=[listener])
