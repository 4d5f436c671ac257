"""A post answers with its number in the log, when it is durable."""

import json
import threading
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor

import pytest
from serving import PATIENCE
from statwalk.errors import CancelledError
from statwalk.services.cancel import CancelToken
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import (
    SendEvent,
)
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.stage_host import StageHost
from statwalk.stage.history.log import MemoryLog
from statwalk.stage.state.commands import LogEntry

FORWARD = SendEvent("FORWARD", 1)


def logged_numbers(host: StageHost) -> list[int]:
    return [json.loads(line)["number"] for line in host.handle(ask.Log())[1:]]


def test_a_post_answers_with_the_number_in_the_log(host: StageHost) -> None:
    posted = [host.handle(ask.Post((FORWARD,))).seq for _ in range(3)]
    assert posted == logged_numbers(host)[-3:]


def test_a_post_to_the_past_answers_with_the_number_in_the_fork_s_log(
    held: Registry, host: StageHost
) -> None:
    for _ in range(3):
        host.handle(ask.Post((FORWARD,)))
    host.handle(ask.Step(3))
    posted = host.handle(ask.Post((FORWARD,), at=7))
    assert posted.seq == logged_numbers(held.find(posted.stage))[-1]


def test_a_fork_keeps_the_number_of_what_waits(held: Registry, host: StageHost) -> None:
    waiting = host.handle(ask.Post((FORWARD,))).seq
    fork = held.find(host.handle(ask.Fork()))
    assert logged_numbers(fork)[-1] == waiting


class SlowLog(MemoryLog):
    """A log on a slow disk: commands are durable once `written` is set."""

    def __init__(self, entries: Iterable[LogEntry] = ()) -> None:
        super().__init__(entries)
        self.written, self.asked = threading.Event(), threading.Event()

    def durable(self, number: int, seconds: float = 0.0) -> bool:
        self.asked.set()
        return self.written.wait(seconds) and super().durable(number)


def test_a_post_is_acknowledged_when_it_is_durable(host: StageHost) -> None:
    log = SlowLog(host._live.stage._log)
    host._live.stage._log = log
    with ThreadPoolExecutor(1) as pool:
        answer = pool.submit(host.handle, ask.Post((FORWARD,)))
        assert log.asked.wait(PATIENCE)
        assert not answer.done()
        log.written.set()
        assert answer.result(10).seq == log.newest


def test_a_post_that_is_given_up_does_not_wait_for_the_disk(host: StageHost) -> None:
    log, token = SlowLog(host._live.stage._log), CancelToken()
    host._live.stage._log = log
    with ThreadPoolExecutor(1) as pool:
        answer = pool.submit(host.handle, ask.Post((FORWARD,)), token)
        assert log.asked.wait(PATIENCE)
        token.cancel()
        with pytest.raises(CancelledError):
            answer.result(10)
