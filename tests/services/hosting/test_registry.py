"""How many stages and actors there may be, and which stages are let go."""

import time
from dataclasses import replace
from pathlib import Path

import httpx
import pytest
from keeping import keeping
from serving import wait_for
from stages import registry
from statwalk.errors import LimitError, UnknownNameError
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import AddActor, SendEvent, StageSetup
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.store.writer import Statement
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.publish.outbox import Outbox
from statwalk.web.app import create_app

WALKER = AddActor("faq-walker")


@pytest.fixture(scope="module")
def catalogue() -> Catalogue:
    return Catalogue()


@pytest.mark.anyio
async def test_idle_stages_are_let_go_and_no_others(catalogue: Catalogue) -> None:
    """A client with a clock of its own may think for an hour; then its stage makes room for others."""
    held = registry(catalogue, idle_seconds=600.0)
    main, idle, watched = held.open_main(), held.open(StageSetup()), held.open(StageSetup())
    thinking = held.open(StageSetup(clock="manual"))
    watched.join(Outbox("pose"))
    left = []
    for minutes in (9, 11, 59, 61):
        held.drop_idle(time.monotonic() + 60 * minutes)
        left.append(held.all())
    assert left == [[main, idle, watched, thinking], *[[main, watched, thinking]] * 2, [main, watched]]


@pytest.mark.anyio
async def test_a_stage_that_was_watched_until_now_is_not_idle(catalogue: Catalogue) -> None:
    """Its viewer may only load the page again."""
    host, outbox = registry(catalogue).open(StageSetup()), Outbox("pose")
    opened = time.monotonic()
    host.join(outbox)
    wait_for(lambda: time.monotonic() > opened)
    host.leave(outbox)
    assert host.idle_for(opened) < 0


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
    past.find(claimed)
    past.drop_idle(time.monotonic() + 61)
    assert (claimed in past.stages, unclaimed in past.stages) == (True, False)


def test_the_clock_of_a_fork_that_nobody_uses_stands(catalogue: Catalogue) -> None:
    """It starts when somebody asks for the fork, and catches nothing up."""
    held = registry(catalogue)
    host = held.open(StageSetup(actors=(WALKER,)))
    host.handle(ask.Step(3))
    fork = held.stages[host.handle(FORWARD_AT_0).stage]
    ticks = []
    for now in (0.0, 0.1, 0.2):
        fork.advance_to(now)
        ticks.append(fork.handle(ask.Status()).tick)
    held.find(fork.id)
    for now in (100.0, 100.1):
        fork.advance_to(now)
        ticks.append(fork.handle(ask.Status()).tick)
    assert ticks == [0, 0, 0, 0, 6]


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


def test_the_status_says_why_nothing_can_be_kept(tmp_path: Path, catalogue: Catalogue) -> None:
    with keeping(tmp_path, catalogue) as held:
        host, store = held.open(StageSetup(clock="manual")), held.store
        assert host.handle(ask.Status()).trouble == ""
        assert store is not None
        connection = store.writer._committer._connection
        assert connection is not None
        connection.execute("PRAGMA max_page_count=1")  # as small as the database is now
        store.writer.put([Statement("INSERT INTO snapshots VALUES ('s', 1, zeroblob(40000), x'')", [()])])
        wait_for(lambda: "the disk is full" in host.handle(ask.Status()).trouble)
        wait_for(lambda: host.handle(ask.Status()).trouble == "")  # it tries again with a new connection
