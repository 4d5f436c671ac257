"""Long work of a stage lets others in, and can be ended."""

import threading
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from typing import Any

import pytest
from serving import PATIENCE, wait_for
from statwalk.errors import CancelledError
from statwalk.services.cancel import CancelToken
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import (
    AddActor,
    SendEvent,
    StageSetup,
)
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.stage_host import StageHost

TICKS = 1_200
FOR_EVER = 36_000
FORWARD = SendEvent("FORWARD", 1)


@contextmanager
def at_work(host: StageHost, message: ask.Message[Any], token: CancelToken) -> Iterator[Any]:
    with ThreadPoolExecutor(1) as aside:
        yield aside.submit(host.handle, message, token)


def ticks_seen(host: StageHost, message: ask.Message[Any]) -> set[int]:
    """The ticks at which another thread had the stage while it worked."""
    with at_work(host, message, CancelToken()) as work:
        seen = set()
        while not work.done():
            seen.add(host.handle(ask.Describe()).status.tick)
    return seen


def test_many_steps_are_seen_on_their_way(host: StageHost) -> None:
    seen = ticks_seen(host, ask.Step(TICKS))
    assert host.handle(ask.Status()).tick == 10 + TICKS
    assert any(10 < tick < 10 + TICKS for tick in seen)


def test_a_long_seek_moves_the_playhead_once(host: StageHost) -> None:
    host.handle(ask.Step(TICKS))
    assert ticks_seen(host, ask.Seek(7)) <= {10 + TICKS, 7}
    assert host.handle(ask.Status()).tick == 7


LONG = {
    "step": ask.Step(3),
    "step to": ask.StepTo(13),
    "seek": ask.Seek(3),
    "fork": ask.Fork(3),
    "input of the past": ask.Post((FORWARD,), at=3),
    "frame": ask.Frame("pose", 3),
    "frame file": ask.FrameFile(3),
    "recording": ask.Recording(1, 9),
    "why": ask.Why(1, 3),
    "why not": ask.WhyNot(1, "JUMP", 3),
}


@pytest.mark.parametrize("message", LONG.values(), ids=LONG)
def test_nothing_goes_on_for_a_client_that_has_gone(
    held: Registry, host: StageHost, message: ask.Message[Any]
) -> None:
    token = CancelToken()
    token.cancel()
    with pytest.raises(CancelledError):
        host.handle(message, token)
    assert (host.handle(ask.Status()).tick, held.all()) == (10, [host])
    host.handle(message)


def test_the_server_s_end_cancels_what_every_client_asked_for(host: StageHost) -> None:
    ending = threading.Event()
    with at_work(host, ask.Step(FOR_EVER), CancelToken(ending)) as work:
        wait_for(lambda: host.handle(ask.Status()).tick > 10)
        ending.set()
        assert isinstance(work.exception(PATIENCE), CancelledError)


def test_long_work_ends_when_its_stage_is_closed(held: Registry, host: StageHost) -> None:
    with at_work(host, ask.Step(FOR_EVER), CancelToken()) as work:
        wait_for(lambda: host.handle(ask.Status()).tick > 10)
        held.close(host.id)
        assert isinstance(work.exception(PATIENCE), CancelledError)


def test_a_stage_that_nobody_waits_for_is_not_opened(held: Registry) -> None:
    token = CancelToken()
    token.cancel()
    before = len(held.all())
    with pytest.raises(CancelledError):
        held.open(StageSetup(actors=(AddActor("faq-walker"),)), token)
    assert len(held.all()) == before
