"""A real server on a free port, and clients that behave and misbehave."""

import base64
import os
import socket
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from statwalk.services.limits import Limits
from statwalk.web import server as listen

PATIENCE = 60.0
"""seconds for what a quiet machine does in two: another may be slow, and busy with other tests"""


@contextmanager
def serving(app: Any, limits: Limits | None = None) -> Iterator[str]:
    """Serves `app` in a thread; gives `127.0.0.1:PORT`. Stops it in good order."""
    listener = listen.listening_socket("127.0.0.1", 0)
    server = listen.server(app, limits)
    thread = threading.Thread(target=server.run, kwargs={"sockets": [listener]}, daemon=True)
    address = f"127.0.0.1:{listener.getsockname()[1]}"
    thread.start()
    try:
        wait_for(lambda: server.started)
        yield address
    finally:
        server.should_exit = True
        thread.join(PATIENCE)
        assert not thread.is_alive(), "the server did not stop"


def wait_for(condition: Any, seconds: float = PATIENCE) -> None:
    """Until something outside of this process's control is so."""
    until = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < until, f"{condition} took longer than {seconds} s"
        time.sleep(0.005)


def open_and_never_read(address: str, path: str) -> socket.socket:
    """A WebSocket client that shakes hands, reads its answer's first bytes, and then nothing for ever."""
    host, port = address.split(":")
    client = socket.socket()
    client.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
    client.connect((host, int(port)))
    key = base64.b64encode(os.urandom(16)).decode()
    client.sendall(
        f"GET {path} HTTP/1.1\r\nHost: {address}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
        f"Sec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n\r\n".encode()
    )
    assert b"101" in client.recv(16)
    return client
