"""How many stages and actors there may be, and which stages are let go."""

import time
from dataclasses import replace

import httpx
import pytest
from stages import registry
from statwalk.errors import LimitError, UnknownNameError
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import AddActor, SendEvent, StageSetup
from statwalk.services.hosting.registry import Registry
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.publish.outbox import Outbox
from statwalk.web.app import create_app

WALKER = AddActor("faq-walker")


@pytest.fixture(scope="module")
def catalogue() -> Catalogue:
    return Catalogue()


def test_idle_stages_are_let_go_and_no_others(catalogue: Catalogue) -> None:
    """A client with a clock of its own may think for an hour; then its stage makes room for others."""
    held = registry(catalogue, idle_seconds=600.0)
    manual = StageSetup(clock="manual")
    main, idle, watched = held.open_main(), held.open(StageSetup()), held.open(StageSetup())
    thinking, forgotten = held.open(manual), held.open(manual)
    watched.fanout.outboxes = frozenset({Outbox("pose")})
    for host, minutes in ((main, 700), (idle, 11), (thinking, 50), (forgotten, 61), (watched, 700)):
        host.touched = time.monotonic() - 60 * minutes
    held.drop_idle()
    assert held.all() == [main, watched, thinking]


def test_a_stage_that_was_watched_until_now_is_not_idle(catalogue: Catalogue) -> None:
    """Its viewer may only load the page again."""
    held = registry(catalogue)
    host, outbox = held.open(StageSetup()), Outbox("pose")
    host.fanout.outboxes = frozenset({outbox})
    host.touched = time.monotonic() - 2 * held.limits.idle_seconds
    host.leave(outbox)
    held.drop_idle()
    assert held.all() == [host]


def test_a_stage_more_than_there_may_be_is_refused(catalogue: Catalogue) -> None:
    held = registry(catalogue, stages=1)
    held.open(StageSetup())
    with pytest.raises(LimitError, match="and no more"):
        held.open(StageSetup())


def test_an_actor_more_than_there_may_be_is_refused(catalogue: Catalogue) -> None:
    host = registry(catalogue, actors=1).open(StageSetup(actors=(WALKER,)))
    with pytest.raises(LimitError, match="at most 1 actors"):
        host.handle(ask.Post((WALKER,)))


FORWARD_AT_0 = ask.Post((SendEvent("FORWARD"),), 0)


@pytest.fixture
def past(catalogue: Catalogue) -> Registry:
    """Two of at most four stages; one has a past."""
    held = registry(catalogue, stages=4, idle_seconds=600.0)
    held.open(StageSetup(clock="manual"))
    host = held.open(StageSetup(clock="manual", actors=(WALKER,)))
    host.handle(ask.Step(3))
    return held


def test_forks_that_nobody_uses_leave_room_for_stages(past: Registry) -> None:
    host = past.all()[-1]
    past.limits = replace(past.limits, stages=6)
    for _ in range(3):
        host.handle(FORWARD_AT_0)
    with pytest.raises(LimitError, match="forks that nobody uses"):
        host.handle(FORWARD_AT_0)
    assert past.open(StageSetup()) in past.all()


def test_a_fork_that_nobody_uses_is_let_go_sooner(past: Registry) -> None:
    """After a minute, unless somebody has asked for it; that one is kept for an hour."""
    host = past.all()[-1]
    claimed, unclaimed = (host.handle(FORWARD_AT_0).stage for _ in range(2))
    past.find(claimed).touched = past.stages[unclaimed].touched = time.monotonic() - 61
    past.drop_idle()
    assert (claimed in past.stages, unclaimed in past.stages) == (True, False)


def test_a_stage_that_was_closed_is_not_found(catalogue: Catalogue) -> None:
    held = registry(catalogue)
    host = held.open(StageSetup())
    held.close(host.id)
    with pytest.raises(UnknownNameError, match="no stage is called"):
        held.find(host.id)


@pytest.mark.anyio
async def test_main_stays() -> None:
    """The page opens on it."""
    async with httpx.AsyncClient(
        transport=httpx.ASGITransport(create_app()), base_url="http://localhost"
    ) as client:
        assert (await client.delete("/api/stages/main")).status_code == 409
        assert (await client.get("/api/stages/main")).status_code == 200
