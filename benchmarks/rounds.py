"""Measures jobs in turn and takes the least time of each, so that other work on the computer slows all jobs
equally.
"""

from __future__ import annotations

import json
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from time import perf_counter
from typing import Any, Self

PEERS = Path(__file__).resolve().parent / "peers"
Job = Callable[[], float | None]
TURN = 0.05


class Node:
    """A script of `peers` in its own Node process, which times its jobs itself."""

    script = ""

    def __init__(self) -> None:
        node = shutil.which("node")
        if node is None:
            raise SystemExit("node is not on the PATH; install Node.js")
        self.process = subprocess.Popen(
            [node, str(PEERS / self.script)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )

    def job(self, name: str, **arguments: Any) -> Job:
        """Returns a job that runs in the process and returns its seconds."""
        assert self.process.stdin
        assert self.process.stdout

        def run() -> float:
            self.process.stdin.write(json.dumps({"job": name, **arguments}) + "\n")
            self.process.stdin.flush()
            return float(json.loads(self.process.stdout.readline())["ms"]) / 1e3

        return run

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        assert self.process.stdin
        self.process.stdin.close()
        self.process.wait()


class Three(Node):
    """A process with the three.js jobs."""

    script = "three.mjs"


class XState(Node):
    """A process with the XState jobs."""

    script = "xstate.mjs"


def least(jobs: dict[str, Job], rounds: int) -> dict[str, float]:
    """Runs the jobs in turn, and returns the least seconds of each; a job that returns seconds
    has timed itself.

    A short job runs repeatedly in its turn, for TURN seconds: a server at 60 frames a second also has its
    data and its code in the caches.
    """
    least_seconds = dict.fromkeys(jobs, float("inf"))
    for _ in range(rounds):
        for name, job in jobs.items():
            end = perf_counter() + TURN
            while True:
                start = perf_counter()
                reported = job()
                now = perf_counter()
                seconds = now - start if reported is None else reported
                least_seconds[name] = min(least_seconds[name], seconds)
                if now > end:
                    break
    return least_seconds


def show(title: str, seconds: dict[str, float], goals: dict[str, float] | None = None) -> None:
    """Prints a table: milliseconds, multiples of statwalk's time, and the goals."""
    statwalk_seconds = seconds["statwalk"]
    print(title)
    for name, value in seconds.items():
        goal = f"   goal {goals[name]:g} x" if goals and name in goals else ""
        print(f"  {name:34} {value * 1e3:9.3f} ms   {value / statwalk_seconds:8.2f} x{goal}")
