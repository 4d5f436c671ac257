"""Holds what one viewer gets next: the newest frame, and all facts in order. Both are bounded.

A frame is state: a newer frame replaces an unsent one. Actions and verdicts are facts: the viewer gets each
once, in order. At most three frames are unacknowledged; a viewer that does not acknowledge a frame for five
seconds is disconnected. Use it in the event loop's thread only.
"""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, NamedTuple

from statwalk.services.publish.layout import FrameLayout
from statwalk.skin.skinning import Skinning

FrameKind = Literal["pose", "glb"]
FRAME_KINDS: tuple[FrameKind, ...] = ("pose", "glb")
CREDITS = 3
ACKNOWLEDGE_SECONDS = 5.0
MOST_FACTS = 16_384
Newest = Literal["status", "viewers", "camera"]
"""what is state as frames are: a newer text replaces an unsent one"""
Ending = Literal["slow", "too many messages", "too large", "deleted", "access ended"]
"""why a viewer is disconnected"""


class FrameForm(NamedTuple):
    """The kind of a viewer's frames, and for `glb` the way of skinning; None: each character's own."""

    kind: FrameKind
    skinning: Skinning | None = None


@dataclass(frozen=True)
class EncodedFrame:
    """An encoded frame; every viewer gets the same bytes."""

    tick: int
    kind: FrameKind
    layout: FrameLayout
    data: bytes
    skinning: Skinning | None = None
    """the way of skinning that a viewer of `glb` chose"""


class Outbox:
    """The queue of one viewer: the stage fills it, the viewer's writer empties it."""

    def __init__(self, frames: FrameKind, skinning: Skinning | None = None) -> None:
        self.form = FrameForm(frames, skinning)
        self.live = True
        self.frame: EncodedFrame | None = None
        self.newest: dict[Newest, bytes] = {}
        self.facts: deque[bytes] = deque()
        self.travelling: deque[tuple[int, float]] = deque()
        self.skipped = 0
        self.closing: tuple[Ending, str] | None = None
        self.filled = asyncio.Event()

    def put_frame(self, frame: EncodedFrame) -> None:
        """Replaces the pending frame."""
        self.skipped += self.frame is not None
        self.frame = frame
        self.filled.set()

    def take_skipped(self) -> int:
        """Returns how many pending frames were replaced since the last call."""
        skipped, self.skipped = self.skipped, 0
        return skipped

    def put_newest(self, kind: Newest, text: bytes) -> None:
        """Replaces the pending text of a kind."""
        self.newest[kind] = text
        self.filled.set()

    def put_facts(self, texts: Sequence[bytes]) -> None:
        """Appends facts; disconnects the viewer if more than `MOST_FACTS` are pending: no fact
        may be lost.
        """
        if len(self.facts) + len(texts) > MOST_FACTS:
            self.cut("slow", "too many messages are pending")
            return
        self.facts.extend(texts)
        self.filled.set()

    def cut(self, ending: Ending, reason: str) -> None:
        """Has the writer close the connection; the first reason counts."""
        self.closing = self.closing or (ending, reason)
        self.filled.set()

    def acknowledge(self, tick: int) -> bool:
        """Counts the frame of `tick`, and every frame sent before it, as acknowledged; returns False if no
        such frame is unacknowledged.
        """
        ticks = [sent for sent, _ in self.travelling]
        if tick not in ticks:
            return False
        for _ in range(ticks.index(tick) + 1):
            self.travelling.popleft()
        self.filled.set()
        return True

    def overdue(self, now: float) -> bool:
        """Returns whether the oldest unacknowledged frame is overdue; `now` in the clock of `take_frame`."""
        return bool(self.travelling) and now - self.travelling[0][1] > ACKNOWLEDGE_SECONDS

    def take_texts(self) -> list[bytes]:
        """Removes and returns the pending texts: all facts, then the newest of each kind."""
        texts = [*self.facts, *self.newest.values()]
        self.facts.clear()
        self.newest.clear()
        return texts

    def take_frame(self, now: float) -> EncodedFrame | None:
        """Removes and returns the pending frame, which counts as sent at `now`.

        Returns None without a pending frame, or if `CREDITS` frames are unacknowledged.
        """
        if self.frame is None or len(self.travelling) >= CREDITS:
            return None
        frame, self.frame = self.frame, None
        self.travelling.append((frame.tick, now))
        return frame
