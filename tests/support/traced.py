"""Runs work in a process of its own under `strace`, which writes each system call down or spoils some.

`strace` joins the process when it is about to begin: neither imports nor compiled code are in the way.
"""

import json
import shutil
import signal
import subprocess
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any, NamedTuple

import pytest
from killed import CONTEXT, start_forks

CHANGES = "openat,write,pwrite64,writev,pwritev,fdatasync,fsync,ftruncate,unlink,unlinkat,rename,renameat"
"""the calls that change a disk, and those that answer"""
Answer = dict[str, Any]
Work = Callable[[Path, Any, Callable[[Answer], None]], None]
"""takes a folder, a plan, and the function that answers"""


class Traced(NamedTuple):
    """What a process answered before its end, and its exit status (negative: the signal that ended it)."""

    answers: list[Answer]
    status: int | None


def _begin(work: Work, folder: Path, plan: object, may_begin: Connection, answers: Connection) -> None:
    answers.send_bytes(b"ready")
    may_begin.recv()
    work(folder, plan, lambda answer: answers.send_bytes(json.dumps(answer).encode()))


@contextmanager
def strace(pid: int, *options: str) -> Iterator[subprocess.Popen[str]]:
    """Traces a process and its threads until the end of the block; a signal to strace ends it earlier."""
    command = ["strace", "-f", *options, "-p", str(pid)]
    tracer = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
    assert tracer.stderr is not None
    try:
        line = tracer.stderr.readline()
        assert "attached" in line, line
        yield tracer
    finally:
        if tracer.poll() is None:
            tracer.send_signal(signal.SIGINT)
        tracer.stderr.read()
        tracer.wait()
        tracer.stderr.close()


Watch = Callable[[Answer, subprocess.Popen[str]], None]
"""is given each answer and strace, which it may end"""


def traced(folder: Path, work: Work, plan: object, *options: str, watch: Watch = lambda *_: None) -> Traced:
    """Runs work under strace until it ends or is killed."""
    start_forks()
    (waits, may_begin), (answers, told) = CONTEXT.Pipe(duplex=False), CONTEXT.Pipe(duplex=False)
    process = CONTEXT.Process(target=_begin, args=(work, folder, plan, waits, told))
    process.start()
    waits.close()
    told.close()
    assert process.pid is not None
    answers.recv_bytes()
    with strace(process.pid, *options) as tracer:
        may_begin.send(True)
        found = []
        for answer in _all(answers):
            found.append(answer)
            watch(answer, tracer)
        process.join()
        tracer.wait()
    return Traced(found, process.exitcode)


def _all(answers: Connection) -> Iterator[Answer]:
    try:
        while True:
            yield json.loads(answers.recv_bytes())
    except EOFError:
        return


@cache
def why_not() -> str:
    """Returns why no process can be traced here; empty if one can."""
    if shutil.which("strace") is None:
        return "strace is not installed"
    with tempfile.NamedTemporaryFile() as file, subprocess.Popen(["sleep", "60"]) as sleeper:
        command = ["strace", "-o", file.name, "-p", str(sleeper.pid)]
        tracer = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
        assert tracer.stderr is not None
        said = tracer.stderr.readline()
        sleeper.kill()
        tracer.wait()
        tracer.stderr.close()
    return "" if "attached" in said else f"strace may not trace: {said.strip()}"


def needs_strace() -> None:
    """Skips the test where no process can be traced."""
    if reason := why_not():
        pytest.skip(reason)
