"""What is on its way to one viewer: the newest frame, and every fact in order. Bounded on both sides.

Frames are state: a newer one takes the place of one that was not sent yet. Actions and verdicts are facts: once each, in order.
At most three frames travel unacknowledged; who leaves one unacknowledged for five seconds is cut off with close code 4008.
Used from the event loop's thread only.
"""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

FrameKind = Literal["pose", "glb"]
FRAME_KINDS: tuple[FrameKind, ...] = ("pose", "glb")
CREDITS = 3
ACKNOWLEDGE_SECONDS = 5.0
MOST_FACTS = 16_384
SLOW = 4008


@dataclass(frozen=True)
class Layout:
    """Who is in a frame: `epoch` counts the layouts of a stage, `casts` is the hello's description of them."""

    epoch: int
    casts: tuple[dict[str, Any], ...]


@dataclass(frozen=True)
class Shown:
    """One encoded frame; the same bytes go to every viewer."""

    tick: int
    kind: FrameKind
    layout: Layout
    data: bytes


class Mailbox:
    """Filled by the stage, emptied by the viewer's writer."""

    def __init__(self, frames: FrameKind) -> None:
        self.frames: FrameKind = frames
        self.live = True
        self.frame: Shown | None = None
        self.status: bytes | None = None
        self.facts: deque[bytes] = deque()
        self.travelling: deque[tuple[int, float]] = deque()
        self.skipped = 0
        self.closing: tuple[int, str] | None = None
        self.filled = asyncio.Event()

    def put_frame(self, shown: Shown) -> None:
        """The newest frame wins."""
        self.skipped += self.frame is not None
        self.frame = shown
        self.filled.set()

    def put_status(self, text: bytes) -> None:
        """The newest status wins."""
        self.status = text
        self.filled.set()

    def put_facts(self, texts: Sequence[bytes]) -> None:
        """Facts queue up; a viewer that lets too many wait is cut off rather than told a part."""
        if len(self.facts) + len(texts) > MOST_FACTS:
            self.cut(SLOW, "too many messages wait")
            return
        self.facts.extend(texts)
        self.filled.set()

    def cut(self, code: int, reason: str) -> None:
        """Asks the writer to close the connection; the first reason counts."""
        self.closing = self.closing or (code, reason)
        self.filled.set()

    def acknowledge(self, tick: int) -> None:
        """The viewer has the frame of `tick`, and with it every one that was sent before."""
        ticks = [sent for sent, _ in self.travelling]
        if tick in ticks:
            for _ in range(ticks.index(tick) + 1):
                self.travelling.popleft()
            self.filled.set()

    def overdue(self, now: float) -> bool:
        """Whether the oldest frame on its way was not acknowledged in time; `now` in the seconds given to `take_frame`."""
        return bool(self.travelling) and now - self.travelling[0][1] > ACKNOWLEDGE_SECONDS

    def take_texts(self) -> list[bytes]:
        """All facts, then the status."""
        texts = list(self.facts)
        self.facts.clear()
        if self.status is not None:
            texts.append(self.status)
            self.status = None
        return texts

    def take_frame(self, now: float) -> Shown | None:
        """The newest frame, if there is one and a credit for it; it counts as sent at `now`."""
        if self.frame is None or len(self.travelling) >= CREDITS:
            return None
        shown, self.frame = self.frame, None
        self.travelling.append((shown.tick, now))
        return shown
