"""The idempotency keys of one stage: a request that is sent again, for want of an answer, counts once."""

from __future__ import annotations

import hashlib
import threading
from collections.abc import Iterator
from contextlib import AbstractContextManager, ExitStack, contextmanager

from statwalk.errors import BusyError, ConflictError, StatwalkError
from statwalk.services.hosting.stage_messages import Post
from statwalk.services.hosting.stage_replies import Posted
from statwalk.services.hosting.store.records import KeptKey, sealed
from statwalk.services.hosting.store.writer import Statement, Writer

MOST_KEYS = 10_000
"""of one stage; the oldest are forgotten first"""
INSERT = "INSERT OR REPLACE INTO keys VALUES (?, ?, ?, ?, ?, ?, ?)"
DELETE = "DELETE FROM keys WHERE stage = ? AND key = ?"


class KeptKeys:
    """The `answers` by key. Thread-safe."""

    def __init__(self, stage: str, writer: Writer) -> None:
        self._stage, self._writer = stage, writer
        self.answers: dict[str, KeptKey] = {}
        self._under_way: set[str] = set()
        self._lock = threading.Lock()

    def earlier(self, post: Post) -> Posted | None:
        """Returns the answer that a message with the same key got before; None without a key.

        :raises ConflictError: when that was another message.
        :raises BusyError: when a message with this key is under way to a fork.
        """
        self._check_free(post)
        kept = self.answers.get(post.key)
        if kept is None:
            return None
        if kept.request != _request_digest(post):
            raise ConflictError(
                f"the idempotency key {post.key} belongs to another request; use a new key for a new request",
                field="Idempotency-Key",
            )
        return Posted(kept.tick, kept.seq, kept.stage, ())

    def reserved(self, post: Post) -> AbstractContextManager[object]:
        """Reserves the key of a message that goes to a fork now, until the end of the context; the caller
        holds the stage now.
        """
        reservation = ExitStack()
        if post.key:
            self._under_way.add(post.key)
            reservation.callback(self._under_way.discard, post.key)
        return reservation

    def _check_free(self, post: Post) -> None:
        if post.key in self._under_way:
            raise BusyError(f"a request with the key {post.key} is under way; wait for it, or try again")

    @contextmanager
    def answering(self, post: Post, posted: Posted) -> Iterator[list[Statement]]:
        """Remembers the answer to a message that goes to a fork; yields the statements that keep it, for the
        commit of the fork. Forgets it if the fork is not kept.
        """
        try:
            yield self.rows(post, posted.tick, posted.seq, posted.stage)
        except StatwalkError:
            with self._lock:
                self.answers.pop(post.key, None)
            self._writer.put([Statement(DELETE, [(self._stage, post.key)])])
            raise

    def rows(self, post: Post, tick: int, seq: int, stage: str) -> list[Statement]:
        """Remembers an answer; returns the statements that keep it, for the commit of the commands."""
        if not post.key:
            return []
        answer = KeptKey(_request_digest(post), tick, seq, stage)
        rows = [Statement(INSERT, [sealed(self._stage, post.key, *answer)])]
        with self._lock:
            self.answers[post.key] = answer
            if len(self.answers) > MOST_KEYS:
                oldest = next(iter(self.answers))
                del self.answers[oldest]
                rows.append(Statement(DELETE, [(self._stage, oldest)]))
        return rows


def _request_digest(post: Post) -> bytes:
    return hashlib.blake2b(repr((post.commands, post.at)).encode(), digest_size=16).digest()
