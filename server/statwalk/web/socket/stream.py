"""The WebSocket route: each connection is a viewer that gets frames and facts, and sends inputs."""

from __future__ import annotations

import asyncio
from contextlib import AbstractContextManager, nullcontext
from functools import partial
from weakref import WeakKeyDictionary

from anyio import CapacityLimiter, to_thread
from fastapi import APIRouter, WebSocket, WebSocketDisconnect
from starlette.types import Message as AsgiMessage

from statwalk.errors import StageError, StatwalkError, UnknownNameError
from statwalk.services.access.authenticator import Authenticator
from statwalk.services.cancel import CancelToken
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.publish.outbox import FRAME_KINDS, EncodedFrame, FrameForm, FrameKind, Outbox
from statwalk.skin.skinning import SKINNINGS, Skinning, skinning_of
from statwalk.web.dependencies import ENDING, grant_of
from statwalk.web.errors import Problem, answer, from_error
from statwalk.web.metrics import Metrics
from statwalk.web.rate_limits import RateLimits
from statwalk.web.request_log import note_limit
from statwalk.web.socket import messages
from statwalk.web.socket.inbox import Inbox

MOST_INPUT_THREADS = 2
"""threads that take inputs of the viewers of one stage at once"""
router = APIRouter()


@router.websocket("/api/stages/{stage_id}/stream")
async def stream(socket: WebSocket, stage_id: str, frames: str = "pose", skinning: str = "") -> None:
    """Streams the frames and facts of a stage; docs/api.md describes the messages."""
    registry: Registry = socket.app.state.registry
    try:
        kind, way = _frame_kind(frames), _skinning(skinning)
        host = registry.find(stage_id)
        _check_subprotocol(socket)
        outbox = Outbox(kind, way)
        host.join(outbox, grant=grant_of(socket))
    except (Problem, StatwalkError) as error:
        problem = error if isinstance(error, Problem) else from_error(error, socket.path_params)
        note_limit(socket.scope, problem.limit)
        await answer(problem.body())(socket.scope, socket.receive, socket.send)
        return
    try:
        await socket.accept(subprotocol=messages.VERSION if socket.scope["subprotocols"] else None)
        with _while_allowed(socket, outbox):
            await Viewer(socket, host, outbox).serve()
    finally:
        host.leave(outbox)


def _while_allowed(socket: WebSocket, outbox: Outbox) -> AbstractContextManager[None]:
    """Disconnects the viewer when its access ends."""
    authenticator: Authenticator | None = socket.app.state.authenticator
    return authenticator.watching(outbox, grant_of(socket)) if authenticator else nullcontext()


def _frame_kind(frames: str) -> FrameKind:
    """Returns the kind of frame.

    :raises Problem: 422, when it is neither `pose` nor `glb`.
    """
    for kind in FRAME_KINDS:
        if frames == kind:
            return kind
    raise Problem(422, f"no kind of frame is called {frames[:20]!r}", field="frames", known=FRAME_KINDS)


def _skinning(name: str) -> Skinning | None:
    """Returns the way of skinning; None if the viewer leaves it to each character.

    :raises Problem: 422, when there is no such way.
    """
    try:
        return skinning_of(name) if name else None
    except UnknownNameError as error:
        raise Problem(422, str(error), field="skinning", known=SKINNINGS) from None


def _check_subprotocol(socket: WebSocket) -> None:
    """Accepts a client that names no version of the stream.

    :raises Problem: 400, when it names only versions that the server does not have.
    """
    offered = socket.scope["subprotocols"]
    if offered and messages.VERSION not in offered:
        raise Problem(
            400,
            f"the server does not have this version of the stream; use {messages.VERSION}",
            field="Sec-WebSocket-Protocol",
            known=[messages.VERSION],
        )


class Viewer:
    """One connection: a reader, a writer, and a task that shows the past; the end of one ends all."""

    def __init__(self, socket: WebSocket, host: StageHost, outbox: Outbox) -> None:
        self.socket, self.host, self.outbox = socket, host, outbox
        self.token, ending = (CancelToken(socket.scope.get(ENDING)) for _ in range(2))
        rates: RateLimits = socket.app.state.rates
        client = rates.client_of(socket.scope)
        limiters: WeakKeyDictionary[StageHost, CapacityLimiter] = socket.app.state.input_limiters
        self.limiter = limiters.setdefault(host, CapacityLimiter(MOST_INPUT_THREADS))
        self.inbox = Inbox(
            host,
            outbox,
            self.token,
            ending,
            socket.app.state.past_limiter,
            grant=grant_of(socket),
            input_limiter=self.limiter,
            count_input=partial(rates.input, client, host.id),
            cut_off=partial(rates.cool, client),
        )
        self.metrics: Metrics = socket.app.state.metrics
        self.sent_layout: tuple[int, FrameForm] | None = None

    async def serve(self) -> None:
        """Serves until the viewer leaves or is disconnected, or the server stops."""
        try:
            first = ask.Frame(self.outbox.form.kind, None, self.outbox.form.skinning)
            self.outbox.put_frame(await to_thread.run_sync(self.host.handle, first, limiter=self.limiter))
        except StageError as error:
            self.outbox.cut("too large", str(error)[:100])
        tasks = [
            asyncio.ensure_future(coroutine)
            for coroutine in (self.read(), self._write_until_gone(), self.inbox.show_past())
        ]
        try:
            await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
        finally:
            self.token.cancel()
            for task in tasks:
                task.cancel()
            results = await asyncio.gather(*tasks, return_exceptions=True)
            if self.inbox.held:
                await to_thread.run_sync(self.inbox.release_held, limiter=self.limiter)
        for result in results:
            if isinstance(result, Exception) and not isinstance(result, OSError | WebSocketDisconnect):
                raise result

    async def read(self) -> None:
        """Handles the viewer's messages one after another, until it disconnects."""
        while True:
            message: AsgiMessage = await self.socket.receive()
            if message["type"] == "websocket.disconnect":
                return
            if self.outbox.closing is None:
                await self.inbox.take(message.get("text") or message.get("bytes") or b"")

    async def _write_until_gone(self) -> None:
        """Writes; if the connection breaks, cancels long work and waits for the reader to end the viewer.

        Messages that the viewer sent before it left may still be unread.
        """
        try:
            await self.write()
        except (OSError, WebSocketDisconnect):
            self.token.cancel()
            await asyncio.Event().wait()

    async def write(self) -> None:
        """Sends the content of the outbox, facts first and then the newest frame, until the
        outbox is closing.
        """
        outbox = self.outbox
        while outbox.closing is None:
            await outbox.filled.wait()
            outbox.filled.clear()
            frame = outbox.take_frame(self.host.home.now())
            if self.sent_layout is None:
                await self._send(frame, [])  # a viewer hears first what the frames are
                frame = None
            await self._send(frame, outbox.take_texts())
        ending, reason = outbox.closing
        note_limit(self.socket.scope, ending)
        await self.socket.close(messages.CLOSE_CODES[ending], reason)

    async def _send(self, frame: EncodedFrame | None, texts: list[bytes]) -> None:
        """Sends texts and a frame in one write, with a hello before the frame if the viewer does not have its
        layout.
        """
        if frame is None:
            if texts:
                await self.socket.send({"type": "websocket.send", "texts": texts})
            return
        form = FrameForm(frame.kind, frame.skinning)
        layout = frame.layout.epoch, form
        if self.sent_layout != layout:
            self.sent_layout = layout
            viewer = self.host.audience.of(self.outbox).id
            texts = [*texts, messages.hello(self.host, frame.layout, form, viewer)]
        await self.socket.send({"type": "websocket.send", "texts": texts, "bytes": frame.data})
        self.metrics.count_frame(self.host.audience.count, self.outbox.take_skipped())
