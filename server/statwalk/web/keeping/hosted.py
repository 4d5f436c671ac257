"""A stage that the server holds: one lock around it, its clock, its viewers. Every method may be called from any thread."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from statwalk.errors import UnknownNameError
from statwalk.stage.clock import Clock
from statwalk.stage.past.timeline import SLICE
from statwalk.stage.role import Role
from statwalk.stage.stage import Actor, Stage
from statwalk.web.keeping.catalogue import Catalogue
from statwalk.web.problem import Problem
from statwalk.web.schemas import Clock as ClockKind
from statwalk.web.schemas import NewEvent, NewParameter
from statwalk.web.streaming import messages
from statwalk.web.streaming.mailbox import FrameKind, Mailbox, Shown
from statwalk.web.streaming.screen import Screen

BUSY_SECONDS = 20.0
WAIT_FOR_CHANGE = 0.25


class HostedStage:
    """`id` names it in the API; `clock_kind` says whether time moves it or only `step`."""

    def __init__(self, stage_id: str, stage: Stage, clock_kind: ClockKind, catalogue: Catalogue) -> None:
        self.id, self.stage, self.clock_kind = stage_id, stage, clock_kind
        self.clock = Clock(stage.rate)
        self.lock = threading.RLock()
        self.screen = Screen(catalogue)
        self.broadcast = self.screen.broadcast
        self.logged = len(stage.log)
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
        self.screen.show(self.stage, facts=True)

    def step(self, ticks: int) -> None:
        """So many steps, each shown to the viewers; every now and then others have their turn."""
        for done in range(0, ticks, SLICE):
            with self.turn():
                for _ in range(min(SLICE, ticks - done)):
                    self.tick()
            time.sleep(0)  # who waits for the lock gets it

    def seek(self, tick: int) -> None:
        """Moves the playhead, for everybody; while the way there is worked out others have their turn."""
        with self.turn() as stage:
            slices = stage.seeking(tick)
        while self.goes_on(slices):
            time.sleep(0)

    def goes_on(self, slices: Iterator[int]) -> bool:
        """Whether a slice of the way to another tick was left; when none is, it is shown."""
        with self.turn() as stage:
            if next(slices, None) is not None:
                return True
            self.screen.show(stage, facts=False)
            self.announce()
            return False

    def pause(self, paused: bool) -> None:
        """Stops or starts the clock."""
        with self.turn():
            self.clock.due(time.perf_counter())  # what passed until now belongs to the clock as it was
            self.clock.paused = paused
            self.announce()

    def set_speed(self, speed: float) -> None:
        """Makes the clock run faster or slower."""
        with self.turn():
            self.clock.speed = speed
            self.announce()

    # --- frames

    def now_shown(self, kind: FrameKind) -> Shown:
        """The frame at the playhead."""
        with self.turn() as stage:
            return self.screen.encode(stage.frame, kind, stage, stage.head)

    def copy(self) -> Stage:
        """A copy of the stage with all its past, for one who wants to look around in it."""
        with self.turn() as stage:
            return stage.copy()

    def leave(self, mailbox: Mailbox) -> None:
        """A viewer less; until now the stage was in use."""
        self.broadcast.leave(mailbox)
        self.touched = time.monotonic()

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

    def add(self, role: Role, position: Sequence[float], heading: float, name: str | None) -> Actor:
        """An actor more; the viewers see it at once."""
        with self.turn() as stage:
            actor = stage.add(role, position, heading, name)
            self.logged += 1
            self.screen.show(stage, facts=False)
            return actor

    def edit(self, role: Role, text: str) -> None:
        """Another version of a machine; the viewers see it at once.

        :raises StageError: if the character has other joints.
        """
        with self.turn() as stage:
            stage.edit(role, text)
            self.logged += 1
            self.screen.show(stage, facts=False)

    def remove(self, actor: Actor) -> None:
        """An actor less."""
        with self.turn() as stage:
            stage.remove(actor)
            self.logged += 1
            self.screen.show(stage, facts=False)

    def concerned(self, actor: int | None) -> Sequence[Actor]:
        """The actor of that number, or all.

        :raises UnknownNameError: if there is none of that number.
        :raises Problem: 409, if there is none at all.
        """
        found = self.stage.actors if actor is None else [self.stage.actor(actor)]
        if not found:
            raise Problem(409, "the stage has no actors", field="actor")
        return found

    def post(self, new: NewEvent) -> int:
        """Logs an event for an actor, or for all that know it; its place in the log."""
        with self.turn() as stage:
            log = {"press": stage.send, "hold": stage.hold, "release": stage.release}[new.kind]
            for one in able(self.concerned(new.actor), "event", new.event, event_names):
                log(one, new.event)
                self.logged += 1
            return self.logged

    def set_parameter(self, new: NewParameter) -> int:
        """Logs a parameter's value for an actor, or for all that have it; its place in the log."""
        with self.turn() as stage:
            for one in able(self.concerned(new.actor), "parameter", new.parameter, parameter_names):
                stage.set(one, new.parameter, new.value)
                self.logged += 1
            return self.logged


def event_names(actor: Actor) -> Sequence[str]:
    """The events that an actor's machine can be sent; END is not one."""
    events: tuple[str, ...] = actor.role.machine.events
    return events[:-1]


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
