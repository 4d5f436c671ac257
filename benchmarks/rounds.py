"""Jobs measured in turns, the least time of each counted: what else the machine does then hits all of them alike."""

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
    """A script of `peers` in a Node process of its own, which times its jobs itself."""

    script = ""

    def __init__(self) -> None:
        node = shutil.which("node")
        if node is None:
            raise SystemExit("node is not on the PATH")
        self.process = subprocess.Popen([node, str(PEERS / self.script)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def job(self, name: str, **asked: Any) -> Job:
        """A job that returns its seconds."""
        assert self.process.stdin
        assert self.process.stdout

        def run() -> float:
            self.process.stdin.write(json.dumps({"job": name, **asked}) + "\n")
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
    """three.js."""

    script = "three.mjs"


class XState(Node):
    """XState."""

    script = "xstate.mjs"


def least(jobs: dict[str, Job], rounds: int) -> dict[str, float]:
    """The least seconds of each job, all of them in turn; a job that returns seconds has timed itself.

    A short job is done again and again in its turn, for TURN seconds: a server that draws 60 frames a second has its data and its code
    at hand, too.
    """
    found = dict.fromkeys(jobs, float("inf"))
    for _ in range(rounds):
        for name, job in jobs.items():
            end = perf_counter() + TURN
            while True:
                start = perf_counter()
                own = job()
                now = perf_counter()
                found[name] = min(found[name], now - start if own is None else own)
                if now > end:
                    break
    return found


def show(title: str, seconds: dict[str, float], goals: dict[str, float] | None = None) -> None:
    """A table: milliseconds, and how many times ours each peer takes; beside it the goal."""
    ours = seconds["statwalk"]
    print(title)
    for name, value in seconds.items():
        goal = f"   goal {goals[name]:g} x" if goals and name in goals else ""
        print(f"  {name:34} {value * 1e3:9.3f} ms   {value / ours:8.2f} x{goal}")
