"""A stage that the server holds: one lock around it, its clock, its viewers. Every method may be called from any thread."""

from __future__ import annotations

import threading
import time
from collections import OrderedDict
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from statwalk.errors import UnknownNameError
from statwalk.stage.clock import Clock
from statwalk.stage.frame import Frame
from statwalk.stage.stage import Actor, Stage
from statwalk.web import messages, wire
from statwalk.web.broadcast import Broadcast
from statwalk.web.glbframes import GlbFrames
from statwalk.web.library import Library
from statwalk.web.mailbox import FrameKind, Layout, Shown
from statwalk.web.problem import Problem
from statwalk.web.schemas import Clock as ClockKind
from statwalk.web.schemas import NewEvent, NewParameter

BUSY_SECONDS = 20.0
WAIT_FOR_CHANGE = 0.25
MOST_LAYOUTS = 16


class HostedStage:
    """`id` names it in the API; `clock_kind` says whether time moves it or only `step`."""

    def __init__(self, stage_id: str, stage: Stage, clock_kind: ClockKind, library: Library) -> None:
        self.id, self.stage, self.clock_kind, self.library = stage_id, stage, clock_kind, library
        self.clock = Clock(stage.rate)
        self.lock = threading.RLock()
        self.broadcast = Broadcast()
        self.glb = GlbFrames()
        self.layouts: OrderedDict[tuple[tuple[str, bytes], ...], Layout] = OrderedDict()
        self.epoch = 0
        self.touched = time.monotonic()

    @contextmanager
    def turn(self) -> Iterator[Stage]:
        """The stage, for one caller at a time.

        :raises Problem: 503, if another caller's long step holds it for 20 s.
        """
        if not self.lock.acquire(timeout=BUSY_SECONDS):
            raise Problem(503, "the stage is busy with a long step; try again")
        try:
            self.touched = time.monotonic()
            yield self.stage
        finally:
            self.lock.release()

    # --- time

    def advance_to(self, now: float) -> float:
        """For the pacer: takes the steps that are due; the seconds until the next one is. Passes by a stage that is in use."""
        if self.clock_kind == "manual" or not self.lock.acquire(blocking=False):
            return WAIT_FOR_CHANGE if self.clock_kind == "manual" else 1 / self.stage.rate
        try:
            for _ in range(self.clock.due(now)):
                self.tick()
            return self.clock.wait(now)
        finally:
            self.lock.release()

    def tick(self) -> None:
        """One step, shown to the viewers."""
        self.stage.step(1)
        self.show(self.stage.frame)

    def step(self, ticks: int) -> None:
        """So many steps, each shown to the viewers."""
        with self.turn():
            for _ in range(ticks):
                self.tick()

    def seek(self, tick: int) -> None:
        """Moves the playhead, for everybody."""
        with self.turn() as stage:
            stage.seek(tick)
            self.show(stage.frame, facts=False)
            self.announce()

    def pause(self, paused: bool) -> None:
        """Stops or starts the clock."""
        with self.turn():
            self.clock.paused = paused
            self.announce()

    def set_speed(self, speed: float) -> None:
        """Makes the clock run faster or slower."""
        with self.turn():
            self.clock.speed = speed
            self.announce()

    # --- frames

    def show(self, frame: Frame, facts: bool = True) -> None:
        """Publishes a frame, in the kinds that are watched, and what happened in its tick."""
        if not self.broadcast.mailboxes:
            return
        shown = {kind: self.encode(frame, kind, self.stage) for kind in self.broadcast.kinds()}
        happened = [messages.action(done) for done in frame.actions] + [messages.verdict(given) for given in frame.verdicts]
        self.broadcast.publish(shown, happened if facts else ())

    def encode(self, frame: Frame, kind: FrameKind, stage: Stage) -> Shown:
        """A frame as a message; `stage` is the one it comes from, which knows the actors' names."""
        layout = self.layout(frame, stage)
        if kind == "glb":
            return Shown(frame.tick, kind, layout, self.glb.frame(frame, layout.epoch))
        return Shown(frame.tick, kind, layout, wire.encode(frame, layout.epoch, self.stage.head))

    def layout(self, frame: Frame, stage: Stage) -> Layout:
        """The layout of a frame: the same epoch for the same actors, as long as it is remembered."""
        key = tuple((cast.role.name, cast.ids.tobytes()) for cast in frame.casts)
        with self.lock:
            if key not in self.layouts:
                self.epoch += 1
                self.layouts[key] = Layout(self.epoch, self.describe(frame, stage))
                if len(self.layouts) > MOST_LAYOUTS:
                    self.layouts.popitem(last=False)
            return self.layouts[key]

    def describe(self, frame: Frame, stage: Stage) -> tuple[dict[str, Any], ...]:
        """The hello's casts."""

        def name(actor: int) -> str:
            return stage.actor(actor).name

        return tuple(messages.describe_cast(cast, self.library.character_of(cast.role), name) for cast in frame.casts)

    def now_shown(self, kind: FrameKind) -> Shown:
        """The frame at the playhead."""
        with self.turn() as stage:
            return self.encode(stage.frame, kind, stage)

    def copy(self) -> Stage:
        """A copy of the stage with all its past, for one who wants to look around in it."""
        with self.turn() as stage:
            return stage.fork()

    def status(self) -> dict[str, Any]:
        """Where the stage is."""
        stage = self.stage
        return {
            "tick": stage.tick,
            "head": stage.head,
            "first": stage.first,
            "paused": self.clock.paused,
            "speed": self.clock.speed,
            "viewers": len(self.broadcast.mailboxes),
        }

    def announce(self) -> None:
        """Tells the viewers where the stage is."""
        self.broadcast.tell(messages.status(self.status()))

    # --- inputs

    def concerned(self, actor: int | None) -> Sequence[Actor]:
        """The actor of that number, or all.

        :raises Problem: 422, if there is none.
        """
        found = [one for one in self.stage.actors if actor is None or one.id == actor]
        if not found:
            raise Problem(422, "there is no such actor", field="actor", known=[str(one.id) for one in self.stage.actors])
        return found

    def post(self, new: NewEvent) -> int:
        """Logs an event for an actor, or for all that know it; its place in the log."""
        with self.turn() as stage:
            log = {"press": stage.send, "hold": stage.hold, "release": stage.release}[new.kind]
            for one in able(self.concerned(new.actor), "event", new.event, lambda actor: actor.role.machine.events):
                log(one, new.event)
            return len(stage.log)

    def set_parameter(self, new: NewParameter) -> int:
        """Logs a parameter's value for an actor, or for all that have it; its place in the log."""
        with self.turn() as stage:
            for one in able(self.concerned(new.actor), "parameter", new.parameter, parameter_names):
                stage.set(one, new.parameter, new.value)
            return len(stage.log)


def parameter_names(actor: Actor) -> list[str]:
    """The parameters of an actor's machine."""
    return [parameter.name for parameter in actor.role.machine.parameters]


def able(actors: Sequence[Actor], kind: str, name: str, names: Callable[[Actor], Sequence[str]]) -> list[Actor]:
    """The actors that know a name.

    :raises UnknownNameError: if none does; it lists what they know.
    """
    found = [actor for actor in actors if name in names(actor)]
    if not found:
        raise UnknownNameError(kind, name, sorted({known for actor in actors for known in names(actor)}))
    return found
