"""A stage behind messages: what they do, that they are plain data, one lock per input; long work lets others
in and can be ended.
"""

import asyncio
import json
import pickle
import sys
import threading
import time
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import asdict, is_dataclass
from typing import Any

import numpy as np
import pytest
from serving import wait_for
from stages import registry
from statwalk.errors import CancelledError, ConflictError, StageError, UnknownNameError
from statwalk.services.cancel import CancelToken
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import (
    AddActor,
    RemoveActor,
    SendEvent,
    SetParameter,
    StageSetup,
    TravelTo,
)
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.library.load import load
from statwalk.services.publish.outbox import MOST_FACTS, Outbox
from statwalk.stage.history.log import MemoryLog
from statwalk.stage.history.state_codec import from_bytes
from statwalk.stage.state.commands import LogEntry

TICKS = 1_200
FOR_EVER = 36_000
FORWARD = SendEvent("FORWARD", 1)
COMMANDS = (
    AddActor("walker-layers"),
    FORWARD,
    SetParameter("speed", 1.5),
    TravelTo(1, "FLY"),
    TravelTo(1, ""),
    RemoveActor(2),
)


@pytest.fixture(scope="module")
def held() -> Registry:
    return registry(Catalogue())


@pytest.fixture
def host(held: Registry) -> Iterator[StageHost]:
    """A walker that was sent forward ten ticks ago."""
    host = held.open(StageSetup(clock="manual", actors=(AddActor("faq-walker"),)))
    host.handle(ask.Post((FORWARD,)))
    host.handle(ask.Step(10))
    yield host
    for other in held.all():
        held.close(other.id)


def text_of(held: Registry) -> str:
    return held.versions.of("faq-walker")[-1].text


MESSAGES: dict[type, Callable[[Registry], ask.Message[Any]]] = {
    ask.Post: lambda _: ask.Post(COMMANDS),
    ask.Edit: lambda held: ask.Edit("faq-walker", text_of(held)),
    ask.Step: lambda _: ask.Step(2),
    ask.StepTo: lambda _: ask.StepTo(12),
    ask.Seek: lambda _: ask.Seek(3),
    ask.Fork: lambda _: ask.Fork(4),
    ask.Pause: lambda _: ask.Pause(True),
    ask.SetSpeed: lambda _: ask.SetSpeed(2.0),
    ask.Close: lambda _: ask.Close(),
    ask.Status: lambda _: ask.Status(),
    ask.Describe: lambda _: ask.Describe(),
    ask.DescribeActors: lambda _: ask.DescribeActors(1),
    ask.PoseOf: lambda _: ask.PoseOf(1),
    ask.Machines: lambda _: ask.Machines(),
    ask.Effects: lambda _: ask.Effects(0),
    ask.History: lambda _: ask.History(),
    ask.Log: lambda _: ask.Log(),
    ask.Snapshot: lambda _: ask.Snapshot(),
    ask.Frame: lambda _: ask.Frame("glb", 5),
    ask.FrameFile: lambda _: ask.FrameFile(5),
    ask.Recording: lambda _: ask.Recording(2, 6),
    ask.Why: lambda _: ask.Why(1, 1),
    ask.WhyNot: lambda _: ask.WhyNot(1, "JUMP", 5),
}


def plain(value: object) -> object:
    return asdict(value) if is_dataclass(value) and not isinstance(value, type) else value


@pytest.mark.parametrize("kind", ask.Message.__subclasses__(), ids=lambda kind: kind.__name__)
def test_a_message_and_its_reply_are_plain_data(held: Registry, host: StageHost, kind: type) -> None:
    message = MESSAGES[kind](held)
    assert pickle.loads(pickle.dumps(message)) == message
    reply = host.handle(message)
    np.testing.assert_equal(plain(pickle.loads(pickle.dumps(reply))), plain(reply))


def test_nothing_of_the_live_stage_is_reached_through_the_host(host: StageHost) -> None:
    reached = [type(value).__module__ for name, value in vars(host).items() if not name.startswith("_")]
    assert [module for module in reached if module.startswith("statwalk")] == [Registry.__module__]


# --- inputs


def test_an_input_belongs_to_the_next_tick(host: StageHost) -> None:
    posted = host.handle(ask.Post((FORWARD,)))
    assert (posted.tick, posted.seq, posted.stage) == (10, 3, host.id)


def test_outcomes_come_in_the_order_of_the_commands(host: StageHost) -> None:
    actor, nothing, plan = host.handle(
        ask.Post((AddActor("faq-walker", name="Ann"), FORWARD, TravelTo(1, "FLY")))
    ).outcomes
    assert (actor.name, actor.id, nothing, plan.goal) == ("Ann", 2, None, "FLY")


def test_an_input_that_is_seen_at_the_head_goes_to_a_fork_while_the_playhead_is_in_the_past(
    held: Registry, host: StageHost
) -> None:
    host.handle(ask.Seek(4))
    posted = host.handle(ask.Post((FORWARD,), at=10))
    assert posted.stage != host.id
    assert (
        posted.tick,
        held.find(posted.stage).handle(ask.Status()).tick,
        host.handle(ask.Status()).tick,
    ) == (10, 10, 4)


def test_an_input_in_the_past_is_refused_where_it_may_not_fork(held: Registry, host: StageHost) -> None:
    host.handle(ask.Seek(4))
    with pytest.raises(StageError, match="call fork"):
        host.handle(ask.Post((FORWARD,), forks=False))
    assert held.all() == [host]


@pytest.mark.parametrize(
    "command", [SendEvent("DANCE"), SendEvent("FORWARD", 99), SetParameter("mood", 1.0), TravelTo(1, "MOON")]
)
def test_an_unknown_name_is_refused_and_leaves_no_fork(held: Registry, host: StageHost, command: Any) -> None:
    host.handle(ask.Seek(4))
    with pytest.raises(UnknownNameError):
        host.handle(ask.Post((command,)))
    assert held.all() == [host]


def test_an_event_for_all_needs_somebody(held: Registry) -> None:
    with pytest.raises(ConflictError, match="no actors"):
        held.open(StageSetup()).handle(ask.Post((SendEvent("FORWARD"),)))


def state_after_forward(host: StageHost) -> str:
    """Of a new actor that is sent forward."""
    (actor,) = host.handle(ask.Post((AddActor("faq-walker"),))).outcomes
    host.handle(ask.Post((SendEvent("FORWARD", actor.id),)))
    host.handle(ask.Step(2))
    return host.handle(ask.DescribeActors(actor.id))[0].state


def test_an_edit_is_played_at_once(held: Registry, host: StageHost) -> None:
    before = state_after_forward(host)
    assert host.handle(ask.Edit("faq-walker", text_of(held).replace("STAT  | STWK ", "STAT  | WALK ")))
    assert (before, state_after_forward(host)) == ("STWK", "WALK")


def test_an_edit_does_not_count_in_the_past(held: Registry, host: StageHost) -> None:
    host.handle(ask.Seek(4))
    assert host.handle(ask.Edit("faq-walker", text_of(held))) is False


class CountingLock:
    """Counts how often a lock is taken."""

    def __init__(self) -> None:
        self.lock, self.taken = threading.Lock(), 0

    def acquire(self, blocking: bool = True, timeout: float = -1) -> bool:
        self.taken += 1
        return self.lock.acquire(blocking, timeout)

    def release(self) -> None:
        self.lock.release()


@pytest.mark.parametrize("commands", [(FORWARD,), COMMANDS])
def test_inputs_take_the_lock_once(host: StageHost, commands: Any) -> None:
    host._lock.lock = counting = CountingLock()
    host.handle(ask.Post(commands))
    assert counting.taken == 1


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
    "effects": ask.Effects(-1),
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
    text = text_of(held)
    _, played = (calls_while_held(host, ask.Edit("faq-walker", text)) for _ in range(2))
    new = calls_while_held(host, ask.Edit("faq-walker", text.replace("STAT  | STWK ", "STAT  | WALK ")))
    assert new <= played


# --- time, and the past


def test_step_to_stops_at_its_tick(host: StageHost) -> None:
    assert [host.handle(ask.StepTo(tick)).tick for tick in (15, 15, 3)] == [15, 15, 15]


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
    all_effects = host.handle(ask.Effects(-1))
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


# --- long work


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
        assert isinstance(work.exception(timeout=2), CancelledError)


def test_long_work_ends_when_its_stage_is_closed(held: Registry, host: StageHost) -> None:
    with at_work(host, ask.Step(FOR_EVER), CancelToken()) as work:
        wait_for(lambda: host.handle(ask.Status()).tick > 10)
        held.close(host.id)
        assert isinstance(work.exception(timeout=2), CancelledError)


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
        assert log.asked.wait(10)
        assert not answer.done()
        log.written.set()
        assert answer.result(10).seq == log.newest


def test_a_post_that_is_given_up_does_not_wait_for_the_disk(host: StageHost) -> None:
    log, token = SlowLog(host._live.stage._log), CancelToken()
    host._live.stage._log = log
    with ThreadPoolExecutor(1) as pool:
        answer = pool.submit(host.handle, ask.Post((FORWARD,)), token)
        assert log.asked.wait(10)
        token.cancel()
        with pytest.raises(CancelledError):
            answer.result(10)


@pytest.mark.anyio
async def test_frames_do_not_wait_for_the_disk_and_verdicts_do(host: StageHost) -> None:
    log, outbox = SlowLog(host._live.stage._log), Outbox("pose")
    host._live.stage._log = log
    host.join(outbox)
    host._live.apply((FORWARD,), {})
    host.handle(ask.Step(1))
    host.advance_to(0.0)
    await asyncio.sleep(0)
    assert outbox.frame is not None
    assert (outbox.frame.tick, outbox.take_texts()) == (11, [])
    log.written.set()
    host.advance_to(0.0)
    await asyncio.sleep(0)
    assert [pickle.loads(text).event for text in outbox.take_texts()] == ["FORWARD"]
    host.leave(outbox)


@pytest.mark.anyio
async def test_viewers_are_sent_away_rather_than_that_too_many_verdicts_wait(host: StageHost) -> None:
    outbox = Outbox("pose")
    host._live.stage._log = SlowLog(host._live.stage._log)
    host.join(outbox)
    host._live.facts_waiting.put(1, [b"fact"] * MOST_FACTS)
    host._live.apply((FORWARD,), {})
    host.handle(ask.Step(1))
    await asyncio.sleep(0)
    assert outbox.closing is not None
    assert (outbox.closing[0], outbox.take_texts()) == ("slow", [])
    host.leave(outbox)


def test_actors_of_a_machine_come_together(held: Registry) -> None:
    crowd = tuple(AddActor("faq-walker", (float(place), 0.0, 0.0)) for place in range(300))
    host = held.open(StageSetup(clock="manual", actors=(*crowd, AddActor("walker-layers"))))
    actors = host.handle(ask.Describe()).actors
    assert [actor.position[0] for actor in actors[:300]] == [command.position[0] for command in crowd]
    assert actors[300].machine == "walker-layers"


def test_a_stage_that_nobody_waits_for_is_not_opened(held: Registry) -> None:
    token = CancelToken()
    token.cancel()
    before = len(held.all())
    with pytest.raises(CancelledError):
        held.open(StageSetup(actors=(AddActor("faq-walker"),)), token)
    assert len(held.all()) == before
