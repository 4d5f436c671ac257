"""Runs the application on a socket of this machine, with the limits that a stalled viewer needs."""

from __future__ import annotations

import signal
import socket
import sys
from types import FrameType

import uvicorn
from starlette.types import ASGIApp

from statwalk.web.settings import LARGEST_MESSAGE_BYTES
from statwalk.web.streaming.protocol import ViewerProtocol

SEND_BUFFER_BYTES = 128 << 10  # a viewer that wakes up sees at most this much of the past
DEAD_PEER_MILLISECONDS = 10_000
GRACE_SECONDS = 3
SWITCH_SECONDS = 0.0005  # the pacer's thread gets its turn while the loop sends to many viewers


def listening_socket(host: str, port: int) -> socket.socket:
    """A TCP socket; the connections that it accepts inherit its options.

    :raises OSError: if the address is in use or not of this machine.
    """
    listener = socket.socket(socket.AF_INET6 if ":" in host else socket.AF_INET, socket.SOCK_STREAM)
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


def server(app: ASGIApp) -> uvicorn.Server:
    """uvicorn with our WebSocket protocol, no compression, and a stop that does not wait for stalled viewers.

    asyncio's own loop: it paces better than uvloop, whose clock ticks in milliseconds.
    """
    return uvicorn.Server(
        uvicorn.Config(
            app,
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
        )
    )


def run(app: ASGIApp, listener: socket.socket) -> None:
    """Serves until SIGTERM or SIGINT; both end it in good order."""

    serving = server(app)

    def stopped(_: int, __: FrameType | None) -> None:
        """Before uvicorn listens for signals, they end it too; once it has stopped, it raises them again, to no effect."""
        serving.should_exit = True

    sys.setswitchinterval(SWITCH_SECONDS)
    for number in (signal.SIGTERM, signal.SIGINT):
        signal.signal(number, stopped)
    serving.run(sockets=[listener])
