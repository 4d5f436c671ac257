"""Measures the server's CPU time per viewer at 60 Hz, and the frames that each viewer gets.

`python benchmarks/viewers.py 1 50 200` runs it with 1, 50 and 200 viewers.
"""

import asyncio
import re
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from websockets.asyncio.client import connect

SECONDS = 5.0


def cpu_seconds(process: int) -> float:
    """Returns the user and system time of a process so far (Linux)."""
    fields = Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / 100


def tick_of(message: bytes) -> int:
    """Returns the tick of a frame of either kind."""
    if message[:4] == b"STW1":
        return int.from_bytes(message[8:12], "little")
    return int(re.search(rb'"tick": *(\d+)', message)[1])  # type: ignore[index]


async def watch(address: str, kind: str, counts: list[int], sizes: list[int], row: int) -> None:
    """Runs one viewer, which counts its frames and acknowledges them."""
    async with connect(
        f"ws://{address}/api/stages/main/stream?frames={kind}", max_size=None, compression=None
    ) as socket:
        async for message in socket:
            if isinstance(message, bytes):
                counts[row] += 1
                sizes[row] = len(message)
                tick = (
                    int.from_bytes(message[8:12], "little")
                    if kind == "pose"
                    else int(message.split(b'"tick":', 1)[1][:12].split(b"}")[0])
                )
                await socket.send(f'{{"type":"ack","tick":{tick}}}')


async def measure(process: int, address: str, viewers: int, kind: str) -> None:
    """Runs `viewers` viewers for five seconds, and prints a line."""
    counts, sizes = [0] * viewers, [0] * viewers
    tasks = [asyncio.create_task(watch(address, kind, counts, sizes, row)) for row in range(viewers)]
    await asyncio.sleep(2)
    before, began, spent = list(counts), time.monotonic(), cpu_seconds(process)
    await asyncio.sleep(SECONDS)
    seconds, spent = time.monotonic() - began, cpu_seconds(process) - spent
    rates = sorted((now - was) / seconds for now, was in zip(counts, before, strict=True))
    for task in tasks:
        task.cancel()
    await asyncio.gather(*tasks, return_exceptions=True)
    each = 1e6 * spent / max(sum(counts) - sum(before), 1)
    print(
        f"{viewers:4} viewers of {kind}: {100 * spent / seconds:5.1f} % of a core, {each:6.0f} us a message "
        f"of {sizes[0]} bytes, "
        f"{rates[0]:.1f} to {rates[-1]:.1f} messages/s"
    )


def main(numbers: list[str]) -> None:
    """Starts a server, and measures it with each number of viewers."""
    resource.setrlimit(resource.RLIMIT_NOFILE, (4096, 4096))
    command = [sys.executable, "-m", "statwalk.cli", "serve", "--port", "0", "--data", tempfile.mkdtemp()]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as server:
        assert server.stdout
        address = server.stdout.readline().split("http://")[1].split("/")[0]
        for kind in ("pose", "glb"):
            for number in numbers or ["1", "50"]:
                asyncio.run(measure(server.pid, address, int(number), kind))
        server.terminate()


main(sys.argv[1:])
