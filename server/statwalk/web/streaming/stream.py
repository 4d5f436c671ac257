"""The WebSocket of one viewer: frames and facts out, acknowledgements and inputs in."""

from __future__ import annotations

import asyncio
import time
from typing import Any

from anyio import to_thread
from fastapi import APIRouter, WebSocket, WebSocketDisconnect
from starlette.types import Message as AsgiMessage

from statwalk.errors import StageError
from statwalk.web.keeping.hosted import HostedStage
from statwalk.web.keeping.registry import Registry
from statwalk.web.problem import Problem, answer
from statwalk.web.streaming import messages
from statwalk.web.streaming.inbox import Inbox
from statwalk.web.streaming.mailbox import FRAME_KINDS, FrameKind, Mailbox
from statwalk.web.streaming.screen import REFUSED

router = APIRouter()


@router.websocket("/api/stages/{stage_id}/stream")
async def stream(socket: WebSocket, stage_id: str, frames: str = "pose") -> None:
    """Frames of a stage as they come; see docs/api.md for the messages."""
    registry: Registry = socket.app.state.registry
    try:
        kind = frame_kind(frames)
        hosted = registry.find(stage_id)
        check_subprotocol(socket)
        mailbox = Mailbox(kind)
        hosted.broadcast.join(mailbox)
    except Problem as problem:
        await answer(problem.body())(socket.scope, socket.receive, socket.send)
        return
    try:
        await socket.accept(subprotocol=messages.VERSION if socket.scope["subprotocols"] else None)
        await Viewer(socket, hosted, mailbox, registry).serve()
    finally:
        hosted.leave(mailbox)


def frame_kind(frames: str) -> FrameKind:
    """`pose` or `glb`.

    :raises Problem: 422, if it is neither.
    """
    for kind in FRAME_KINDS:
        if frames == kind:
            return kind
    raise Problem(422, f"there are no frames of kind {frames[:20]!r}", field="frames", known=FRAME_KINDS)


def check_subprotocol(socket: WebSocket) -> None:
    """A client that names versions must name ours.

    :raises Problem: 400, if it names others only.
    """
    offered = socket.scope["subprotocols"]
    if offered and messages.VERSION not in offered:
        raise Problem(400, "this server speaks another version of the stream", field="Sec-WebSocket-Protocol", known=[messages.VERSION])


class Viewer:
    """One connection: a reader, a writer, and whoever ends first ends both."""

    def __init__(self, socket: WebSocket, hosted: HostedStage, mailbox: Mailbox, registry: Registry) -> None:
        self.socket, self.hosted, self.mailbox = socket, hosted, mailbox
        self.inbox = Inbox(hosted, mailbox, registry)
        self.told: tuple[int, str] | None = None

    async def serve(self) -> None:
        """Until the viewer leaves, is cut off, or the server stops."""
        try:
            self.mailbox.put_frame(await to_thread.run_sync(self.hosted.now_shown, self.mailbox.frames))
        except StageError as error:
            self.mailbox.cut(REFUSED, str(error)[:100])
        tasks = [asyncio.ensure_future(part) for part in (self.read(), self.write_until_gone(), self.inbox.show_past())]
        try:
            await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
        finally:
            for task in tasks:
                task.cancel()
            ended = await asyncio.gather(*tasks, return_exceptions=True)
            if self.inbox.held:
                await to_thread.run_sync(self.inbox.let_go)
        for failure in ended:
            if isinstance(failure, Exception) and not isinstance(failure, OSError | WebSocketDisconnect):
                raise failure

    async def read(self) -> None:
        """What the viewer says, one message after the other."""
        while True:
            message: AsgiMessage = await self.socket.receive()
            if message["type"] == "websocket.disconnect":
                return
            await self.inbox.take(message.get("text") or message.get("bytes") or b"")

    async def write_until_gone(self) -> None:
        """A viewer that has gone may have said more before it went: the reader ends with that, not here."""
        try:
            await self.write()
        except (OSError, WebSocketDisconnect):
            await asyncio.Event().wait()

    async def write(self) -> None:
        """What the mailbox holds: facts first, then the newest frame."""
        mailbox = self.mailbox
        while mailbox.closing is None:
            await mailbox.filled.wait()
            mailbox.filled.clear()
            for text in mailbox.take_texts():
                await self.socket.send_text(text.decode())
            await self.write_frame()
        await self.socket.close(*mailbox.closing)

    async def write_frame(self) -> None:
        """The newest frame, after a hello if the viewer does not know its layout."""
        shown = self.mailbox.take_frame(time.monotonic())
        if shown is None:
            return
        told = (shown.layout.epoch, shown.kind)
        if self.told != told:
            self.told = told
            await self.socket.send_text(messages.hello(self.about(), shown.layout, shown.kind).decode())
        await self.socket.send_bytes(shown.data)

    def about(self) -> dict[str, Any]:
        """The stage, for the hello."""
        return {"stage": self.hosted.id, "rate": self.hosted.stage.rate, "clock": self.hosted.clock_kind, **self.hosted.status()}
