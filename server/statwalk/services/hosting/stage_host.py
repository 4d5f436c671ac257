"""Holds one stage behind messages: a lock around it, long work in slices, forks.

Only the host touches the stage. Messages are plain data, so that a host may live in another process.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager as Context
from contextlib import contextmanager, nullcontext
from typing import Any, Protocol

from statwalk.errors import CancelledError, LimitError
from statwalk.services.access.roles import EVERYTHING, Grant
from statwalk.services.cancel import LOOK_SECONDS, NEVER, CancelToken
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.apply_commands import packed, roles_to_add
from statwalk.services.hosting.attention import Attention
from statwalk.services.hosting.audience import Audience
from statwalk.services.hosting.live_stage import LiveStage
from statwalk.services.hosting.long_queries import answer_on_a_copy
from statwalk.services.hosting.past_stages import PastStages, branch_at
from statwalk.services.hosting.stage_lock import RETRY_SECONDS, StageLock
from statwalk.services.hosting.stage_moves import AT_ONCE, IN_SLICES
from statwalk.services.hosting.stage_queries import AT_PLAYHEAD, ON_A_COPY, finished
from statwalk.services.hosting.stage_replies import Posted, StageStatus
from statwalk.services.hosting.stage_services import StageServices
from statwalk.services.hosting.store.committer import Statement
from statwalk.services.hosting.store.kept_stage import KeptStage
from statwalk.services.hosting.store.records import StageIdentity
from statwalk.services.publish.fanout import Loop
from statwalk.services.publish.outbox import EncodedFrame, Outbox
from statwalk.stage.stage import Stage


class Home(StageServices, Protocol):
    """The server that a host belongs to."""

    def hold(self, host: StageHost, also: Sequence[Statement] = ()) -> StageHost:
        """Adds the host of a new stage, keeps it and `also` in one commit, and returns it."""


class StageHost:
    """Answers messages about one stage. Thread-safe.

    `is_unclaimed`: an input at a past tick made this fork, and no request has named it yet; its clock stands.
    """

    is_unclaimed = False

    def __init__(self, identity: StageIdentity, stage: Stage, home: Home, name: str = "") -> None:
        self.identity, self.home = identity, home
        self.id, self.clock_kind, self.rate = identity.id, identity.clock, stage.rate
        self._live = LiveStage(identity, stage, home, name)
        self._lock, self._attention = StageLock(home.now), Attention(identity, self._live)
        self.audience = Audience(self._live.fanout, home.encode_fact, home.now, home.limits.viewers)
        self.idle_for = self._attention.idle_for
        self._closed = threading.Event()
        self._past = PastStages(self._copy)

    def handle(self, message: ask.Message[ask.Reply], token: CancelToken = NEVER) -> ask.Reply:
        """Does what a message asks, and returns the reply; wakes the stage.

        Long work holds the lock for 5 ms at a time, so that other threads get their turn in between.

        :raises UnknownNameError: when a name in the message does not exist.
        :raises StageError: when the stage cannot do it.
        :raises ConflictError: when the stage as it is now does not allow it.
        :raises BusyError: when another thread holds the stage for 20 s.
        :raises CancelledError: when the token is cancelled, or the stage is closed, before the work is done.
        :raises StorageError: when the disk refuses to keep the change that the message makes.
        """
        self._attention.touch()
        return self.look(message, token)

    def look(self, message: ask.Message[ask.Reply], token: CancelToken = NEVER) -> ask.Reply:
        """Does what `handle` does, and lets a stage sleep: for what the server asks of all stages."""
        kind = type(message)
        answer: Any
        if query := AT_PLAYHEAD.get(kind):
            with self._locked() as live:
                rest = query(live, message)
                next(rest)
            answer = finished(rest, token.check)
        elif kind in ON_A_COPY:
            answer = answer_on_a_copy(self._copy(), message, self.home, token)
        elif kind in IN_SLICES or kind in AT_ONCE:
            answer = self._moved(message, token)
        else:
            answer = _HANDLERS[kind](self, message, token)
        reply: ask.Reply = answer
        return reply

    def advance_to(self, now: float) -> float:
        """Takes the steps that are due at `now` (seconds of `home.now`), and publishes the facts that waited
        for durability, unless another thread holds the stage or it sleeps; returns the seconds until the next
        call.
        """
        if self._attention.sleeps(now) or self.is_unclaimed:
            return 1.0  # the first request has the ticker look again
        with self._lock.tried() as is_held:
            return self._live.advance_to(now) if is_held else RETRY_SECONDS

    def keep(self, kept: KeptStage, also: Sequence[Statement] = ()) -> None:
        """Keeps the stage from now on; `also` goes into the same commit."""
        with self._locked() as live:
            live.keep(kept, also)

    def resume(self, kept: KeptStage, *, paused: bool, speed: float) -> None:
        """Goes on with a stage that was kept."""
        with self._locked() as live:
            live.resume(kept, paused=paused, speed=speed)
        self._attention.come_back()

    def save(self) -> None:
        """Keeps the playhead, the clock and new snapshots, if they changed."""
        with self._locked() as live:
            live.save()

    def join(self, outbox: Outbox, loop: Loop | None = None, grant: Grant = EVERYTHING) -> None:
        """Adds a viewer in the event loop; :raises BusyError: when the stage has the most viewers it may."""
        self.audience.join(outbox, grant, loop)
        self._attention.touch()

    def leave(self, outbox: Outbox) -> None:
        """Removes a viewer; the stage counts as idle from now on if it was the last one."""
        self.audience.leave(outbox)
        if not self._live.fanout.outboxes:
            self._past.forget()
        self._attention.touch()

    def look_after_viewers(self, now: float) -> None:
        """Tells viewers the status and of each other, in the event loop; disconnects the slow ones."""
        self._live.fanout.cut_overdue(now)
        self._live.announce()
        self.audience.tell()

    @property
    def actors(self) -> int:
        """The number of actors."""
        return len(self._live.stage.state.ids)

    @contextmanager
    def _locked(self) -> Iterator[LiveStage]:
        """Yields the live stage while this thread holds the lock."""
        with self._lock.held():
            yield self._live

    def _copy(self) -> Stage:
        with self._locked() as live:
            return live.stage.copy()

    def _moved(self, message: ask.Message[Any], token: CancelToken) -> StageStatus:
        """Moves the stage through time or sets its clock, and answers when that is kept; what is done of long
        work stays if the work is cancelled.
        """

        def check() -> None:
            token.check()
            if self._closed.is_set():
                raise CancelledError("the work is cancelled: the stage is closed")

        self.home.check_storage()
        if in_slices := IN_SLICES.get(type(message)):
            self._lock.in_slices(in_slices(self._live, message), check)
        else:
            with self._locked() as live:
                AT_ONCE[type(message)](live, message)
        self.home.wake()
        self.save()
        self.home.flush()
        return self._live.status()

    # --- one method for each message
    def _post(self, message: ask.Post, token: CancelToken) -> Posted:
        """Answers when the commands are durable: what was acknowledged survives a crash."""
        token.check()
        self.home.check_storage()
        stage, posted = self._applied(message, token)
        if stage is None:  # the message came before
            self.home.flush()
        while stage and not stage.durable(posted.seq, LOOK_SECONDS):
            token.check()
            self.home.check_storage()
        return posted

    def _applied(self, message: ask.Post, token: CancelToken) -> tuple[Stage | None, Posted]:
        roles = roles_to_add(message.commands, self.home.catalogue.role)
        with self._locked() as live:
            stage = live.stage
            if live.keys and (earlier := live.keys.earlier(message)):
                return None, earlier
            tick = stage.tick if message.at is None else min(message.at, stage.head)
            if not message.forks or tick == stage.tick == stage.head:
                return stage, live.apply(message, roles)
            if not message.may_fork:
                raise LimitError("too many forks at once; wait a few seconds, or continue in one of them")
            past, keys = stage.copy(), live.keys
            under_way: Context[object] = keys.reserved(message) if keys else nullcontext()
        with under_way:  # may take long: without the lock, the stage keeps running
            branch = self._branch(past, tick, token)
            with branch._locked() as live:
                stage, posted = live.stage, live.apply(message, roles)
            branch.is_unclaimed = True
            kept: Context[list[Statement]] = keys.answering(message, posted) if keys else nullcontext([])
            with kept as answer:
                self.home.hold(branch, answer)
        return stage, posted

    def _fork(self, message: ask.Fork, token: CancelToken) -> str:
        self.home.check_storage()
        past = self._copy()
        tick = past.tick if message.tick is None else message.tick
        return self.home.hold(self._branch(past, tick, token, message.name)).id

    def _branch(self, past: Stage, tick: int, token: CancelToken, name: str = "") -> StageHost:
        branch = branch_at(past, tick, token)
        identity = self.identity.forked(self.home.new_id(), tick, branch.newest, time.time())
        return StageHost(identity, branch, self.home, name)

    def _edit(self, message: ask.Edit, _: CancelToken) -> bool:
        role = packed(self.home.catalogue.version(message.machine, message.text))
        with self._locked() as live:
            return live.edit(role, message.text)

    def _frame(self, message: ask.Frame, token: CancelToken) -> EncodedFrame:
        if message.tick is None:
            with self._locked() as live:
                encode = live.taken_frame(live.stage, message.form)
        else:
            with self._past.at(message.tick, token) as past:
                encode = self._live.taken_frame(past, message.form)
        return encode()

    def _close(self, _: ask.Close, __: CancelToken) -> None:
        self._closed.set()
        self._live.fanout.end("deleted", "the stage was deleted")


_HANDLERS: dict[type[ask.Message[Any]], Callable[[StageHost, Any, CancelToken], Any]] = {
    ask.Post: StageHost._post,
    ask.Edit: StageHost._edit,
    ask.Fork: StageHost._fork,
    ask.Close: StageHost._close,
    ask.Viewers: lambda host, *_: host.audience.present,
    ask.Status: lambda host, *_: host._live.status(),
    ask.Frame: StageHost._frame,
}
