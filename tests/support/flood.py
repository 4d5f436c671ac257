"""One client that sends far more than it may, from an address and in a process of its own.

`python flood.py ADDRESS STAGE EVENTS_A_SECOND SECONDS` prints what it tried and how it was answered, as JSON:
events on sockets until they are closed, and pipelined requests for the same events.
"""

from __future__ import annotations

import asyncio
import json
import re
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path

from raw_viewers import TEXT, RawViewer, masked, upgrade

FROM = "127.0.0.2"
BEAT_SECONDS = 0.01
EVENT = b'{"type":"event","event":"FORWARD","ref":1}'
BODY = b'{"event":"FORWARD"}'
STATUS = re.compile(rb"HTTP/1\.1 (\d{3}) ")
CONNECTIONS = 8
MOST_UNSENT = 1 << 20


class FloodingViewer(RawViewer):
    """A viewer whose upgrade may be refused: then `code` is the status."""

    def _skip_answer(self, data: bytes) -> int:
        if b" 101 " not in data[:20] and (status := STATUS.match(data)):
            self.code = int(status[1])
            self.transport.close()
            return len(data)
        return super()._skip_answer(data)


async def on_sockets(address: str, stage: str, rate: float, until: float, found: Counter[str]) -> None:
    """Opens one socket after another, and sends events on each until it is closed."""
    host, port = address.split(":")
    batch, number = masked(TEXT, EVENT), max(1, round(rate * BEAT_SECONDS))
    while time.monotonic() < until:
        request = upgrade(address, f"{stage}/stream")
        try:
            _, viewer = await asyncio.get_running_loop().create_connection(
                lambda request=request: FloodingViewer(request), host, int(port), local_addr=(FROM, 0)
            )
        except OSError:
            found["connection refused"] += 1
            await asyncio.sleep(0.1)
            continue
        while not viewer.ended.done() and time.monotonic() < until:
            if viewer.opened and viewer.transport.get_write_buffer_size() < MOST_UNSENT:
                viewer.transport.write(batch * number)
                found["socket events"] += number
            await asyncio.sleep(BEAT_SECONDS)
        found[f"socket {viewer.code}"] += 1
        if not viewer.transport.is_closing():
            viewer.transport.abort()


async def by_requests(address: str, stage: str, rate: float, until: float, found: Counter[str]) -> None:
    """Sends requests on one connection without waiting for answers."""
    host, port = address.split(":")
    request = (
        f"POST {stage}/events HTTP/1.1\r\nHost: {address}\r\nContent-Type: application/json\r\n"
        f"Content-Length: {len(BODY)}\r\n\r\n"
    ).encode() + BODY
    number = max(1, round(rate * BEAT_SECONDS))
    while time.monotonic() < until:
        try:
            reader, writer = await asyncio.open_connection(host, int(port), local_addr=(FROM, 0))
            answers = asyncio.create_task(_count_answers(reader, found))
            while time.monotonic() < until and not answers.done():
                if writer.transport.get_write_buffer_size() < MOST_UNSENT:
                    writer.write(request * number)
                    found["requests"] += number
                await asyncio.sleep(BEAT_SECONDS)
            answers.cancel()
            if not writer.transport.is_closing():
                writer.transport.abort()
        except OSError:
            found["connection refused"] += 1
            await asyncio.sleep(0.1)


async def _count_answers(reader: asyncio.StreamReader, found: Counter[str]) -> None:
    rest = b""
    while data := await reader.read(1 << 16):
        rest += data
        ends = [match.end() for match in STATUS.finditer(rest)]
        for status in STATUS.findall(rest):
            found[f"status {status.decode()}"] += 1
        rest = rest[max(ends[-1] if ends else 0, len(rest) - 12) :]
    found["connection closed"] += 1


async def _main(address: str, stage: str, rate: float, seconds: float) -> None:
    found: Counter[str] = Counter()
    until = time.monotonic() + seconds
    await asyncio.gather(
        on_sockets(address, stage, rate / 2, until, found),
        *(by_requests(address, stage, rate / 2 / CONNECTIONS, until, found) for _ in range(CONNECTIONS)),
    )
    print(json.dumps(found))


def flooded(address: str, stage: str, rate: float, seconds: float) -> dict[str, int]:
    """Floods a server for a while; returns what was tried, and how it was answered."""
    command = [sys.executable, str(Path(__file__)), address, stage, str(rate), str(seconds)]
    answer = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True, timeout=seconds + 30)
    found: dict[str, int] = json.loads(answer.stdout)
    return found


if __name__ == "__main__":
    asyncio.run(_main(sys.argv[1], sys.argv[2], float(sys.argv[3]), float(sys.argv[4])))
