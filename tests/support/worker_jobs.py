"""Jobs for workers: tests of workers put this folder on the path of the worker processes."""

import os
import resource
import signal
import sys
from collections.abc import Callable
from itertools import count
from pathlib import Path
from typing import Any

Checkpoint = Callable[[], None]


def process(_: Checkpoint) -> int:
    return os.getpid()


def circumstances(_: Checkpoint) -> dict[str, Any]:
    """What a worker has from the server, and may do."""
    return {
        "memory": resource.getrlimit(resource.RLIMIT_AS)[0],
        "niceness": os.nice(0),
        "interrupt": signal.getsignal(signal.SIGINT) == signal.SIG_IGN,
        "sockets": sum(os.readlink(link).startswith("socket:") for link in open_files()),
    }


def open_files() -> list[Path]:
    return [link for link in Path("/proc/self/fd").iterdir() if link.is_symlink()]


def endless(begun: Path, checkpoint: Checkpoint) -> None:
    """Works until it is cancelled; writes its process down first."""
    _write_process(begun)
    for _ in count():
        checkpoint()


def deaf(begun: Path, _: Checkpoint) -> None:
    """Works for ever, and looks at nothing."""
    _write_process(begun)
    print("begun", file=sys.stderr, flush=True)
    for _ in count():
        pass


def greedy(_: Checkpoint) -> int:
    return len(bytearray(16 << 30))


def defect(_: Checkpoint) -> float:
    return 1 / 0


def _write_process(begun: Path) -> None:
    unfinished = begun.with_suffix(".unfinished")
    unfinished.write_text(str(os.getpid()))
    unfinished.replace(begun)
