"""Carries frames and facts from the thread that steps a stage to the event loop that serves its viewers.

The stepping thread stores the newest frame and the facts, and wakes the loop once; the loop delivers them to
the outboxes. However late the loop is, only the newest frame of each form is pending.
"""

from __future__ import annotations

import asyncio
import threading
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Protocol

from statwalk.services.publish.outbox import EncodedFrame, Ending, FrameForm, Outbox


class Loop(Protocol):
    """The part of an event loop that carries calls from other threads into it."""

    def call_soon_threadsafe(self, callback: Callable[..., object], /, *arguments: Any) -> object:
        """Has the loop call a function soon."""


class Fanout:
    """The viewers of one stage, in the order in which they joined.

    Call `join`, `leave` and `cut_overdue` in the event loop; call the other methods in any thread.
    """

    def __init__(self) -> None:
        self.outboxes: tuple[Outbox, ...] = ()
        self.lock = threading.Lock()
        self.loop: Loop | None = None
        self.frames: dict[FrameForm, EncodedFrame] = {}
        self.facts: list[bytes] = []
        self.scheduled = False

    def join(self, outbox: Outbox, loop: Loop | None = None) -> None:
        """Adds a viewer that `loop` serves, by default the loop that runs."""
        self.loop = loop or asyncio.get_running_loop()
        self.outboxes = (*self.outboxes, outbox)

    def leave(self, outbox: Outbox) -> None:
        """Removes a viewer."""
        self.outboxes = tuple(each for each in self.outboxes if each is not outbox)

    def forms(self) -> set[FrameForm]:
        """Returns the forms of frame that the live viewers watch."""
        return {outbox.form for outbox in self.outboxes if outbox.live}

    def publish(self, frames: Mapping[FrameForm, EncodedFrame], facts: Sequence[bytes]) -> None:
        """Stores the frames of a tick, which replace older pending frames, and appends its facts."""
        loop = self.loop
        if loop is None or not self.outboxes:
            return
        with self.lock:
            self.frames.update(frames)
            self.facts.extend(facts)
            wake, self.scheduled = not self.scheduled, True
        if wake:
            loop.call_soon_threadsafe(self._deliver)

    def _deliver(self) -> None:
        """Moves the pending frames and facts to the outboxes; runs in the event loop."""
        with self.lock:
            frames, self.frames = self.frames, {}
            facts, self.facts = self.facts, []
            self.scheduled = False
        for outbox in self.outboxes:
            if facts:
                outbox.put_facts(facts)
            if outbox.live and outbox.form in frames:
                outbox.put_frame(frames[outbox.form])

    def tell(self, status: bytes) -> None:
        """Sends the status to every viewer."""
        self.each(lambda outbox: outbox.put_newest("status", status))

    def cut_overdue(self, now: float) -> None:
        """Disconnects the viewers that leave frames unacknowledged."""
        for outbox in self.outboxes:
            if outbox.overdue(now):
                outbox.cut("slow", "frames were not acknowledged for 5 s")

    def end(self, ending: Ending, reason: str, form: FrameForm | None = None) -> None:
        """Disconnects all viewers, or (`form`) the viewers of one form of frame."""
        self.each(lambda outbox: outbox.cut(ending, reason) if form in (None, outbox.form) else None)

    def each(self, act: Callable[[Outbox], None]) -> None:
        """Has the event loop call `act` with every outbox."""
        for outbox in self.outboxes:
            if self.loop is not None:
                self.loop.call_soon_threadsafe(act, outbox)
