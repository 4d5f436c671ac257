"""A viewer in Python: reads the stream as docs/api.md says it, and acknowledges unless told not to."""

import json
from types import TracebackType
from typing import Any, Self

from serving import PATIENCE
from statwalk.services.publish.pose_message import PoseMessage, decode
from websockets.sync.client import connect

CLOSE_SECONDS = 1.0
"""for which websockets may wait for the end of a connection after its close frame, though it has come"""
MOST_MESSAGES = 2_000
FRAMES, TICKS, TRIES = 30, 33, 60
"""so many frames within so many ticks are the pace of the stage, if one of so many tries brings them"""


class Watcher:
    """`frames` and `facts` fill up as messages are received."""

    def __init__(
        self, address: str, stage: str, frames: str = "pose", acknowledge: bool = True, **options: Any
    ) -> None:
        self.opened = connect(
            f"ws://{address}{stage}/stream?frames={frames}",
            subprotocols=["statwalk.v1"],
            compression=None,
            max_size=None,
            open_timeout=PATIENCE,
            close_timeout=CLOSE_SECONDS,
            **options,
        )
        self.socket = self.opened.__enter__()
        self.acknowledge = acknowledge
        self.texts: list[dict[str, Any]] = []
        self.hello = self.text("hello")

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.opened.__exit__(kind, error, trace)

    def say(self, **message: Any) -> None:
        self.socket.send(json.dumps(message))

    def receive(self) -> dict[str, Any] | bytes:
        message = self.socket.recv(timeout=PATIENCE)
        if isinstance(message, bytes):
            return message
        self.texts.append(json.loads(message))
        return self.texts[-1]

    def text(self, kind: str) -> dict[str, Any]:
        """The next message of a kind; frames on the way are acknowledged."""
        for _ in range(MOST_MESSAGES):
            message = self.receive()
            if isinstance(message, bytes):
                self.acknowledged(message)
            elif message["type"] == kind:
                return message
        raise AssertionError(f"no {kind} among {MOST_MESSAGES} messages")

    def acknowledged(self, data: bytes) -> None:
        if self.acknowledge:
            self.say(type="ack", tick=decode(data).tick if data[:4] == b"STW1" else glb_tick(data))

    def data(self) -> bytes:
        """The next frame's bytes."""
        for _ in range(MOST_MESSAGES):
            message = self.receive()
            if isinstance(message, bytes):
                self.acknowledged(message)
                return message
        raise AssertionError(f"no frame among {MOST_MESSAGES} messages")

    def frame(self) -> PoseMessage:
        """The next frame."""
        return decode(self.data())

    def frame_at(self, tick: int) -> PoseMessage:
        """The next frame of a tick, which must come: no tick of a stage that is stepped is skipped."""
        while (frame := self.frame()).tick != tick:
            pass
        return frame

    def frame_from(self, tick: int) -> PoseMessage:
        """The next frame of a tick, or of a later one: a busy machine skips frames in real time."""
        while (frame := self.frame()).tick < tick:
            pass
        return frame

    def keeps_up(self) -> bool:
        """Whether frames come at the pace of the stage. A busy machine leaves frames out now and then, a
        server that holds them back does so in each try.
        """
        return any(self._ticks_of(FRAMES) <= TICKS for _ in range(TRIES))

    def _ticks_of(self, frames: int) -> int:
        """How many ticks go by while so many frames come, each newer than the one before."""
        ticks = [self.frame().tick for _ in range(frames + 1)]
        assert ticks == sorted(set(ticks))
        return ticks[-1] - ticks[0]


def glb_tick(data: bytes) -> int:
    """The tick that a posed GLB says it shows."""
    document = json.loads(data[20 : 20 + int.from_bytes(data[12:16], "little")])
    return int(document["asset"]["extras"]["tick"])
