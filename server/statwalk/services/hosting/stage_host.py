"""Holds one stage behind messages: a lock around it, long work in slices, forks.

Only the host touches the stage. Messages and replies are plain data, so that a host may live in another
process.
"""

from __future__ import annotations

import secrets
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, Protocol

from statwalk.character.role import Role
from statwalk.errors import CancelledError, LimitError
from statwalk.services.cancel import NEVER, CancelToken
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import AddActor, ClockKind
from statwalk.services.hosting.live_stage import LiveStage, StageServices
from statwalk.services.hosting.past_stages import PastStages
from statwalk.services.hosting.stage_lock import StageLock
from statwalk.services.hosting.stage_queries import AT_PLAYHEAD, LOOK_SECONDS, ON_A_COPY, finished
from statwalk.services.hosting.stage_replies import Posted, StageStatus
from statwalk.services.publish.outbox import EncodedFrame, Outbox
from statwalk.stage.stage import Stage


class Home(StageServices, Protocol):
    """The server that a host belongs to."""

    wake: Callable[[], None]
    """has the ticker look at the clocks now"""

    def hold(self, host: StageHost) -> StageHost:
        """Adds the host of a new stage, and returns it."""
        ...


class StageHost:
    """Answers messages about one stage. Thread-safe.

    `is_unclaimed`: an input at a past tick made this fork, and no request has named the fork yet.
    """

    is_unclaimed = False

    def __init__(self, stage_id: str, stage: Stage, clock_kind: ClockKind, home: Home) -> None:
        self.id, self.clock_kind, self.rate, self.home = stage_id, clock_kind, stage.rate, home
        self._live = LiveStage(stage_id, stage, clock_kind, home)
        self._lock = StageLock()
        self._closed = threading.Event()
        self._past = PastStages(self._copy)

    def handle(self, message: ask.Message[ask.Reply], token: CancelToken = NEVER) -> ask.Reply:
        """Does what a message asks, and returns the reply.

        Long work holds the lock for 5 ms at a time, so that other threads get their turn in between.

        :raises UnknownNameError: when a name in the message does not exist.
        :raises StageError: when the stage cannot do it.
        :raises ConflictError: when the stage as it is now does not allow it.
        :raises BusyError: when another thread holds the stage for 20 s.
        :raises CancelledError: when the token is cancelled, or the stage is closed, before the work is done.
        """
        kind = type(message)
        answer: Any
        if query := AT_PLAYHEAD.get(kind):
            with self._locked() as live:
                rest = query(live, message)
                next(rest)
            answer = finished(rest, token.check)
        elif on_a_copy := ON_A_COPY.get(kind):
            copy = self._copy()
            copy.before_tick = token.check
            answer = on_a_copy(copy, message)
        else:
            answer = _HANDLERS[kind](self, message, token)
        reply: ask.Reply = answer
        return reply

    def advance_to(self, now: float) -> float:
        """Takes the steps that are due at `now` (perf_counter seconds), and publishes the facts that waited
        for durability; returns the seconds until the next call.

        The ticker calls this. Does nothing while another thread holds the stage.
        """
        if not self._lock.lock.acquire(blocking=False):
            return 1 / self.rate
        try:
            return self._live.advance_to(now)
        finally:
            self._lock.lock.release()

    def join(self, outbox: Outbox) -> None:
        """Adds a viewer, whose outbox gets the frames and facts from now on. Call it in the event loop.

        :raises BusyError: when the stage has the most viewers that it may have.
        """
        self._live.fanout.join(outbox)

    def leave(self, outbox: Outbox) -> None:
        """Removes a viewer; the stage counts as idle from now on if it was the last one."""
        self._live.fanout.leave(outbox)
        if not self._live.fanout.outboxes:
            self._past.forget()
        self._lock.touched = time.monotonic()

    def look_after_viewers(self, now: float) -> None:
        """Disconnects viewers that leave frames unacknowledged, and sends the others the status; `now` on the
        monotonic clock. Call it in the event loop.
        """
        self._live.fanout.cut_overdue(now)
        self._live.announce()

    def idle_for(self, now: float) -> float:
        """Returns the seconds without a request or a viewer until `now`, on the monotonic clock."""
        return 0.0 if self._live.fanout.outboxes else now - self._lock.touched

    @contextmanager
    def _locked(self) -> Iterator[LiveStage]:
        """Yields the live stage while this thread holds the lock."""
        with self._lock.held():
            yield self._live

    def _copy(self) -> Stage:
        with self._locked() as live:
            return live.stage.copy()

    def _in_slices(self, work: Iterator[int], token: CancelToken) -> StageStatus:
        """Runs long work; what is done stays if the work is cancelled.

        :raises CancelledError: when the token is cancelled, or the stage is closed, before the work is done.
        """

        def check() -> None:
            token.check()
            if self._closed.is_set():
                raise CancelledError("the work is cancelled: the stage is closed")

        self._lock.in_slices(work, check)
        if self._live.facts_waiting:
            self.home.wake()
        return self._live.status()

    # --- one method for each message

    def _post(self, message: ask.Post, token: CancelToken) -> Posted:
        """Answers when the commands are durable: what was acknowledged survives a crash."""
        token.check()
        stage, posted = self._applied(message, token)
        while not stage.durable(posted.seq, LOOK_SECONDS):
            token.check()
        return posted

    def _applied(self, message: ask.Post, token: CancelToken) -> tuple[Stage, Posted]:
        machines = {command.machine for command in message.commands if isinstance(command, AddActor)}
        roles = {machine: _packed(self.home.catalogue.role(machine)) for machine in machines}
        with self._locked() as live:
            stage = live.stage
            tick = stage.tick if message.at is None else min(message.at, stage.head)
            if not message.forks or tick == stage.tick == stage.head:
                return stage, live.apply(message.commands, roles)
            if not message.may_fork:
                raise LimitError("too many forks at once; wait a few seconds, or continue in one of them")
            past = stage.copy()
        branch = self._branch(past, tick, token)  # may take long: without the lock, the stage keeps running
        with branch._locked() as live:
            stage, posted = live.stage, live.apply(message.commands, roles)
        branch.is_unclaimed = True
        self.home.hold(branch)
        return stage, posted

    def _fork(self, message: ask.Fork, token: CancelToken) -> str:
        past = self._copy()
        tick = past.tick if message.tick is None else message.tick
        return self.home.hold(self._branch(past, tick, token)).id

    def _branch(self, past: Stage, tick: int, token: CancelToken) -> StageHost:
        """Returns the host of a fork of `past` at a tick; `past` is a copy that this method may change."""
        past.before_tick = token.check
        if tick != past.tick:
            past.seek(tick)
        branch = past.fork()
        branch.before_tick = NEVER.check
        return StageHost(secrets.token_hex(4), branch, self.clock_kind, self.home)

    def _edit(self, message: ask.Edit, _: CancelToken) -> bool:
        role = _packed(self.home.catalogue.version(message.machine, message.text))
        with self._locked() as live:
            return live.edit(role, message.text)

    def _step(self, message: ask.Step, token: CancelToken) -> StageStatus:
        return self._in_slices(self._live.stepping(message.ticks), token)

    def _step_to(self, message: ask.StepTo, token: CancelToken) -> StageStatus:
        return self._in_slices(self._live.stepping_to(message.tick), token)

    def _seek(self, message: ask.Seek, token: CancelToken) -> StageStatus:
        return self._in_slices(self._live.seeking(message.tick), token)

    def _pause(self, message: ask.Pause, _: CancelToken) -> StageStatus:
        with self._locked() as live:
            live.pause(message.paused)
        self.home.wake()
        return self._live.status()

    def _set_speed(self, message: ask.SetSpeed, _: CancelToken) -> StageStatus:
        with self._locked() as live:
            live.set_speed(message.speed)
        self.home.wake()
        return self._live.status()

    def _frame(self, message: ask.Frame, token: CancelToken) -> EncodedFrame:
        if message.tick is None:
            with self._locked() as live:
                encode = live.taken_frame(live.stage, message.kind)
        else:
            with self._past.at(message.tick, token) as past:
                encode = self._live.taken_frame(past, message.kind)
        return encode()

    def _status(self, _: ask.Status, __: CancelToken) -> StageStatus:
        return self._live.status()

    def _close(self, _: ask.Close, __: CancelToken) -> None:
        self._closed.set()
        self._live.fanout.end("deleted", "the stage was deleted")


def _packed(role: Role) -> Role:
    """Returns the role once the arrays that ticks read are made, without the lock of a stage."""
    role.packed  # noqa: B018 - kept in the role
    return role


_HANDLERS: dict[type[ask.Message[Any]], Callable[[StageHost, Any, CancelToken], Any]] = {
    ask.Post: StageHost._post,
    ask.Edit: StageHost._edit,
    ask.Step: StageHost._step,
    ask.StepTo: StageHost._step_to,
    ask.Seek: StageHost._seek,
    ask.Fork: StageHost._fork,
    ask.Pause: StageHost._pause,
    ask.SetSpeed: StageHost._set_speed,
    ask.Close: StageHost._close,
    ask.Status: StageHost._status,
    ask.Frame: StageHost._frame,
}
