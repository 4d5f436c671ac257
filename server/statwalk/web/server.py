"""Runs the application with uvicorn, with limits for stalled viewers."""

from __future__ import annotations

import gc
import signal
import socket
import sys
import threading
from functools import partial
from pathlib import Path
from types import FrameType
from typing import NamedTuple

import uvicorn
from starlette.types import ASGIApp, Receive, Scope, Send

from statwalk.services.limits import Limits
from statwalk.web.client_protocol import ClientProtocol
from statwalk.web.connections import Connections
from statwalk.web.dependencies import CONNECTIONS, ENDING
from statwalk.web.settings import LARGEST_MESSAGE_BYTES
from statwalk.web.shutdown import GRACE_SECONDS, Server
from statwalk.web.socket.protocol import ViewerProtocol

try:
    import resource
except ImportError:  # Windows has no such limits
    resource = None  # type: ignore[assignment]

OTHER_FILES = 256
SEND_BUFFER_BYTES = 128 << 10  # a viewer that was stalled first gets this much of old frames at most
DEAD_PEER_MILLISECONDS = 10_000
PING_SECONDS, PONG_SECONDS = 1.0, 4.0
"""how often a viewer is asked whether it reads, and how long it may take to answer"""
MOST_CONNECTIONS = 2_000
"""connections, and requests that run, at once"""
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


def _with_server(app: ASGIApp, ending: threading.Event, connections: Connections) -> ASGIApp:
    """Returns the application with the event `ending` and the connections in the scope of every request."""

    async def app_with_server(scope: Scope, receive: Receive, send: Send) -> None:
        await app({**scope, ENDING: ending, CONNECTIONS: connections}, receive, send)

    return app_with_server


class TlsFiles(NamedTuple):
    """A certificate (with those between it and the root) and its private key, as PEM."""

    certificate: Path
    key: Path


def server(app: ASGIApp, limits: Limits | None = None, tls: TlsFiles | None = None) -> uvicorn.Server:
    """Returns a uvicorn server with `ViewerProtocol`, without compression; its stop does not wait for stalled
    viewers.

    It uses asyncio's own loop, whose timers are finer than uvloop's milliseconds.
    """
    ending, connections = threading.Event(), Connections(limits or Limits())
    return Server(
        uvicorn.Config(
            _with_server(app, ending, connections),
            loop="asyncio",
            http=partial(ClientProtocol, places=connections),  # type: ignore[arg-type]
            ws=ViewerProtocol,
            ws_max_size=LARGEST_MESSAGE_BYTES,
            ws_per_message_deflate=False,
            ws_ping_interval=PING_SECONDS,
            ws_ping_timeout=PONG_SECONDS,
            timeout_graceful_shutdown=GRACE_SECONDS,
            limit_concurrency=MOST_CONNECTIONS,
            server_header=False,
            proxy_headers=False,
            access_log=False,
            log_config=None,
            log_level="warning",
            ssl_certfile=tls.certificate if tls else None,
            ssl_keyfile=tls.key if tls else None,
        ),
        ending,
    )


def _allow_connections() -> None:
    """Lets this process open as many files as it may have connections, if the system allows it."""
    if resource is not None:
        soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
        wanted = MOST_CONNECTIONS + OTHER_FILES
        if hard != resource.RLIM_INFINITY:
            wanted = min(wanted, hard)
        if soft != resource.RLIM_INFINITY and soft < wanted:
            resource.setrlimit(resource.RLIMIT_NOFILE, (wanted, hard))


def run(
    app: ASGIApp, listener: socket.socket, limits: Limits | None = None, tls: TlsFiles | None = None
) -> None:
    """Serves until SIGTERM or SIGINT, then shuts down cleanly."""

    uvicorn_server = server(app, limits, tls)

    def stop(_: int, __: FrameType | None) -> None:
        """Handles a signal before uvicorn installs its own handlers; later uvicorn raises each signal again,
        which then has no effect.
        """
        uvicorn_server.should_exit = True

    _allow_connections()
    sys.setswitchinterval(SWITCH_SECONDS)
    gc.freeze()  # what is loaded now stays: a full collection that looks at it stops all threads for 0.1 s
    for number in (signal.SIGTERM, signal.SIGINT):
        signal.signal(number, stop)
    uvicorn_server.run(sockets=[listener])
