"""Many ticks of the past are computed in a worker, which answers as the server itself does."""

from collections.abc import Iterator
from functools import partial
from typing import Any

import numpy as np
import pytest
from stages import registry
from statwalk.services.cancel import NEVER, CancelToken
from statwalk.services.hosting import long_queries
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import AddActor, SendEvent, StageSetup
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.hosting.stage_replies import JointTracks
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.library.role_reference import reference_to
from statwalk.services.work.job import DoJob, Job, do_here
from statwalk.services.work.workers import Workers

WALK = (SendEvent("FORWARD", 1),)
QUESTIONS = [
    ask.Recording(0, 700),
    ask.Recording(0),
    ask.Joints(10, 690),
    ask.StickFigures(1, (0, 400, 700), "right"),
    ask.FrameFile(650),
]


@pytest.fixture(scope="module")
def held() -> Registry:
    return registry(Catalogue())


@pytest.fixture(scope="module")
def worker(held: Registry) -> Iterator[DoJob]:
    workers = Workers(partial(reference_to, held.catalogue), most=1)
    yield workers.do
    workers.close()


@pytest.fixture(scope="module")
def host(held: Registry) -> StageHost:
    """A walker that was sent forward; twelve seconds."""
    host = held.open(StageSetup(clock="manual", actors=(AddActor("faq-walker"),)))
    host.handle(ask.Post(WALK))
    host.handle(ask.Step(720))
    return host


def plain(reply: Any) -> Any:
    """Tracks of joints as values that can be compared."""
    return [vars(track) for track in reply.actors] if isinstance(reply, JointTracks) else reply


def answered_here(host: StageHost, question: ask.Message[Any]) -> Any:
    """The answer that the server computes from the stage itself."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(long_queries, "LONG", 10**9)
        return host.handle(question)


class Counted:
    """Work done here, and how often."""

    times = 0

    def __call__(self, about: str, job: Job[Any], *arguments: Any, token: CancelToken = NEVER) -> Any:
        self.times += 1
        return do_here(about, job, *arguments, token=token)


@pytest.mark.parametrize("question", QUESTIONS, ids=lambda question: type(question).__name__)
def test_a_worker_answers_as_the_server_does(
    held: Registry,
    host: StageHost,
    worker: DoJob,
    question: ask.Message[Any],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    here = answered_here(host, question)
    monkeypatch.setattr(held, "work", worker)
    np.testing.assert_equal(plain(host.handle(question)), plain(here))


@pytest.mark.parametrize(("last", "times"), [(20, 0), (700, 1)])
def test_only_what_takes_long_is_sent_to_a_worker(
    held: Registry, host: StageHost, last: int, times: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(held, "work", counted := Counted())
    host.handle(ask.Recording(0, last))
    assert counted.times == times


def test_a_machine_that_was_deleted_is_still_recorded(
    held: Registry, host: StageHost, worker: DoJob, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A worker can't load it any more: the server computes."""
    here = answered_here(host, ask.Recording(0, 700))
    monkeypatch.setattr(held, "work", worker)
    others = {name: entry for name, entry in held.catalogue.entries.items() if name != "faq-walker"}
    monkeypatch.setattr(held.catalogue, "entries", others)
    assert host.handle(ask.Recording(0, 700)) == here
