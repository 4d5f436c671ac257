"""R-19: the time of day may jump, and the computer may sleep: stages go on without a burst, and say how many
ticks they left out. The simulation of R-08 has both among its faults.
"""

import ast
import math
import os
import re
import signal
import time
from collections.abc import Iterator
from pathlib import Path

import httpx
import pytest
from pacing_figures import ticks_left_out
from paths import ROOT
from processes import served
from serving import PATIENCE, wait_for
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import AddActor, StageSetup
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.hosting.ticker import Ticker
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.limits import Limits
from statwalk.stage.clock import LARGEST_CATCH_UP_S
from watcher import Watcher

HZ = 60
STOPPED_SECONDS = 3.0
WALL_CLOCK = {
    "maths/code_folder.py",  # the age of compiled code, a file's too
    "services/hosting/machine_versions.py",  # when an edit was made, for people to read
    "services/hosting/registry.py",  # when a stage was made, for people to read
    "services/hosting/reopen.py",  # when a machine's file was read, for people to read
    "services/hosting/stage_host.py",  # when a fork was made, for people to read
    "services/library/model_store.py",  # the age of a leftover file, whose time is the time of day too
}
"""the only modules that may read the time of day"""
TIME_OF_DAY = re.compile(r"\btime\.time|\bdatetime\b|\bdate\b")


class Now:
    """A clock that a test sets."""

    def __init__(self) -> None:
        self.seconds = 1_000.0

    def __call__(self) -> float:
        return self.seconds


class Measured:
    """What a registry says about its ticks."""

    def __init__(self) -> None:
        self.at_once: list[int] = []
        self.lost = 0

    def __call__(self, late: list[float], lost: int) -> None:
        self.at_once.append(len(late))
        self.lost += lost


@pytest.fixture(scope="module")
def catalogue() -> Catalogue:
    return Catalogue()


@pytest.fixture
def running(catalogue: Catalogue) -> tuple[Ticker, StageHost, Now, Measured]:
    """A stage in real time that has run for a second of a clock that the test sets."""
    now, measured = Now(), Measured()
    held = Registry(catalogue, repr, Limits(), now=now)  # type: ignore[arg-type]
    held.measure_ticks = measured  # type: ignore[assignment]
    host = held.open(StageSetup(keep_running=True, clock="real", rate=HZ, actors=(AddActor("elbow"),)))
    ticker = Ticker(held.all, now)
    run(ticker, now, 1.0)
    return ticker, host, now, measured


def run(ticker: Ticker, now: Now, seconds: float) -> None:
    """Turns the ticker as its thread does, until the clock has gone on by so many seconds."""
    until = now.seconds + seconds
    while now.seconds < until:
        now.seconds += ticker.round()


def test_r19_after_an_hour_of_sleep_there_is_no_burst(
    running: tuple[Ticker, StageHost, Now, Measured],
) -> None:
    ticker, host, now, measured = running
    before = host.handle(ask.Status()).tick
    now.seconds += 3_600.0
    run(ticker, now, 1.0)
    assert max(measured.at_once) <= math.ceil(LARGEST_CATCH_UP_S * HZ)
    assert host.handle(ask.Status()).tick - before == pytest.approx((1.0 + LARGEST_CATCH_UP_S) * HZ, abs=2)
    assert measured.lost == pytest.approx((3_600.0 - LARGEST_CATCH_UP_S) * HZ, abs=2)


def test_r19_a_clock_that_stands_still_makes_no_tick(
    running: tuple[Ticker, StageHost, Now, Measured],
) -> None:
    """As while a computer sleeps whose monotonic clock does not count that."""
    ticker, host, now, measured = running
    ticker.round()
    before = host.handle(ask.Status()).tick
    for _ in range(100):
        ticker.round()
    assert host.handle(ask.Status()).tick == before
    run(ticker, now, 1.0)
    assert host.handle(ask.Status()).tick - before == pytest.approx(HZ, abs=1)
    assert measured.lost == 0


def wall_clock_readers() -> set[str]:
    """The modules that call time.time, time.time_ns, or anything of datetime's that reads the time of day."""
    package = ROOT / "server" / "statwalk"
    return {
        str(path.relative_to(package))
        for path in package.rglob("*.py")
        if TIME_OF_DAY.search(text := path.read_text()) and any(_reads(ast.parse(text)))
    }


def _reads(module: ast.Module) -> Iterator[bool]:
    for node in ast.walk(module):
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
            yield (node.value.id, node.attr) in {("time", "time"), ("time", "time_ns")}
            yield node.attr in {"now", "utcnow", "today"} and node.value.id in {"datetime", "date"}


def test_r19_only_what_people_read_is_measured_by_the_time_of_day() -> None:
    assert wall_clock_readers() == WALL_CLOCK


def test_r19_a_server_that_was_stopped_goes_on_without_a_burst(tmp_path: Path) -> None:
    """SIGSTOP, as a debugger or a suspended virtual machine does it."""
    with (
        served("--data", str(tmp_path)) as (process, address),
        Watcher(address, "/api/stages/main") as viewer,
        httpx.Client(base_url=f"http://{address}", timeout=PATIENCE) as client,
    ):
        before, left_out = viewer.frame().tick, lost(client)
        os.kill(process.pid, signal.SIGSTOP)
        until = time.monotonic() + STOPPED_SECONDS
        wait_for(lambda: time.monotonic() > until)
        began = time.monotonic()
        os.kill(process.pid, signal.SIGCONT)
        while (tick := viewer.frame().tick) < before + HZ:
            pass
        passed = time.monotonic() - began
        assert tick - before <= (passed + 2 * LARGEST_CATCH_UP_S) * HZ + 10
        assert lost(client) - left_out >= (STOPPED_SECONDS - 2 * LARGEST_CATCH_UP_S) * HZ


def lost(client: httpx.Client) -> int:
    return ticks_left_out(client.get("/metrics").text)
