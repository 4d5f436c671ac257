"""From the thread that steps a stage to the event loop that serves its viewers.

The stepping thread leaves the newest frame and the facts here and rings once; the loop takes what is there. However late the loop is,
one frame of each kind waits.
"""

from __future__ import annotations

import asyncio
import threading
from collections.abc import Callable, Mapping, Sequence

from statwalk.web.problem import Problem
from statwalk.web.settings import MOST_VIEWERS
from statwalk.web.streaming.mailbox import FrameKind, Mailbox, Shown


class Broadcast:
    """A stage's viewers. `join`, `leave` and the mailboxes belong to the event loop; `publish` may be called from any thread."""

    def __init__(self) -> None:
        self.mailboxes: frozenset[Mailbox] = frozenset()
        self.lock = threading.Lock()
        self.loop: asyncio.AbstractEventLoop | None = None
        self.frames: dict[FrameKind, Shown] = {}
        self.facts: list[bytes] = []
        self.rung = False

    def join(self, mailbox: Mailbox) -> None:
        """A viewer more.

        :raises Problem: 503, if the stage has as many as it may have.
        """
        if len(self.mailboxes) >= MOST_VIEWERS:
            raise Problem(503, f"this stage has {MOST_VIEWERS} viewers, which is the most it may have")
        self.loop = asyncio.get_running_loop()
        self.mailboxes |= {mailbox}

    def leave(self, mailbox: Mailbox) -> None:
        """A viewer less."""
        self.mailboxes -= {mailbox}

    def kinds(self) -> set[FrameKind]:
        """The kinds of frame that somebody watches live."""
        return {mailbox.frames for mailbox in self.mailboxes if mailbox.live}

    def publish(self, frames: Mapping[FrameKind, Shown], facts: Sequence[bytes]) -> None:
        """Leaves the frames of a tick, in place of older ones, and its facts behind the older ones."""
        loop = self.loop
        if loop is None or not self.mailboxes:
            return
        with self.lock:
            self.frames.update(frames)
            self.facts.extend(facts)
            ring, self.rung = not self.rung, True
        if ring:
            loop.call_soon_threadsafe(self.deliver)

    def deliver(self) -> None:
        """Fills the mailboxes; in the event loop."""
        with self.lock:
            frames, self.frames = self.frames, {}
            facts, self.facts = self.facts, []
            self.rung = False
        for mailbox in self.mailboxes:
            if facts:
                mailbox.put_facts(facts)
            if mailbox.live and mailbox.frames in frames:
                mailbox.put_frame(frames[mailbox.frames])

    def tell(self, status: bytes) -> None:
        """Gives every viewer the status; from any thread."""
        self.each(lambda mailbox: mailbox.put_status(status))

    def cut_overdue(self, now: float) -> None:
        """Cuts off who leaves frames unacknowledged; in the event loop."""
        for mailbox in self.mailboxes:
            if mailbox.overdue(now):
                mailbox.cut(4008, "frames were not acknowledged for 5 s")

    def end(self, code: int, reason: str, kind: FrameKind | None = None) -> None:
        """Sends viewers away, all or those of one kind of frame; from any thread."""
        self.each(lambda mailbox: mailbox.cut(code, reason) if kind in (None, mailbox.frames) else None)

    def each(self, act: Callable[[Mailbox], None]) -> None:
        """Has the event loop do something with every mailbox."""
        for mailbox in self.mailboxes:
            if self.loop is not None:
                self.loop.call_soon_threadsafe(act, mailbox)
