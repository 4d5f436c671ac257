"""Viewers in a process of their own, which a test or a measurement can stop, wake and ask.

`python load_process.py ADDRESS STAGE COUNT` prints `ready`, and for each line on its standard input what its
viewers have seen since the last line, as one line of JSON.
"""

from __future__ import annotations

import asyncio
import json
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

from raw_viewers import RawViewer, stay

PATIENCE = 60.0


class Seen(NamedTuple):
    """What one connection of a viewer saw."""

    times: list[float]
    ticks: list[int]
    facts: int
    digest: str
    code: int
    frame_bytes: int


class LoadProcess:
    """The process, as its parent has it."""

    def __init__(self, process: subprocess.Popen[str]) -> None:
        self.process = process

    def seen(self) -> list[Seen]:
        """What its viewers saw since the last call, one item for each of their connections; facts and their
        digest from the beginning.
        """
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        self.process.stdin.write("\n")
        self.process.stdin.flush()
        return [Seen(*row) for row in json.loads(self.process.stdout.readline())]


@contextmanager
def viewers_in_a_process(address: str, stage: str, count: int) -> Iterator[LoadProcess]:
    """Opens `count` viewers of a stage; all have a frame when it begins."""
    process = subprocess.Popen(
        [sys.executable, str(Path(__file__)), address, stage, str(count)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    try:
        assert process.stdout is not None
        assert process.stdout.readline() == "ready\n"
        yield LoadProcess(process)
    finally:
        process.kill()
        process.wait()
        for pipe in (process.stdin, process.stdout):
            if pipe is not None:
                pipe.close()


def _taken(viewer: RawViewer) -> list[object]:
    times, ticks = viewer.times.tolist(), viewer.ticks.tolist()
    del viewer.times[:], viewer.ticks[:]
    return [
        times,
        ticks,
        viewer.facts,
        viewer.digest.hexdigest(),
        viewer.code,
        viewer.frame_bytes,
    ]


async def _main(address: str, stage: str, count: int) -> None:
    viewers: list[RawViewer] = []
    tasks = [asyncio.create_task(stay(address, stage, viewers)) for _ in range(count)]
    async with asyncio.timeout(PATIENCE):
        while sum(bool(viewer.ticks) for viewer in viewers) < count:  # noqa: ASYNC110 - they have no event
            await asyncio.sleep(0.01)
    print("ready", flush=True)
    while await asyncio.to_thread(sys.stdin.readline):
        print(json.dumps([_taken(viewer) for viewer in viewers]), flush=True)
    for task in tasks:
        task.cancel()


if __name__ == "__main__":
    asyncio.run(_main(sys.argv[1], sys.argv[2], int(sys.argv[3])))
