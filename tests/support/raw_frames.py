"""A WebSocket peer that sends any bytes, and reads frames as RFC 6455 writes them."""

import base64
import os
import socket
from types import TracebackType
from typing import Any, Self

CONTINUATION, TEXT, BINARY, CLOSE, PING, PONG = 0, 1, 2, 8, 9, 10
MASK = b"\x37\xfa\x21\x3d"  # the one of the RFC's examples
PATIENCE = 60.0
Frame = tuple[int, bytes]


def frame(
    opcode: int,
    payload: bytes = b"",
    *,
    fin: bool = True,
    reserved: int = 0,
    masked: bool = True,
    length: int | None = None,
    length_bytes: int = 0,
) -> bytes:
    """One frame. `length`: what it says its payload has; `length_bytes`: 0 (as few as it takes), 2 or 8."""
    said = len(payload) if length is None else length
    wide = length_bytes or (0 if said < 126 else 2 if said < 1 << 16 else 8)
    short = {0: said, 2: 126, 8: 127}[wide]
    head = bytes([fin << 7 | reserved << 4 | opcode, masked << 7 | short])
    head += said.to_bytes(wide, "big") if wide else b""
    if not masked:
        return head + payload
    return head + MASK + bytes(byte ^ MASK[place % 4] for place, byte in enumerate(payload))


def close(code: int | None = 1000, reason: bytes = b"") -> bytes:
    return frame(CLOSE, b"" if code is None else code.to_bytes(2, "big") + reason)


class RawPeer:
    """One connection; a context manager."""

    def __init__(self, address: str) -> None:
        host, port = address.split(":")
        self.socket = socket.create_connection((host, int(port)), timeout=PATIENCE)
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.got = b""
        key = base64.b64encode(os.urandom(16)).decode()
        self.socket.sendall(
            f"GET / HTTP/1.1\r\nHost: {address}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
            f"Sec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n\r\n".encode()
        )
        while b"\r\n\r\n" not in self.got:
            assert self._more(), "the handshake was refused"
        answer, _, self.got = self.got.partition(b"\r\n\r\n")
        assert answer.startswith(b"HTTP/1.1 101"), answer

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.socket.close()

    def send(self, data: bytes, pieces: int = 0) -> None:
        """Sends bytes, at once or in pieces of so many bytes."""
        step = pieces or len(data) or 1
        for start in range(0, len(data), step):
            self.socket.sendall(data[start : start + step])

    def receive(self) -> Frame | None:
        """The next frame; None at the end of the connection. A ping is answered, as every peer has to."""
        while (found := self._frame()) is None or found[0] == PING:
            if found:
                self.send(frame(PONG, found[1]))
            elif not self._more():
                assert not self.got, f"the connection ended within a frame: {self.got[:20]!r}"
                return None
        return found

    def receive_all(self) -> list[Frame]:
        """All frames up to the close frame, or to the end of the connection."""
        frames: list[Frame] = []
        while (found := self.receive()) is not None:
            frames.append(found)
            if found[0] == CLOSE:
                break
        return frames

    def _more(self) -> bool:
        data = self.socket.recv(1 << 16)
        self.got += data
        return bool(data)

    def _frame(self) -> Frame | None:
        if len(self.got) < 2:
            return None
        first, second = self.got[:2]
        assert first & 0x80, "the server sends whole messages"
        assert not first & 0x70, "a reserved bit is set"
        assert not second & 0x80, "a server masks nothing"
        wide = {126: 2, 127: 8}.get(second, 0)
        length = int.from_bytes(self.got[2 : 2 + wide], "big") if wide else second
        if len(self.got) < 2 + wide + length:
            return None
        payload, self.got = self.got[2 + wide : 2 + wide + length], self.got[2 + wide + length :]
        return first & 15, payload


class Echo:
    """An application that sends each message back."""

    async def __call__(self, scope: Any, receive: Any, send: Any) -> None:
        message = await receive()
        if scope["type"] == "lifespan":
            await send({"type": "lifespan.startup.complete"})
            await receive()
            await send({"type": "lifespan.shutdown.complete"})
            return
        await send({"type": "websocket.accept"})
        while (message := await receive())["type"] == "websocket.receive":
            try:
                await send({**message, "type": "websocket.send"})
            except OSError:  # the peer has left
                return
