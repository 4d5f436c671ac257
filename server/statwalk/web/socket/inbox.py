"""Handles the messages of a viewer: acknowledgements, inputs, and the past tick that it wants to see."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Callable

from anyio import CapacityLimiter, to_thread

from statwalk.errors import StatwalkError
from statwalk.services.access.roles import EVERYTHING, Grant
from statwalk.services.cancel import CancelToken
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import SendEvent
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.hosting.stage_replies import Posted
from statwalk.services.publish.outbox import FrameForm, Outbox
from statwalk.web import bounded_json
from statwalk.web.errors import Problem, from_error
from statwalk.web.gate import check_role
from statwalk.web.schemas.base import Ref
from statwalk.web.schemas.viewer_messages import (
    Ack,
    ChooseFrames,
    Live,
    Look,
    Ping,
    PostEvent,
    PostParameter,
    PresenceMessage,
    ViewerMessage,
)
from statwalk.web.socket import messages
from statwalk.web.socket.presence_inbox import PresenceInbox
from statwalk.web.socket.read_message import read, ref_of
from statwalk.web.token_bucket import TokenBucket, cost_of

INPUTS_PER_SECOND = 120.0
INPUT_BURST = 240.0
IDLE_ACKS_PER_SECOND = 200.0
"""acknowledgements that match no frame; the others are at most as many as the frames"""
LONGEST_ACK = 64
"""bytes"""
MOST_VALUES = 64
"""in one message"""
SECONDS_PER_FORK = 5.0
MOST_FORKS = 4
"""forks in a row, before the viewer waits `SECONDS_PER_FORK` for each"""


class Inbox:
    """Handles the messages of one viewer.

    Acknowledging a frame is free. Every other message costs tokens, which are spent before the message is
    parsed; a viewer without tokens is disconnected with code 4029.

    `token`: cancelled when the viewer is gone, with it the past ticks that it wants to see; inputs for the
    present count though the viewer that sent them is gone, and end with the server (`ending`).
    `past_limiter`: limits the threads that compute past ticks for viewers; `input_limiter`: those that take
    inputs of the stage's viewers, so that what follows an input, such as an acknowledgement, waits for no
    request. `count_input` raises `Problem` if the address or the stage has too many inputs; `cut_off` is told
    that this viewer sends too many messages. `grant`: what the viewer may do.
    """

    def __init__(
        self,
        host: StageHost,
        outbox: Outbox,
        token: CancelToken,
        ending: CancelToken,
        past_limiter: CapacityLimiter,
        grant: Grant = EVERYTHING,
        input_limiter: CapacityLimiter | None = None,
        count_input: Callable[[], None] = lambda: None,
        cut_off: Callable[[], None] = lambda: None,
    ) -> None:
        self.grant = grant
        self.host, self.outbox, self.token, self.ending = host, outbox, token, ending
        self.input_limiter = input_limiter
        self.past_limiter, self.count_input, self.cut_off = past_limiter, count_input, cut_off
        self.inputs = TokenBucket(INPUTS_PER_SECOND, INPUT_BURST)
        self.acks = TokenBucket(IDLE_ACKS_PER_SECOND, IDLE_ACKS_PER_SECOND)
        self.forks = TokenBucket(1 / SECONDS_PER_FORK, MOST_FORKS)
        self.presence = PresenceInbox(host.audience, outbox)
        self.looked_at: int | None = None
        self.look_changed = asyncio.Event()
        self.held: set[tuple[str, int | None]] = set()

    async def take(self, data: str | bytes) -> None:
        """Handles one message; answers an error instead of raising it."""
        if not self._spend_for(data):
            self.outbox.cut("too many messages", f"more than {INPUTS_PER_SECOND:g} messages a second")
            self.cut_off()
            return
        ref: Ref = None
        try:
            raw = await bounded_json.parse_aside(data, MOST_VALUES)
            ref = ref_of(raw)
            await self.act(read(raw))
        except Problem as problem:
            self.answer(messages.error(ref, problem))
        except StatwalkError as error:
            self.answer(messages.error(ref, from_error(error)))

    def _spend_for(self, data: str | bytes) -> bool:
        return self.acks.spend() if _looks_like_ack(data) else self.inputs.spend(cost_of(data))

    def answer(self, text: bytes) -> None:
        """Sends a message to this viewer alone."""
        self.outbox.put_facts([text])

    async def act(self, message: ViewerMessage) -> None:
        """Does what a message asks.

        :raises Problem: 403, when the viewer may only look.
        """
        if isinstance(message, PostEvent | PostParameter):
            check_role(self.grant, "drive")
        match message:
            case Ack(tick=tick):
                if self.outbox.acknowledge(tick):
                    self.acks.give_back()
            case Ping(ref=ref):
                self.answer(messages.pong(ref, self.host.handle(ask.Status()).tick))
            case PostEvent(ref=ref):
                watched = self.looked_at if message.tick is None else message.tick
                await self.post(ref, message, None if message.now else watched)
                self.remember(message)
            case PostParameter(ref=ref):
                await self.post(ref, message, self.looked_at)
            case Look(tick=tick):
                self.look(tick)
            case PresenceMessage():
                self.presence.act(message)
            case Live() | ChooseFrames():
                await self.choose(message)

    async def post(self, ref: Ref, sent: PostEvent | PostParameter, at: int | None) -> None:
        """Posts an input at tick `at` (None: the playhead), and answers where it went."""
        self.count_input()
        may_fork = self.grant.stage is None and self.forks.has_one()
        message = ask.Post((sent.command(),), at, may_fork=may_fork, key=sent.key)
        token, limiter = (self.ending, self.input_limiter) if at is None else (self.token, self.past_limiter)
        posted = await to_thread.run_sync(self.host.handle, message, token, limiter=limiter)
        if posted.stage != self.host.id:
            self.forks.spend()
        self.accepted(ref, posted)

    def remember(self, event: PostEvent) -> None:
        """Keeps the set of events that this viewer holds."""
        key = (event.event, event.actor)
        if event.kind == "hold":
            self.held.add(key)
        elif event.kind == "release":
            self.held.discard(key)

    def release_held(self) -> None:
        """Releases the events that the viewer still holds: a lost connection must not leave an actor walking
        for ever.
        """
        for event, actor in self.held:
            with contextlib.suppress(StatwalkError):
                self.host.handle(ask.Post((SendEvent(event, actor, "release"),), forks=False))

    def accepted(self, ref: Ref, posted: Posted) -> None:
        """Answers where an input went; a second message names the fork, if the input made one."""
        self.answer(messages.accepted(ref, posted))
        if posted.stage != self.host.id:
            self.answer(messages.forked(posted.stage))

    async def choose(self, message: Live | ChooseFrames) -> None:
        """Returns the viewer to the present, or changes its kind of frame; the viewer gets a
        frame at once.
        """
        outbox = self.outbox
        form = outbox.form
        if isinstance(message, ChooseFrames):
            form = FrameForm(message.frames, message.skinning)
        newest = ask.Frame(form.kind, None, form.skinning)
        frame = await to_thread.run_sync(self.host.handle, newest, limiter=self.input_limiter)
        outbox.form, outbox.frame = form, None
        if isinstance(message, Live):
            outbox.live, self.looked_at = True, None
            self.host.audience.change(outbox, tick=None)
        if outbox.live:
            outbox.put_frame(frame)
        else:
            self.look_changed.set()

    # --- the past, for this viewer alone

    def look(self, tick: int) -> None:
        """Has `show_past` show a past tick to this viewer.

        :raises Problem: 422, when the stage does not have the tick.
        """
        status = self.host.handle(ask.Status())
        if not status.first <= tick <= status.head:
            raise Problem(
                422, f"the stage has the ticks {status.first} to {status.head}, not {tick}", field="tick"
            )
        self.outbox.live, self.looked_at = False, tick
        self.host.audience.change(self.outbox, tick=tick)
        self.look_changed.set()

    async def show_past(self) -> None:
        """Shows the past tick of the newest `look`, until the task is cancelled."""
        while True:
            await self.look_changed.wait()
            self.look_changed.clear()
            if self.looked_at is not None:
                await self._show_tick(self.looked_at)

    async def _show_tick(self, tick: int) -> None:
        """Shows one past frame, unless the viewer returned to the present meanwhile."""
        try:
            frame = await to_thread.run_sync(
                self.host.handle,
                ask.Frame(self.outbox.form.kind, tick, self.outbox.form.skinning),
                self.token,
                limiter=self.past_limiter,
            )
        except StatwalkError as error:
            self.answer(messages.error(None, from_error(error)))
            return
        if not self.outbox.live:
            self.outbox.put_frame(frame)


def _looks_like_ack(data: str | bytes) -> bool:
    return len(data) <= LONGEST_ACK and (b'"ack"' in data if isinstance(data, bytes) else '"ack"' in data)
