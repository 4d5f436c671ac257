"""Frames do not wait for the disk; actions and verdicts do: a crash takes back none that a viewer got."""

import asyncio
import pickle
from collections.abc import Iterator
from pathlib import Path

import pytest
from commanded_disk import CommandedDisk, kept_on_disk
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import AddActor, SendEvent, StageSetup
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.publish.outbox import MOST_FACTS, Outbox
from statwalk.stage.state.frame import Verdict

BEND = ask.Post((SendEvent("BEND", 1),))


@pytest.fixture
def kept(tmp_path: Path) -> Iterator[tuple[StageHost, CommandedDisk]]:
    """A stage, and the disk that keeps it."""
    with kept_on_disk(tmp_path) as (held, disk):
        yield held.open(StageSetup(clock="manual", actors=(AddActor("elbow"),))), disk


async def texts(host: StageHost, outbox: Outbox, now: float = 0.0) -> list[bytes]:
    """What the viewer gets after the next look of the ticker, at `now`."""
    host.advance_to(now)
    await asyncio.sleep(0)
    return outbox.take_texts()


@pytest.mark.anyio
async def test_frames_do_not_wait_for_the_disk_and_verdicts_do(kept: tuple[StageHost, CommandedDisk]) -> None:
    """Not for the input alone: a stage that came back before the tick might get there by another way."""
    (host, disk), outbox = kept, Outbox("pose")
    host.join(outbox)
    outbox.take_texts()  # who watches
    host.handle(BEND)
    disk.goes_on.clear()
    host._live.tick()
    assert await texts(host, outbox) == []
    assert outbox.frame is not None
    assert outbox.frame.tick == 1
    disk.goes_on.set()
    disk.store.flush()
    assert [pickle.loads(text).event for text in await texts(host, outbox)] == ["BEND"]
    host.leave(outbox)


@pytest.mark.anyio
@pytest.mark.parametrize(("speed", "soon"), [(1.0, True), (0.25, False)])
async def test_verdicts_go_with_the_next_frame_if_that_is_due_soon(
    tmp_path: Path, speed: float, soon: bool
) -> None:
    with kept_on_disk(tmp_path) as (held, disk):
        host, outbox = held.open(StageSetup(clock="real", actors=(AddActor("elbow"),))), Outbox("pose")
        host.join(outbox)
        host.advance_to(0.0)
        host.handle(ask.SetSpeed(speed))
        host.handle(BEND)
        tick = 1 / 60 / speed
        assert await texts(host, outbox, 1.01 * tick) != []  # who watches, and the status
        disk.store.flush()
        alone = await texts(host, outbox, 1.02 * tick)
        with_a_frame = await texts(host, outbox, 2.01 * tick)
        assert [pickle.loads(text).event for text in (with_a_frame if soon else alone)] == ["BEND"]
        assert not (alone if soon else with_a_frame)
        host.leave(outbox)


@pytest.mark.anyio
async def test_who_comes_gets_no_verdicts_that_waited_for_who_has_left(tmp_path: Path) -> None:
    with kept_on_disk(tmp_path) as (held, disk):
        host = held.open(StageSetup(clock="real", actors=(AddActor("elbow"),)))
        first, second = Outbox("pose"), Outbox("pose")
        host.join(first)
        host.advance_to(0.0)
        host.handle(BEND)
        host.advance_to(1.01 / 60)
        host.leave(first)
        disk.store.flush()
        host.advance_to(1.02 / 60)
        host.join(second)
        got = [pickle.loads(text) for text in await texts(host, second, 2.01 / 60)]
        assert [fact for fact in got if isinstance(fact, Verdict)] == []
        host.leave(second)


@pytest.mark.anyio
async def test_one_write_at_a_time_follows_the_ticks(kept: tuple[StageHost, CommandedDisk]) -> None:
    (host, disk), outbox = kept, Outbox("pose")
    host.join(outbox)
    disk.goes_on.clear()
    for _ in range(5):
        host._live.apply(BEND, {})
        host._live.tick()
    assert disk.store.writer.length <= 6  # five inputs, and how far the stage is
    disk.goes_on.set()
    disk.store.flush()
    assert len(await texts(host, outbox)) < 5
    disk.store.flush()
    assert await texts(host, outbox)
    host.leave(outbox)


@pytest.mark.anyio
async def test_viewers_are_sent_away_rather_than_that_too_many_verdicts_wait(
    kept: tuple[StageHost, CommandedDisk],
) -> None:
    (host, disk), outbox = kept, Outbox("pose")
    host.join(outbox)
    outbox.take_texts()  # who watches
    host.handle(BEND)
    disk.goes_on.clear()
    host._live.facts_waiting.put(1, [b"fact"] * MOST_FACTS)
    host._live.tick()
    await asyncio.sleep(0)
    assert outbox.closing is not None
    assert (outbox.closing[0], outbox.take_texts()) == ("slow", [])
    host.leave(outbox)
