"""A viewer that reads no more is let go, and does not hold up the server's end."""

import asyncio
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


class SendsTogether:
    """Sends two texts and a binary message in one, and a text when its peer has gone; keeps what it wrote."""

    def __init__(self) -> None:
        self.writes, self.refused = list[bytes](), threading.Event()

    async def __call__(self, scope: Any, receive: Any, send: Any) -> None:
        if scope["type"] == "lifespan":
            await Flood()(scope, receive, send)
            return
        await send({"type": "websocket.accept"})
        transport = send.__self__.transport
        write = transport.write
        transport.write = lambda data: write(self.writes.append(bytes(data)) or data)
        await send({"type": "websocket.send", "texts": [b"first", b"second"], "bytes": b"frame"})
        while (await receive())["type"] != "websocket.disconnect":
            pass
        try:
            await send({"type": "websocket.send", "texts": [b"late"]})
        except OSError:
            self.refused.set()


def test_texts_and_a_frame_go_out_in_one_write() -> None:
    app = SendsTogether()
    with serving(app) as address:
        with connect(f"ws://{address}/", compression=None, open_timeout=PATIENCE) as viewer:
            got = [viewer.recv(timeout=PATIENCE) for _ in range(3)]
        assert got == ["first", "second", b"frame"]
        assert [b"first" in data and data.endswith(b"frame") for data in app.writes[:1]] == [True]
        assert app.refused.wait(PATIENCE)


class Unread:
    """Lets messages wait: notes whether the server reads on beside one, beside many, and beside none, and how
    often others got their turn while it took them.
    """

    def __init__(self) -> None:
        self.reads_on, self.noted = list[bool](), threading.Semaphore(0)
        self.turns, self.turns_of_others = list[None](), 0

    async def __call__(self, scope: Any, receive: Any, send: Any) -> None:
        if scope["type"] == "lifespan":
            await Flood()(scope, receive, send)
            return
        await receive()  # the upgrade
        await send({"type": "websocket.accept"})
        viewer = send.__self__
        for waiting in (1, protocol.MOST_UNREAD):
            while viewer.queue.qsize() < waiting:  # noqa: ASYNC110 - uvicorn has no event for it
                await asyncio.sleep(0.001)
            self.note(viewer)
        while not viewer.queue.empty():
            asyncio.get_running_loop().call_soon(self.turns.append, None)
            await receive()
        self.turns_of_others = len(self.turns)
        self.note(viewer)

    def note(self, viewer: Any) -> None:
        self.reads_on.append(viewer.transport.is_reading())
        self.noted.release()


@pytest.fixture(scope="module")
def unread() -> Unread:
    app = Unread()
    with (
        serving(app) as address,
        connect(f"ws://{address}/", compression=None, open_timeout=PATIENCE) as viewer,
    ):
        viewer.send("one")
        assert app.noted.acquire(timeout=PATIENCE)
        for _ in range(protocol.MOST_UNREAD - 1):
            viewer.send("more")
        assert app.noted.acquire(timeout=PATIENCE)
        assert app.noted.acquire(timeout=PATIENCE)
    return app


def test_reading_stops_when_several_messages_wait(unread: Unread) -> None:
    assert unread.reads_on == [True, False, True]


def test_others_have_their_turn_between_messages_that_came_together(unread: Unread) -> None:
    assert unread.turns_of_others == protocol.MOST_UNREAD - 1


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
