"""How long a message holds its stage, counted in calls: no longer for many actors than for one."""

import sys
import threading
from typing import Any

import pytest
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import AddActor, SendEvent, StageSetup
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.stage_host import StageHost


class CallsWhileHeld:
    """A lock that counts the calls of Python functions while a thread holds it."""

    def __init__(self) -> None:
        self.lock, self.calls = threading.Lock(), 0

    def acquire(self, blocking: bool = True, timeout: float = -1) -> bool:
        taken = self.lock.acquire(blocking, timeout)
        sys.setprofile(self.count)
        return taken

    def count(self, _: object, event: str, __: object) -> None:
        self.calls += event == "call"

    def release(self) -> None:
        sys.setprofile(None)
        self.lock.release()


def calls_while_held(host: StageHost, message: ask.Message[Any]) -> int:
    host._lock.lock = lock = CallsWhileHeld()
    host.handle(message)
    return lock.calls


QUERIES = {
    "describe": ask.Describe(),
    "actors": ask.DescribeActors(),
    "effects": ask.Effects(0),
    "history": ask.History(),
    "log": ask.Log(),
    "frame": ask.Frame("pose"),
}


@pytest.mark.parametrize("message", QUERIES.values(), ids=QUERIES)
def test_a_query_holds_many_actors_no_longer_than_one(
    held: Registry, host: StageHost, message: ask.Message[Any]
) -> None:
    crowd = held.open(StageSetup(clock="manual", actors=(AddActor("faq-walker"),) * 100))
    crowd.handle(ask.Post((SendEvent("FORWARD"),)))
    crowd.handle(ask.Step(10))
    assert calls_while_held(crowd, message) <= calls_while_held(host, message) + 10


def test_an_edit_is_compiled_before_the_stage_is_held(held: Registry, host: StageHost) -> None:
    text = held.versions.of("faq-walker")[-1].text
    _, played = (calls_while_held(host, ask.Edit("faq-walker", text)) for _ in range(2))
    new = calls_while_held(host, ask.Edit("faq-walker", text.replace("STAT  | STWK ", "STAT  | WALK ")))
    assert new <= played
