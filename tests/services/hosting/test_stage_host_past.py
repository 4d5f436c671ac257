"""Time on a stage behind messages: steps, pauses, forks, and what was at past ticks."""

import time

from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import (
    AddActor,
    SendEvent,
    StageSetup,
)
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.library.load import load
from statwalk.stage.history.state_codec import from_bytes


def test_step_to_stops_at_its_tick(host: StageHost) -> None:
    assert [host.handle(ask.StepTo(tick)).tick for tick in (15, 15, 3)] == [15, 15, 15]


def test_a_step_that_another_thread_keeps_waiting_is_soon_tried_again(held: Registry) -> None:
    """A stage that gets many inputs must not lose a whole tick each time that one of them holds it."""
    host, now = held.open(StageSetup()), time.perf_counter()
    with host._lock.held():
        assert host.advance_to(now) < 0.2 / host.rate


def test_a_pause_is_not_caught_up(held: Registry) -> None:
    """However long the clock stood still, it goes on from where it was."""
    host, now = held.open(StageSetup()), time.perf_counter()
    host.advance_to(now)
    host.handle(ask.Pause(True))
    host.advance_to(now + 100.0)
    host.handle(ask.Pause(False))
    assert host.handle(ask.Status()).tick <= 1


def test_a_fork_goes_its_own_way(held: Registry, host: StageHost) -> None:
    fork = held.find(host.handle(ask.Fork(4)))
    fork.handle(ask.Post((SendEvent("STOP", 1),)))
    fork.handle(ask.Step(6))
    here, there = host.handle(ask.Describe()), fork.handle(ask.Describe())
    assert (here.status.tick, there.status.tick, here.hash == there.hash) == (10, 10, False)


def test_effects_are_those_after_a_tick(host: StageHost) -> None:
    all_effects = host.handle(ask.Effects(0))
    assert next(verdict.event for verdict in all_effects.verdicts if verdict.verdict == "taken") == "FORWARD"
    later = host.handle(ask.Effects(1))
    assert later.verdicts == tuple(verdict for verdict in all_effects.verdicts if verdict.tick > 1)


def test_a_snapshot_is_the_state(host: StageHost) -> None:
    snapshot = host.handle(ask.Snapshot())
    again = from_bytes(snapshot.data, {"faq-walker": load("faq-walker")})
    assert (
        (again.tick, again.hash) == (snapshot.tick, snapshot.hash) == (10, host.handle(ask.Describe()).hash)
    )


def test_frames_of_the_past_are_those_that_were(host: StageHost) -> None:
    seen = []
    for tick in (2, 8, 5, 5, 9, 10):
        host.handle(ask.Seek(tick))
        seen.append(host.handle(ask.Frame("pose")).data)
    host.handle(ask.Seek(10))
    assert [host.handle(ask.Frame("pose", tick)).data for tick in (2, 8, 5, 5, 9, 10)] == seen


def test_who_came_at_the_newest_tick_is_in_its_frame(host: StageHost) -> None:
    before = host.handle(ask.Frame("pose", 10))
    host.handle(ask.Post((AddActor("faq-walker"),)))
    after = host.handle(ask.Frame("pose", 10))
    assert [len(frame.layout.casts[0].actors) for frame in (before, after)] == [1, 2]
