"""Connections that stand idle or are slow end; of too many from one address one makes room, or one waits."""

import logging
import re
import select
import socket
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

import httpx
import pytest
from serving import open_and_never_read, serving, wait_for
from statwalk.services.limits import Limits
from statwalk.web import client_protocol
from statwalk.web.app import create_app
from statwalk.web.settings import Settings
from statwalk.web.socket.protocol import ViewerProtocol
from watcher import Watcher

HALF_HEADER = b"GET /healthz HTTP/1.1\r\nHost: localhost\r\n"
PATIENT = 60.0
SOON = 1.5
"""seconds in which a busy computer sends and answers a request"""


@contextmanager
def limited(tmp_path: Path, **limits: Any) -> Iterator[tuple[str, Any]]:
    """A server with such limits: its address, and the state of its app."""
    chosen = Limits(**limits)
    app: Any = create_app(Settings(limits=chosen, data=tmp_path, main_stage=False))
    with serving(app, chosen) as address:
        yield address, app.app.app.state


def dial(address: str, sent: bytes = b"") -> socket.socket:
    """A connection that has sent so much."""
    host, port = address.split(":")
    client = socket.create_connection((host, int(port)), timeout=PATIENT)
    client.sendall(sent)
    return client


def until_closed(client: socket.socket) -> bytes:
    """What the server says before it closes the connection."""
    said = b""
    with client:
        while part := client.recv(4096):
            said += part
    return said


def test_who_asks_for_nothing_is_closed(tmp_path: Path) -> None:
    with limited(tmp_path, header_seconds=0.2) as (address, _):
        assert until_closed(dial(address)) == b""


def test_half_a_header_is_a_408(tmp_path: Path) -> None:
    with limited(tmp_path, header_seconds=SOON) as (address, _):
        said = until_closed(dial(address, HALF_HEADER))
    assert said.startswith(b"HTTP/1.1 408 Request Timeout\r\n")
    assert b"application/problem+json" in said


def test_half_a_second_header_is_a_408_too(tmp_path: Path) -> None:
    with limited(tmp_path, header_seconds=SOON) as (address, _):
        client = dial(address, HALF_HEADER + b"\r\n")
        assert client.recv(4096).startswith(b"HTTP/1.1 200 OK\r\n")
        client.sendall(HALF_HEADER)
        assert b"HTTP/1.1 408 Request Timeout\r\n" in until_closed(client)


UPLOAD = (
    b"PUT /api/characters/robot HTTP/1.1\r\nHost: localhost\r\nContent-Type: model/gltf-binary\r\n"
    b"Content-Length: 1000\r\n\r\nglT"
)


def test_a_body_that_does_not_come_leaves_its_place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Eight uploads of 3 bytes hold all places, but not for long."""
    monkeypatch.setattr(client_protocol, "WINDOW_SECONDS", SOON)
    with limited(tmp_path) as (address, state):
        clients = [dial(address, UPLOAD) for _ in range(8)]
        wait_for(lambda: hasattr(state, "upload_limiter") and state.upload_limiter.arriving > 0)
        said = [until_closed(client) for client in clients]
        wait_for(lambda: state.upload_limiter.arriving == 0)
    assert all(answer.startswith(b"HTTP/1.1 408 Request Timeout\r\n") for answer in said)


def test_a_request_that_has_its_answer_gets_no_second_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The name is refused before the body is read."""
    monkeypatch.setattr(client_protocol, "WINDOW_SECONDS", SOON)
    with limited(tmp_path) as (address, _):
        said = until_closed(dial(address, UPLOAD.replace(b"robot", b".robot")))
    assert said.startswith(b"HTTP/1.1 422")
    assert said.count(b"HTTP/1.1") == 1


def test_a_body_that_has_not_come_when_the_server_stops_is_refused(
    tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    log = logging.getLogger("uvicorn.error")
    log.addHandler(caplog.handler)
    with limited(tmp_path) as (address, state):
        client = dial(address, UPLOAD)
        wait_for(lambda: hasattr(state, "upload_limiter") and state.upload_limiter.arriving > 0)
    log.removeHandler(caplog.handler)
    said = until_closed(client)
    assert said.startswith(b"HTTP/1.1 503 Service Unavailable\r\n")
    assert b"the server stops" in said
    assert caplog.messages == []


def test_a_body_that_comes_fast_enough_has_time(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(client_protocol, "WINDOW_SECONDS", 0.2)
    windows: list[int] = []
    end_window = client_protocol.ClientProtocol._end_window

    def counted(protocol: client_protocol.ClientProtocol) -> None:
        windows.append(protocol.received)
        end_window(protocol)

    monkeypatch.setattr(client_protocol.ClientProtocol, "_end_window", counted)
    with limited(tmp_path, body_rate=0.0) as (address, _), dial(address, UPLOAD) as client:
        wait_for(lambda: len(windows) >= 3)
        client.sendall(b"x" * 997)
        assert client.recv(12) == b"HTTP/1.1 422"  # it came whole, and is no model


def test_a_socket_is_no_body_that_comes_too_slowly(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(client_protocol, "WINDOW_SECONDS", 0.1)
    with limited(tmp_path, header_seconds=SOON) as (address, _):
        stage = httpx.post(
            f"http://{address}/api/stages", json={"actors": [{"machine": "faq-walker"}]}, timeout=PATIENT
        )
        with Watcher(address, stage.headers["location"]) as viewer:
            assert viewer.frame_from(viewer.frame().tick + 150)


def test_an_idle_connection_makes_room_for_a_new_one(tmp_path: Path) -> None:
    with limited(tmp_path, connections=3, header_seconds=PATIENT) as (address, _), ExitStack() as open_ones:
        idle = [open_ones.enter_context(dial(address)) for _ in range(10)]
        assert httpx.get(f"http://{address}/healthz", timeout=PATIENT).status_code == 200
        assert idle[0].recv(1) == b""
        metrics = httpx.get(f"http://{address}/metrics", timeout=PATIENT).text
    closed = re.search(r'statwalk_connections_closed_total\{why="idle"\} (\d+)', metrics)
    assert closed
    assert int(closed[1]) >= 8


def test_where_all_are_in_use_one_more_is_told_to_wait(tmp_path: Path) -> None:
    with limited(tmp_path, connections=3, stages=5) as (address, _):
        stage = httpx.post(f"http://{address}/api/stages", json={}, timeout=PATIENT).headers["location"]
        viewers = [open_and_never_read(address, f"{stage}/stream") for _ in range(3)]
        said = until_closed(dial(address))
        assert said.startswith(b"HTTP/1.1 429 Too Many Requests\r\n")
        viewers[0].close()
        wait_for(lambda: b"429" not in _answer(address))
        for viewer in viewers:
            viewer.close()


def _answer(address: str) -> bytes:
    with dial(address, HALF_HEADER + b"Connection: close\r\n\r\n") as client:
        try:
            return client.recv(64)
        except ConnectionResetError:
            return b"429, and what was sent is lost"


POST = (
    b"POST /api/stages/none/events HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n"
    b"Content-Length: 19\r\n\r\n" + b'{"event":"FORWARD"}'
)


def test_what_is_sent_before_an_answer_waits_with_the_client(tmp_path: Path) -> None:
    """After 100 answers, the server has read no more than it had at the first one: the system's buffers, and
    one read of asyncio's.
    """
    with limited(tmp_path, requests=1e6) as (address, _), dial(address) as client:
        client.setblocking(False)
        sent, answers = 0, b""
        while answers.count(b"HTTP/1.1 404") < 100:
            readable, writable, _ = select.select([client], [client], [], PATIENT)
            if readable:
                answers += client.recv(1 << 16)
            if writable:
                sent += client.send(POST * 2_000)
    assert sent < 12 << 20


def test_a_socket_is_read_in_small_parts(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Before any viewer gets its next frame, the server parses all bytes that it has read."""
    sizes: list[int] = []
    take = ViewerProtocol.data_received

    def noted(protocol: ViewerProtocol, data: bytes) -> None:
        sizes.append(len(data))
        take(protocol, data)

    monkeypatch.setattr(ViewerProtocol, "data_received", noted)
    with limited(tmp_path, stages=5) as (address, _):
        stage = httpx.post(f"http://{address}/api/stages", json={}, timeout=PATIENT).headers["location"]
        viewer = open_and_never_read(address, f"{stage}/stream")
        viewer.sendall(bytes([0x8A, 0x80, 0, 0, 0, 0]) * 50_000)  # unsolicited pongs
        wait_for(lambda: sum(sizes) >= 300_000)
        viewer.close()
    assert max(sizes) <= 4_096
