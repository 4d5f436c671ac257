"""The one thread that writes to the database: what waits while a commit runs goes into the next commit.

After an error of the disk nothing counts as durable until the database is open again, its last commit is
verified, and everything that waits is written.
"""

from __future__ import annotations

import logging
import sqlite3
from collections import deque
from collections.abc import Callable, Sequence
from pathlib import Path

from statwalk.errors import StatwalkError, StorageError
from statwalk.services.hosting.store.committer import Committer, OpenDatabase, Statement, Write
from statwalk.services.hosting.store.database import opened
from statwalk.services.threads import Threads

__all__ = ["Statement", "Writer"]
RETRY_SECONDS = 0.5
MOST_WAITING = 64
"""writes, beyond which no more are made that can be made later"""
FULL_CODES = (sqlite3.SQLITE_FULL,)
log = logging.getLogger("statwalk.store")


def _nothing() -> None:
    pass


class Writer:
    """Writes statements in order; those of one `put` are in one commit. Thread-safe.

    `trouble`: why nothing can be written at the moment; None: all is well.
    """

    def __init__(
        self, path: Path, open_database: OpenDatabase = opened, threads: Threads | None = None
    ) -> None:
        """Opens the database and starts the thread.

        :raises ContentError: when the file is no database of statwalk.
        :raises StorageError: when the folder cannot be written.
        """
        threads = threads or Threads()
        self.path = path
        self.trouble: StorageError | None = None
        try:
            self._committer = Committer(path, open_database)
        except sqlite3.Error as error:
            raise _storage_error(error) from error
        self._newest = self._durable = self._committer.committed
        self._is_closing = False
        self._waiting: deque[Write] = deque()
        self._changed = threads.condition()
        self._thread = threads.start(self._run, "store")

    @property
    def commits(self) -> int:
        """The number of the newest `put` that is durable."""
        return self._durable

    @property
    def length(self) -> int:
        """The number of writes that wait."""
        return len(self._waiting)

    @property
    def is_behind(self) -> bool:
        """Whether the disk refuses, or is so slow that many writes wait."""
        return self.trouble is not None or self.length > MOST_WAITING

    def put(self, statements: Sequence[Statement], is_durable: Callable[[], None] = _nothing) -> int:
        """Hands statements over for one commit, and returns at once; `is_durable` is called in the writer's
        thread once they are on the disk. Returns the write's number.
        """
        with self._changed:
            self._newest += 1
            self._waiting.append(Write(self._newest, statements, is_durable))
            self._changed.notify_all()
            return self._newest

    def check(self) -> None:
        """:raises StorageError: while the disk refuses."""
        if self.trouble is not None:
            raise self.trouble

    def wait(self, is_done: Callable[[], bool], seconds: float) -> bool:
        """Waits until `is_done`, for at most `seconds` and not while the disk refuses; returns whether it is
        done.
        """
        if is_done() or seconds <= 0:
            return is_done()
        with self._changed:
            self._changed.wait_for(lambda: is_done() or self.trouble is not None, seconds)
        return is_done()

    def flush(self, seconds: float) -> None:
        """Waits until everything that was handed over is durable.

        :raises StorageError: when the disk refuses, or is not done after `seconds`.
        """
        newest = self._newest
        if not self.wait(lambda: self._durable >= newest, seconds):
            self.check()
            raise StorageError(f"the disk is not done after {seconds:g} seconds; try again later")

    def close(self) -> None:
        """Writes what waits, unless the disk refuses, and ends the thread; nothing is taken afterwards."""
        with self._changed:
            self._is_closing = True
            self._changed.notify_all()
        self._thread.join()
        with self._changed:
            self.trouble = StorageError("the server has stopped, and keeps nothing any more")
            self._changed.notify_all()

    # --- in the thread

    def _run(self) -> None:
        while batch := self._next_batch():
            try:
                self._committer.commit(batch)
            except (sqlite3.Error, StatwalkError) as error:
                self._report(error)
            else:
                self._is_committed(batch)
        self._committer.distrust()

    def _next_batch(self) -> list[Write]:
        """Returns what waits, as soon as something does; empty when the writer is to end."""
        with self._changed:
            if self.trouble is not None:
                self._changed.wait_for(lambda: self._is_closing, RETRY_SECONDS)
                if self._is_closing:
                    log.error("%d writes are lost: %s", len(self._waiting), self.trouble)
                    return []
            self._changed.wait_for(lambda: self._waiting or self._is_closing)
            return list(self._waiting)

    def _is_committed(self, batch: Sequence[Write]) -> None:
        if self.trouble is not None:
            log.warning("the disk takes writes again")
        for write in batch:
            write.is_durable()
        with self._changed:
            self._durable, self.trouble = batch[-1].ticket, None
            for _ in batch:
                self._waiting.popleft()
            self._changed.notify_all()

    def _report(self, error: sqlite3.Error | StatwalkError) -> None:
        if self.trouble is None:
            log.error("the disk refuses to write %s: %s", self.path, error)
        self._committer.distrust()
        with self._changed:
            self.trouble = _storage_error(error)
            self._changed.notify_all()


def _storage_error(error: sqlite3.Error | StatwalkError) -> StorageError:
    if isinstance(error, StorageError):
        return error
    if isinstance(error, StatwalkError):
        return StorageError(str(error))
    if getattr(error, "sqlite_errorcode", 0) in FULL_CODES:
        return StorageError(
            "the disk is full, and nothing can be kept; make room, and it goes on by itself", is_full=True
        )
    return StorageError(f"the disk refuses to write ({error}); nothing can be kept until it does")
