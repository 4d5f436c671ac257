"""Many viewers in one event loop: each acknowledges its frames, and notes when which tick came.

They read frames from the bytes themselves, so that the measuring costs little beside what is measured.
"""

from __future__ import annotations

import asyncio
import base64
import hashlib
import os
import struct
import time
from array import array

ACK = b'{"type":"ack","tick":%d}'
TEXT, BINARY, CLOSE, PING, PONG = 0x1, 0x2, 0x8, 0x9, 0xA
FACTS = b'"type":"verdict"', b'"type":"action"'


def masked(opcode: int, payload: bytes) -> bytes:
    """A frame as clients send it, with the mask 0, which leaves the payload as it is."""
    if len(payload) < 126:
        return struct.pack("!BB4x", 0x80 | opcode, 0x80 | len(payload)) + payload
    return struct.pack("!BBH4x", 0x80 | opcode, 0x80 | 126, len(payload)) + payload


def upgrade(address: str, path: str, header: str = "") -> bytes:
    """The request that opens a stream; `header`: one more line of it."""
    key = base64.b64encode(os.urandom(16)).decode()
    return (
        f"GET {path} HTTP/1.1\r\nHost: {address}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
        f"Sec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n{header}\r\n"
    ).encode()


class RawViewer(asyncio.Protocol):
    """`times` (s of the monotonic clock) and `ticks` of its frames; `facts` and `digest` of the verdicts and
    actions; `code` with which the server closed it, 0 while it is open, 1006 if it was cut.
    """

    transport: asyncio.Transport

    def __init__(self, request: bytes) -> None:
        self.request, self.left, self.opened = request, b"", False
        self.times, self.ticks = array("d"), array("q")
        self.facts, self.digest = 0, hashlib.blake2b(digest_size=8)
        self.frame_bytes = self.code = 0
        self.ended = asyncio.get_running_loop().create_future()

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        assert isinstance(transport, asyncio.Transport)
        self.transport = transport
        transport.write(self.request)

    def connection_lost(self, _: Exception | None) -> None:
        self.code = self.code or 1006
        if not self.ended.done():
            self.ended.set_result(self.code)

    def data_received(self, data: bytes) -> None:
        data = self.left + data
        at = 0 if self.opened else self._skip_answer(data)
        while len(data) - at >= 2:
            length, begin = data[at + 1], at + 2
            if length == 126:
                length, begin = int.from_bytes(data[begin : begin + 2], "big"), begin + 2
            elif length == 127:
                length, begin = int.from_bytes(data[begin : begin + 8], "big"), begin + 8
            if len(data) < begin + length:
                break
            self._take(data[at] & 0xF, data[begin : begin + length])
            at = begin + length
        self.left = data[at:]

    def _skip_answer(self, data: bytes) -> int:
        end = data.find(b"\r\n\r\n")
        if end < 0:
            return len(data)
        assert b" 101 " in data[:20], data[:200]
        self.opened = True
        return end + 4

    def _take(self, opcode: int, payload: bytes) -> None:
        if opcode == BINARY:
            tick = int.from_bytes(payload[8:12], "little")
            self.times.append(time.monotonic())
            self.ticks.append(tick)
            self.frame_bytes = len(payload)
            self.transport.write(masked(TEXT, ACK % tick))
        elif opcode == TEXT and any(kind in payload[:80] for kind in FACTS):
            self.facts += 1
            self.digest.update(payload)
        elif opcode == PING:
            self.transport.write(masked(PONG, payload))
        elif opcode == CLOSE:
            self.code = int.from_bytes(payload[:2], "big")
            self.transport.write(masked(CLOSE, payload))
            self.transport.close()


async def join(address: str, stage: str) -> RawViewer:
    """Opens one viewer of a stage (`/api/stages/ID`)."""
    host, port = address.split(":")
    request = upgrade(address, f"{stage}/stream")
    _, viewer = await asyncio.get_running_loop().create_connection(
        lambda: RawViewer(request), host, int(port)
    )
    return viewer


async def stay(address: str, stage: str, viewers: list[RawViewer]) -> None:
    """Is one viewer that comes back as soon as it is disconnected, as a page does; adds each of its
    connections to `viewers`.
    """
    while True:
        viewer = await join(address, stage)
        viewers.append(viewer)
        if await viewer.ended == 1012:
            return
        await asyncio.sleep(0.05)
