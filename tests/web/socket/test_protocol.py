"""A viewer that reads no more is let go, and does not hold up the server's end."""

import logging
import socket
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import pytest
from serving import PATIENCE, open_and_never_read, serving, wait_for
from statwalk.web import server
from statwalk.web.socket import protocol
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import connect

FOR_EVER = 3_600.0
LARGE = b"x" * (1 << 20)
EMPTY_TEXT = b"\x81\x80\x00\x00\x00\x00"


class Flood:
    """Sends large messages for ever; counts how its connections ended."""

    def __init__(self) -> None:
        self.ended = threading.Event()
        self.sent = 0

    async def __call__(self, scope: Any, receive: Any, send: Any) -> None:
        if scope["type"] == "lifespan":
            await receive()
            await send({"type": "lifespan.startup.complete"})
            await receive()
            await send({"type": "lifespan.shutdown.complete"})
            return
        await send({"type": "websocket.accept"})
        try:
            while True:
                await send({"type": "websocket.send", "bytes": LARGE})
                self.sent += 1
        finally:
            self.ended.set()


@pytest.fixture(autouse=True)
def _lasting(monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing cuts a viewer off but what a test is about."""
    monkeypatch.setattr(server, "PONG_SECONDS", FOR_EVER)
    monkeypatch.setattr(protocol, "UNWRITABLE_SECONDS", FOR_EVER)


def is_stuck(flood: Flood) -> bool:
    """Whether nothing went out between two looks."""
    before = flood.sent
    time.sleep(0.05)
    return flood.sent == before


def test_a_viewer_that_never_reads_is_cut_off(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(protocol, "UNWRITABLE_SECONDS", 0.2)
    flood = Flood()
    with serving(flood) as address:
        client = open_and_never_read(address, "/")
        assert flood.ended.wait(PATIENCE)
        client.close()


def test_the_server_ends_although_a_viewer_never_reads() -> None:
    flood = Flood()
    with serving(flood) as address:
        client = open_and_never_read(address, "/")
        wait_for(lambda: is_stuck(flood))
    assert flood.ended.is_set()
    client.close()


def test_a_viewer_that_reads_again_in_time_is_kept() -> None:
    flood = Flood()
    with (
        serving(flood) as address,
        connect(f"ws://{address}/", max_size=None, compression=None, open_timeout=PATIENCE) as viewer,
    ):
        wait_for(lambda: is_stuck(flood))
        stuck_at = flood.sent
        for _ in range(stuck_at + 2):
            assert viewer.recv(timeout=PATIENCE) == LARGE
        assert not flood.ended.is_set()


class SendsToTheEnd:
    """Receives until its connection ends, and then sends once more."""

    def __init__(self) -> None:
        self.refused: BaseException | None = None

    async def __call__(self, scope: Any, receive: Any, send: Any) -> None:
        if scope["type"] == "lifespan":
            await Flood()(scope, receive, send)
            return
        await send({"type": "websocket.accept"})
        while (await receive())["type"] != "websocket.disconnect":
            pass
        try:
            await send({"type": "websocket.send", "bytes": b"frame"})
        except (OSError, RuntimeError) as error:
            self.refused = error


def test_a_peer_that_sends_too_much_gets_the_reason() -> None:
    """It reads the close frame although it still sent when the server refused its message."""
    app = SendsToTheEnd()
    with (
        serving(app) as address,
        connect(f"ws://{address}/", compression=None, open_timeout=PATIENCE) as viewer,
    ):
        viewer.send(b"x" * (8 << 20))
        with pytest.raises(ConnectionClosed) as closed:
            viewer.recv(timeout=PATIENCE)
    assert closed.value.rcvd is not None
    assert closed.value.rcvd.code == 1009
    assert isinstance(app.refused, OSError)  # as when a viewer has left


def test_a_refusal_is_no_error_in_the_log(address: str, caplog: pytest.LogCaptureFixture) -> None:
    """Asked for twice: when the second is answered, the first has been logged."""
    log = logging.getLogger("uvicorn.error")
    log.addHandler(caplog.handler)
    for _ in range(2):
        with pytest.raises(InvalidStatus):
            connect(f"ws://{address}/api/stages/nowhere/stream", open_timeout=PATIENCE)
    log.removeHandler(caplog.handler)
    assert caplog.messages == []


def send_after_the_end(client: socket.socket) -> bytes:
    """What a client receives that acknowledges two frames after the server has said that it closes."""
    with client:
        received = b"".join(iter(lambda: client.recv(4096), b""))
        for _ in range(2):  # the second would not be taken if the server had closed the connection for good
            client.sendall(EMPTY_TEXT)
        return received


def test_a_viewer_that_still_sends_when_the_server_ends_is_not_reset() -> None:
    with ThreadPoolExecutor() as readers:
        with serving(SendsToTheEnd()) as address:
            received = readers.submit(send_after_the_end, open_and_never_read(address, "/"))
        assert received.result().endswith(b"\x88\x02" + (1012).to_bytes(2, "big"))
