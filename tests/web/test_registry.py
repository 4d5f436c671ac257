"""How many stages and actors there may be, and which stages are let go."""

import time

import httpx
import pytest
from statwalk.stage.stage import Stage
from statwalk.web.app import create_app
from statwalk.web.keeping.catalogue import Catalogue
from statwalk.web.keeping.hosted import HostedStage
from statwalk.web.keeping.registry import Registry
from statwalk.web.problem import Problem
from statwalk.web.schemas import NewActor, NewEvent, NewStage
from statwalk.web.settings import Settings
from statwalk.web.streaming.mailbox import Mailbox


@pytest.fixture(scope="module")
def catalogue() -> Catalogue:
    return Catalogue()


def registry(catalogue: Catalogue, **limits: int | float) -> Registry:
    return Registry(catalogue, Settings(**limits))


def test_idle_stages_are_let_go_and_no_others(catalogue: Catalogue) -> None:
    """A client with a clock of its own may think for an hour; then its stage makes room for others."""
    held = registry(catalogue, idle_seconds=600.0)
    main, idle = held.open_main(), held.open(NewStage())
    thinking, forgotten, watched = held.open(NewStage(clock="manual")), held.open(NewStage(clock="manual")), held.open(NewStage())
    watched.broadcast.mailboxes = frozenset({Mailbox("pose")})
    for hosted, minutes in ((main, 700), (idle, 11), (thinking, 50), (forgotten, 61), (watched, 700)):
        hosted.touched = time.monotonic() - 60 * minutes
    held.drop_idle()
    assert held.all() == [main, thinking, watched]


def test_a_stage_that_was_watched_until_now_is_not_idle(catalogue: Catalogue) -> None:
    """Its viewer may only load the page again."""
    held = registry(catalogue)
    hosted, mailbox = held.open(NewStage()), Mailbox("pose")
    hosted.broadcast.mailboxes = frozenset({mailbox})
    hosted.touched = time.monotonic() - 2 * held.settings.idle_seconds
    hosted.leave(mailbox)
    held.drop_idle()
    assert held.all() == [hosted]


def test_an_input_that_is_seen_at_the_head_goes_to_a_fork_while_the_playhead_is_in_the_past(catalogue: Catalogue) -> None:
    held = registry(catalogue)
    hosted = held.open(NewStage(clock="manual", actors=[NewActor(machine="faq-walker")]))
    hosted.step(10)
    hosted.seek(4)
    accepted = held.post(hosted, NewEvent(event="FORWARD"), looked_at=10)
    assert accepted.stage != hosted.id
    assert (accepted.tick, hosted.stage.tick) == (10, 4)


def test_a_stage_more_than_there_may_be_is_refused(catalogue: Catalogue) -> None:
    held = registry(catalogue, most_stages=1)
    held.open(NewStage())
    with pytest.raises(Problem, match="the most it may"):
        held.open(NewStage())


def test_an_actor_more_than_there_may_be_is_refused(catalogue: Catalogue) -> None:
    held = registry(catalogue, most_actors=1)
    hosted = held.open(NewStage(actors=[NewActor(machine="faq-walker")]))
    with pytest.raises(Problem, match="the most it may"):
        held.place(hosted, NewActor(machine="faq-walker"))


def test_a_pause_is_not_caught_up(catalogue: Catalogue) -> None:
    """However long the clock stood still, it goes on from where it was."""
    hosted = HostedStage("x", Stage(), "real", catalogue)
    hosted.advance_to(time.perf_counter())
    hosted.pause(True)
    hosted.clock.due(time.perf_counter() - 100.0)
    hosted.pause(False)
    hosted.advance_to(time.perf_counter())
    assert hosted.stage.tick <= 1


@pytest.mark.anyio
async def test_main_stays() -> None:
    """The page opens on it."""
    async with httpx.AsyncClient(transport=httpx.ASGITransport(create_app()), base_url="http://localhost") as client:
        assert (await client.delete("/api/stages/main")).status_code == 409
        assert (await client.get("/api/stages/main")).status_code == 200
