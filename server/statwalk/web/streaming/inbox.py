"""What a viewer says: acknowledgements, inputs, and where in time it wants to look."""

from __future__ import annotations

import asyncio
import contextlib
import time

from anyio import to_thread
from pydantic import TypeAdapter, ValidationError

from statwalk.errors import StatwalkError
from statwalk.stage.stage import Stage
from statwalk.web import jsonbody
from statwalk.web.keeping.hosted import HostedStage
from statwalk.web.keeping.registry import Registry
from statwalk.web.problem import Problem, field_name, from_error
from statwalk.web.schemas import Accepted, Ack, ChooseFrames, Live, Look, Message, NewEvent, Ping, PostEvent, PostParameter
from statwalk.web.streaming import messages
from statwalk.web.streaming.mailbox import Mailbox, Shown

INPUTS_PER_SECOND = 120.0
INPUT_BURST = 240.0
TOO_MANY = 4029
MESSAGES: TypeAdapter[Message] = TypeAdapter(Message)


class Allowance:
    """A token bucket: so many inputs a second, with a reserve."""

    def __init__(self) -> None:
        self.left, self.at = INPUT_BURST, time.monotonic()

    def spend(self) -> bool:
        """Takes one; False where none is left."""
        now = time.monotonic()
        self.left = min(INPUT_BURST, self.left + (now - self.at) * INPUTS_PER_SECOND)
        self.at = now
        self.left -= 1
        return self.left >= 0


class Inbox:
    """Takes one viewer's messages. Acknowledgements are free; inputs have an allowance, and who exceeds it is cut off with 4029."""

    def __init__(self, hosted: HostedStage, mailbox: Mailbox, registry: Registry) -> None:
        self.hosted, self.mailbox, self.registry = hosted, mailbox, registry
        self.allowance = Allowance()
        self.past: Stage | None = None
        self.looked_at: int | None = None
        self.asked = asyncio.Event()
        self.held: set[tuple[str, int | None]] = set()

    async def take(self, data: str | bytes) -> None:
        """One message; what is wrong with it is answered, not raised."""
        ref: object = None
        try:
            raw = jsonbody.parse(data)
            ref = raw.get("ref") if isinstance(raw, dict) else None
            await self.act(read(raw))
        except Problem as problem:
            self.say("error", ref=ref, **problem.body())
        except StatwalkError as error:
            self.say("error", ref=ref, **from_error(error).body())

    def say(self, kind: str, **members: object) -> None:
        """Answers this viewer alone."""
        self.mailbox.put_facts([messages.reply(kind, **members)])

    async def act(self, message: Message) -> None:
        """Does what a message asks."""
        if isinstance(message, Ack):
            self.mailbox.acknowledge(message.tick)
            return
        if not self.allowance.spend():
            self.mailbox.cut(TOO_MANY, f"more than {INPUTS_PER_SECOND:g} messages a second")
            return
        match message:
            case Ping(ref=ref):
                self.say("pong", ref=ref, tick=self.hosted.stage.tick)
            case PostEvent(ref=ref):
                at = self.looked_at if message.tick is None else message.tick
                self.accepted(ref, await to_thread.run_sync(self.registry.post, self.hosted, message, at))
                self.remember(message)
            case PostParameter(ref=ref):
                self.accepted(ref, await to_thread.run_sync(self.registry.set_parameter, self.hosted, message, self.looked_at))
            case Look(tick=tick):
                self.look(tick)
            case Live() | ChooseFrames():
                await self.choose(message)

    def remember(self, event: PostEvent) -> None:
        """Keeps track of what this viewer holds down."""
        key = (event.event, event.actor)
        if event.kind == "hold":
            self.held.add(key)
        elif event.kind == "release":
            self.held.discard(key)

    def let_go(self) -> None:
        """Releases what a viewer still held when it left: a lost line must not leave an actor walking for ever."""
        for event, actor in self.held:
            with contextlib.suppress(StatwalkError, Problem):
                self.hosted.post(NewEvent(event=event, actor=actor, kind="release"))

    def accepted(self, ref: object, accepted: Accepted) -> None:
        """Says where an input went, and that the stage forked if it did."""
        self.say("accepted", ref=ref, **accepted.model_dump())
        if accepted.stage != self.hosted.id:
            self.say("forked", stage=accepted.stage)

    async def choose(self, message: Live | ChooseFrames) -> None:
        """Back to the present, or another kind of frame; either way the viewer gets a frame at once."""
        mailbox = self.mailbox
        frames = message.frames if isinstance(message, ChooseFrames) else mailbox.frames
        shown = await to_thread.run_sync(self.hosted.now_shown, frames)
        mailbox.frames, mailbox.frame = frames, None
        if isinstance(message, Live):
            mailbox.live, self.looked_at, self.past = True, None, None
        if mailbox.live:
            mailbox.put_frame(shown)
        else:
            self.asked.set()

    # --- the past, for this viewer alone

    def look(self, tick: int) -> None:
        """Remembers the newest wish; `show_past` fulfils it.

        :raises Problem: 422, if the stage has no such tick.
        """
        status = self.hosted.status()
        first, head = status["first"], status["head"]
        if not first <= tick <= head:
            raise Problem(422, f"the stage has the ticks {first} to {head}", field="tick")
        self.mailbox.live, self.looked_at = False, tick
        self.asked.set()

    async def show_past(self) -> None:
        """Shows the tick that was asked for last, again and again."""
        while True:
            await self.asked.wait()
            self.asked.clear()
            if self.looked_at is not None:
                await self.show_tick(self.looked_at)

    async def show_tick(self, tick: int) -> None:
        """One frame of the past, unless the viewer went back to the present meanwhile."""
        try:
            shown = await to_thread.run_sync(self.frame_of, tick)
        except (Problem, StatwalkError) as error:
            problem = error if isinstance(error, Problem) else from_error(error)
            self.say("error", ref=None, **problem.body())
            return
        if not self.mailbox.live:
            self.mailbox.put_frame(shown)

    def frame_of(self, tick: int) -> Shown:
        """The frame of a tick, from a copy of the stage that only this viewer has."""
        past = self.past
        if past is None or tick > past.head:
            past = self.past = self.hosted.copy()
        past.seek(tick)
        return self.hosted.screen.encode(past.frame, self.mailbox.frames, past, self.hosted.stage.head)


def read(raw: object) -> Message:
    """The message that a JSON value is.

    :raises Problem: 422, naming the field, if it is none.
    """
    try:
        return MESSAGES.validate_python(raw)
    except ValidationError as error:
        found = error.errors()[0]
        raise Problem(422, found["msg"], field=field_name(("message", *found["loc"]))) from None
