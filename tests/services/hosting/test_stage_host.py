"""A stage behind messages: they are plain data, and what an input does, under one lock."""

import pickle
import threading
from collections.abc import Callable
from dataclasses import asdict, is_dataclass
from typing import Any

import numpy as np
import pytest
from statwalk.errors import ConflictError, StageError, UnknownNameError
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.audience import Audience
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
from statwalk.services.hosting.store.records import StageIdentity

FORWARD = SendEvent("FORWARD", 1)
COMMANDS = (
    AddActor("walker-layers"),
    FORWARD,
    SetParameter("speed", 1.5),
    TravelTo(1, "FLY"),
    TravelTo(1, ""),
    RemoveActor(2),
)


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
    ask.Rename: lambda _: ask.Rename("Idea B"),
    ask.Viewers: lambda _: ask.Viewers(),
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
    ask.StickFigures: lambda _: ask.StickFigures(1, (2, 5), "front"),
    ask.Recording: lambda _: ask.Recording(2, 6),
    ask.Joints: lambda _: ask.Joints(2, 6),
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
    plain_data = StageIdentity.__module__
    assert {module for module in reached if module.startswith("statwalk")} == {
        Registry.__module__,
        Audience.__module__,
        plain_data,
    }


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


def test_actors_of_a_machine_come_together(held: Registry) -> None:
    crowd = tuple(AddActor("faq-walker", (float(place), 0.0, 0.0)) for place in range(300))
    host = held.open(StageSetup(clock="manual", actors=(*crowd, AddActor("walker-layers"))))
    actors = host.handle(ask.Describe()).actors
    assert [actor.position[0] for actor in actors[:300]] == [command.position[0] for command in crowd]
    assert actors[300].machine == "walker-layers"
