"""Workers: the same results as here, an end for each job, and a clear word for whatever ends before."""

import os
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path

import pytest
import worker_jobs
from paths import ROOT
from serving import PATIENCE, wait_for
from statwalk.errors import BusyError, CancelledError, LimitError, OverdueError, UnknownNameError
from statwalk.services.cancel import CancelToken
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.library.measuring import measure
from statwalk.services.library.role_reference import reference_to
from statwalk.services.work.limited_process import NICENESS
from statwalk.services.work.worker import MOST_MEMORY
from statwalk.services.work.workers import IDLE_SECONDS, Workers
from statwalk.stage.verified import verified

SUPPORT = str(ROOT / "tests" / "support")
SERVER = """
import pathlib, sys, worker_jobs
from statwalk.services.work.workers import Workers
Workers(lambda value: None).do("", worker_jobs.deaf, pathlib.Path(sys.argv[1]))
"""


@pytest.fixture(scope="module")
def catalogue() -> Catalogue:
    return Catalogue()


@pytest.fixture(scope="module")
def workers(catalogue: Catalogue) -> Iterator[Workers]:
    """One worker: what one test leaves behind, the next one finds."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("PYTHONPATH", SUPPORT)
        workers = Workers(partial(reference_to, catalogue), most=1)
        yield workers
        workers.close()


@pytest.fixture
def thread() -> Iterator[ThreadPoolExecutor]:
    with ThreadPoolExecutor(1) as thread:
        yield thread


def process_of(begun: Path) -> int:
    """The process of a job, as soon as the job has begun."""
    wait_for(begun.exists)
    return int(begun.read_text())


def is_gone(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return True
    return False


def test_a_worker_finds_what_this_process_finds(workers: Workers, catalogue: Catalogue) -> None:
    """Of a machine as it is, and of another text of it; an error comes back as it is."""
    role = catalogue.role("elbow")
    text = catalogue.texts[role].replace("TWIST reaches TWIST", "TWIST reaches BENT")
    worse = catalogue.version("elbow", text)
    for one in (role, worse):
        assert workers.do("elbow", verified, one) == verified(one)
    assert verified(role) != verified(worse)
    here = measure(role, "REST/BEND")
    assert here
    assert workers.do("elbow", measure, role, "REST/BEND") == here
    with pytest.raises(UnknownNameError) as wrong:
        workers.do("elbow", measure, role, "NOWHERE/BEND")
    assert wrong.value.known


def test_a_job_is_cancelled_and_the_worker_does_the_next_one(
    workers: Workers, thread: ThreadPoolExecutor, tmp_path: Path
) -> None:
    """Also one that waits until the worker is free."""
    token, waits = CancelToken(), CancelToken()
    job = thread.submit(workers.do, "", worker_jobs.endless, tmp_path / "begun", token=token)
    process = process_of(tmp_path / "begun")
    waits.cancel()
    with pytest.raises(CancelledError):
        workers.do("", worker_jobs.process, token=waits)
    token.cancel()
    with pytest.raises(CancelledError):
        job.result(PATIENCE)
    assert workers.do("", worker_jobs.process) == process


def test_a_job_that_does_not_hear_ends_with_its_process(
    workers: Workers, thread: ThreadPoolExecutor, tmp_path: Path
) -> None:
    token = CancelToken()
    job = thread.submit(workers.do, "", worker_jobs.deaf, tmp_path / "begun", token=token)
    process = process_of(tmp_path / "begun")
    token.expire_after(0)
    with pytest.raises(OverdueError):
        job.result(PATIENCE)
    assert is_gone(process)
    assert workers.do("", worker_jobs.process) != process


def test_a_worker_that_is_killed_is_replaced(
    workers: Workers, thread: ThreadPoolExecutor, tmp_path: Path
) -> None:
    """While it works, and while it has nothing to do."""
    job = thread.submit(workers.do, "", worker_jobs.deaf, tmp_path / "begun")
    os.kill(process_of(tmp_path / "begun"), signal.SIGKILL)
    with pytest.raises(BusyError, match="-9"):
        job.result(PATIENCE)
    process = workers.do("", worker_jobs.process)
    os.kill(process, signal.SIGKILL)
    os.waitid(os.P_PID, process, os.WEXITED | os.WNOWAIT)
    assert workers.do("", worker_jobs.process) not in (process, os.getpid())


def test_a_worker_has_limits_and_nothing_of_the_server(workers: Workers) -> None:
    """It ignores Ctrl-C, which is for the server; one socket is its own."""
    with socket.socket() as listener:
        listener.listen()
        found = workers.do("", worker_jobs.circumstances)
    assert found == {
        "memory": MOST_MEMORY,
        "niceness": min(os.nice(0) + NICENESS, 19),
        "interrupt": True,
        "sockets": 1,
    }
    with pytest.raises(LimitError, match="MiB"):
        workers.do("", worker_jobs.greedy)
    with pytest.raises(RuntimeError, match="ZeroDivisionError"):
        workers.do("", worker_jobs.defect)


def test_a_worker_without_work_ends(workers: Workers) -> None:
    process = workers.do("", worker_jobs.process)
    workers.end_idle(time.monotonic() + IDLE_SECONDS / 2)
    assert workers.processes == [process]
    workers.end_idle(time.monotonic() + IDLE_SECONDS + 1)
    assert workers.processes == []
    assert is_gone(process)


def test_a_worker_ends_with_a_server_that_is_killed(tmp_path: Path) -> None:
    """Both hold the pipe: its end comes when the worker has ended, too."""
    with subprocess.Popen(
        [sys.executable, "-c", SERVER, tmp_path / "begun"],
        stderr=subprocess.PIPE,
        env=os.environ | {"PYTHONPATH": SUPPORT},
    ) as server:
        assert server.stderr is not None
        assert server.stderr.readline() == b"begun\n"
        server.kill()
        assert server.stderr.read() == b""
