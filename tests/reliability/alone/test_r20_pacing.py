"""R-20: a server keeps its pace, and holds no more than before. Coarsely: other work may run beside it.

`python benchmarks/reliability.py pacing --minutes 60` does it for an hour, and finely.
"""

from collections.abc import Iterator

import httpx
import pytest
from load_process import LoadProcess, viewers_in_a_process
from pacing_figures import held, late_counts, late_within, pace, ticks_left_out
from processes import served
from serving import PATIENCE, wait_for

MAIN = "/api/stages/main"
TICKS = 720
"""a stage may be 15 ticks behind on a busy computer, at the beginning or at the end: 1.25 Hz over so many"""
WARM_TICKS = 120
"""until the server has opened its files"""
NEAR = 1.5
"""Hz"""
MORE_THREADS = 4
"""that answer requests, and stay for the next ones"""


@pytest.fixture(scope="module")
def running() -> Iterator[tuple[int, httpx.Client, LoadProcess]]:
    with (
        served() as (process, address),
        httpx.Client(base_url=f"http://{address}", timeout=PATIENCE) as rest,
        viewers_in_a_process(address, MAIN, 1) as load,
    ):
        yield process.pid, rest, load


def hertz(rest: httpx.Client, load: LoadProcess) -> float:
    """The pace over twelve seconds' ticks."""
    load.seen()
    first, before = rest.get(MAIN).json()["head"], ticks_left_out(rest.get("/metrics").text)
    wait_for(lambda: rest.get(MAIN).json()["head"] >= first + TICKS)
    seen = load.seen()[0]
    left_out = ticks_left_out(rest.get("/metrics").text) - before
    return pace(seen.times, seen.ticks, left_out=left_out).hz


def test_r20_a_stage_keeps_its_pace_and_the_server_its_size(
    running: tuple[int, httpx.Client, LoadProcess],
) -> None:
    process, rest, load = running
    wait_for(lambda: rest.get(MAIN).json()["head"] > WARM_TICKS)
    late, before = late_counts(rest.get("/metrics").text), held(process)
    assert hertz(rest, load) == pytest.approx(60, abs=NEAR)
    after = held(process)
    assert after.files <= before.files
    assert after.threads <= before.threads + MORE_THREADS
    assert late_within(late, late_counts(rest.get("/metrics").text), 0.5) < 0.25


def test_r20_a_stage_that_runs_too_slowly_is_found_out(
    running: tuple[int, httpx.Client, LoadProcess],
) -> None:
    """The control: five per cent less."""
    _, rest, load = running
    rest.post(f"{MAIN}/speed", json={"speed": 0.95}).raise_for_status()
    assert hertz(rest, load) != pytest.approx(60, abs=NEAR)
