"""R-01, R-02: viewers that read no more are cut in about five seconds, the others miss nothing, and who wakes
up sees the present.

`python benchmarks/reliability.py viewers` measures the same with 200 viewers, and how evenly frames come.
"""

import asyncio
import signal
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from itertools import pairwise
from pathlib import Path

import httpx
import pytest
from load_process import LoadProcess, Seen, viewers_in_a_process
from processes import served
from serving import PATIENCE, serving, wait_for
from stalled_viewers import cuts, stalled
from statwalk.services.publish import outbox
from statwalk.services.publish.outbox import EncodedFrame
from statwalk.web.app import create_app
from statwalk.web.socket import stream
from viewer_figures import goes_back

MAIN = "/api/stages/main"
VIEWERS = 20
LONGEST_GAP = 4.0
"""seconds between two frames of a viewer that nobody harms: a busy computer pauses for less, and a server
that waits for a stalled viewer until it is cut for five
"""
SOONEST, LATEST = 4.0, 15.0
"""seconds until a stalled viewer is cut: five, and more where the computer is busy"""
STOPPED_TICKS = 120
OLD_FRAMES = outbox.CREDITS
"""that a viewer which was stopped may see: they were on their way"""
LATE_TICKS = 30
"""by which a frame that is sent to a viewer may lag behind the stage on a busy computer"""


@contextmanager
def watched(address: str) -> Iterator[tuple[httpx.Client, LoadProcess]]:
    with ExitStack() as opened:
        rest = opened.enter_context(httpx.Client(base_url=f"http://{address}", timeout=PATIENCE))
        yield rest, opened.enter_context(viewers_in_a_process(address, MAIN, VIEWERS))


def longest_gap(seen: list[Seen], until: float) -> float:
    """The longest time that a viewer waited for a frame."""
    ends = [[*one.times, until] for one in seen]
    return max(after - before for times in ends for before, after in pairwise(times))


def backlog(seen: list[Seen], since: float, head: int) -> int:
    """How many frames came after `since` that were older than the stage was then."""
    return sum(
        time > since and tick < head - LATE_TICKS
        for one in seen
        for time, tick in zip(one.times, one.ticks, strict=True)
    )


def cut_codes(rest: httpx.Client) -> float:
    """How many sockets were closed as too slow."""
    lines = rest.get("/metrics").text.splitlines()
    closed = [line for line in lines if line.startswith("statwalk_refusals_total{") and "4008" in line]
    return sum(float(line.split()[-1]) for line in closed)


def step_on(rest: httpx.Client, ticks: int) -> None:
    """Waits until the stage has so many ticks more."""
    newest = rest.get(MAIN).json()["head"]
    wait_for(lambda: rest.get(MAIN).json()["head"] > newest + ticks)


def test_r01_stalled_viewers_are_cut_and_the_others_miss_nothing(tmp_path: Path) -> None:
    log = tmp_path / "log"
    with served("--log", "json", log=log) as (_, address), watched(address) as (rest, load):
        with (
            stalled(1, address, MAIN, seconds=PATIENCE),
            stalled(1, address, MAIN, lies=True, seconds=PATIENCE),
        ):
            wait_for(lambda: rest.get(MAIN).json()["viewers"] == VIEWERS + 2)
            while len(cuts(log, "silent") + cuts(log, "lying")) < 2:
                for event in ("FORWARD", "STOP"):
                    assert rest.post(f"{MAIN}/events", json={"event": event}).status_code == 202
            wait_for(lambda: rest.get(MAIN).json()["viewers"] == VIEWERS)
            assert cut_codes(rest) == 2
        ends = cuts(log, "silent")[:1] + cuts(log, "lying")[:1]
        step_on(rest, 30)
        seen = load.seen()
    assert {(end.code, end.limit) for end in ends} == {(4008, "slow")}
    assert all(SOONEST < end.seconds < LATEST for end in ends), ends
    assert len(seen) == VIEWERS  # none came back: none was cut
    assert len({(one.facts, one.digest) for one in seen}) == 1
    assert seen[0].facts > 0
    assert goes_back(seen) == 0
    assert longest_gap(seen, max(one.times[-1] for one in seen)) < LONGEST_GAP


class WaitsForAll(stream.Viewer):
    """A writer that lets no other viewer have a frame before its own has acknowledged one."""

    turn = asyncio.Lock()

    async def _send(self, frame: EncodedFrame | None, texts: list[bytes]) -> None:
        async with self.turn:
            await super()._send(frame, texts)
            while self.outbox.travelling and self.outbox.closing is None:
                await self._acknowledged_or_closing()

    async def _acknowledged_or_closing(self) -> None:
        """The event is the writer's, which clears it: it must not miss what comes meanwhile."""
        await asyncio.sleep(0.001)


def test_r01_a_server_that_waits_for_a_stalled_viewer_is_found_out(monkeypatch: pytest.MonkeyPatch) -> None:
    """The control."""
    monkeypatch.setattr(stream, "Viewer", WaitsForAll)
    with serving(create_app()) as address, watched(address) as (rest, load):
        before = cut_codes(rest)
        with stalled(1, address, MAIN, seconds=PATIENCE):
            wait_for(lambda: cut_codes(rest) > before)
        assert longest_gap(load.seen(), time.monotonic()) > LONGEST_GAP


@contextmanager
def woken(address: str) -> Iterator[tuple[LoadProcess, float, int]]:
    """A viewer that was stopped for so many ticks and goes on, when that was, and the stage's tick then."""
    with watched(address) as (rest, _), viewers_in_a_process(address, MAIN, 1) as sleeper:
        sleeper.process.send_signal(signal.SIGSTOP)
        step_on(rest, STOPPED_TICKS)
        head, since = rest.get(MAIN).json()["head"], time.monotonic()
        sleeper.process.send_signal(signal.SIGCONT)
        yield sleeper, since, head


def seen_until_current(sleeper: LoadProcess, head: int) -> list[Seen]:
    """What a viewer sees until it sees the present."""
    seen: list[Seen] = []

    def is_current() -> bool:
        seen.extend(sleeper.seen())
        return max((tick for one in seen for tick in one.ticks), default=0) >= head

    wait_for(is_current)
    return seen


def test_r02_a_viewer_that_was_stopped_sees_three_old_frames_at_most() -> None:
    with served() as (_, address), woken(address) as (sleeper, since, head):
        assert backlog(seen_until_current(sleeper, head), since, head) <= OLD_FRAMES


def test_r02_a_server_with_a_backlog_is_found_out(monkeypatch: pytest.MonkeyPatch) -> None:
    """The control: without credits a viewer gets what waited in the buffers."""
    monkeypatch.setattr(outbox, "CREDITS", 10_000)
    with serving(create_app()) as address, woken(address) as (sleeper, since, head):
        assert backlog(seen_until_current(sleeper, head), since, head) > OLD_FRAMES
