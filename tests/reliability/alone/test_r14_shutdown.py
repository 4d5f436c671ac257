"""R-14: a server that is told to stop says so at once, and is gone in five seconds whatever clients do."""

import signal
import socket
import subprocess
import time
from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import ExitStack, contextmanager
from http.client import HTTPConnection, HTTPException
from pathlib import Path

import httpx
import pytest
from processes import served
from serving import PATIENCE, open_and_never_read, wait_for
from watcher import Watcher
from websockets.exceptions import ConnectionClosed

MAIN = "/api/stages/main"
UPLOAD = (
    "PUT /api/characters/robot HTTP/1.1\r\nHost: localhost\r\nContent-Type: model/gltf-binary\r\n"
    "Content-Length: 1000\r\n\r\nglT"
)


WAITS_FOR_CLIENTS = """
import uvicorn
from uvicorn.protocols.http.h11_impl import H11Protocol
from statwalk.web import client_protocol, server, shutdown
client_protocol.ClientProtocol.shutdown = H11Protocol.shutdown
server.GRACE_SECONDS, shutdown._end_process_after = None, lambda seconds: None
shutdown.Server.shutdown = uvicorn.Server.shutdown
shutdown.Server.handle_exit = uvicorn.Server.handle_exit
"""
"""a server that stops as uvicorn does by itself"""


@contextmanager
def in_use(folder: Path, change: str = "") -> Iterator[tuple[subprocess.Popen[str], str, list[Future[int]]]]:
    """A server with viewers that read, viewers that never read, and an upload that does not go on.

    Yields the codes with which the connections of the viewers that read will be closed.
    """
    with served("--data", str(folder), change=change) as (process, address), ExitStack() as opened:
        host, port = address.split(":")
        for _ in range(2):
            opened.enter_context(open_and_never_read(address, f"{MAIN}/stream?frames=glb"))
        upload = opened.enter_context(socket.create_connection((host, int(port))))
        upload.sendall(UPLOAD.encode())
        readers = opened.enter_context(ThreadPoolExecutor())
        codes = [readers.submit(close_code, Watcher(address, MAIN)) for _ in range(3)]
        held = httpx.Client(base_url=f"http://{address}", timeout=PATIENCE)
        wait_for(lambda: 'statwalk_held{what="uploads"} 1.0' in held.get("/metrics").text)
        held.close()
        yield process, address, codes


def close_code(viewer: Watcher) -> int:
    with pytest.raises(ConnectionClosed) as closed:
        viewer.text("nothing")
    assert closed.value.rcvd is not None
    return closed.value.rcvd.code


def status_of(address: str, path: str) -> int:
    """The status of an answer; 0 when nobody listens any more. Quickly: the server listens for a second."""
    connection = HTTPConnection(address, timeout=PATIENCE)
    try:
        connection.request("GET", path)
        return connection.getresponse().status
    except (OSError, HTTPException):
        return 0
    finally:
        connection.close()


def next_readiness(address: str) -> int:
    """What /readyz answers when it no longer says that the server is ready."""
    while (status := status_of(address, "/readyz")) == 200:
        pass
    return status


def test_it_says_that_it_is_not_ready_and_is_gone_within_five_seconds(tmp_path: Path) -> None:
    with in_use(tmp_path) as (process, address, codes):
        assert status_of(address, "/readyz") == 200
        process.send_signal(signal.SIGTERM)
        asked = time.monotonic()
        assert next_readiness(address) == 503
        assert status_of(address, MAIN) == 503
        assert {code.result() for code in codes} == {1012}
        assert process.wait(PATIENCE) == 0
        assert time.monotonic() - asked < 10  # it ends the process after 4.5 s; a busy system takes its time


def readiness_on(held: HTTPConnection) -> int:
    """What a connection is told that stays open."""
    held.request("GET", "/readyz")
    with held.getresponse() as answer:
        answer.read()
        return answer.status


def test_a_connection_that_stands_idle_is_not_cut_but_answered(tmp_path: Path) -> None:
    with in_use(tmp_path) as (process, address, codes):
        held = HTTPConnection(address, timeout=PATIENCE)
        assert readiness_on(held) == 200
        held.auto_open = 0  # it would come back on another connection
        process.send_signal(signal.SIGTERM)
        assert codes[0].result() == 1012
        assert readiness_on(held) == 503
        held.close()


def test_a_server_that_waits_for_its_clients_is_found_out(tmp_path: Path) -> None:
    """The control."""
    with in_use(tmp_path, WAITS_FOR_CLIENTS) as (process, address, _):
        process.send_signal(signal.SIGTERM)
        assert next_readiness(address) != 503
        with pytest.raises(subprocess.TimeoutExpired):
            process.wait(6)


def test_a_second_signal_ends_it_within_a_second(tmp_path: Path) -> None:
    with in_use(tmp_path) as (process, address, _):
        process.send_signal(signal.SIGTERM)
        assert next_readiness(address) == 503
        asked = time.monotonic()
        process.send_signal(signal.SIGTERM)
        assert process.wait(PATIENCE) == 0
        assert time.monotonic() - asked < 2.5  # 0.8 s, and the rest is the system's; after one: 3 s
