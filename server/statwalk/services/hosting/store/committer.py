"""Commits batches of statements to the database, each batch once, whatever the disk does.

After an error nothing that is known of the file is trusted: the next commit opens it again, flushes all of
it, and reads which batch it holds.
"""

from __future__ import annotations

import sqlite3
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from statwalk.services.hosting.store.database import opened


class Statement(NamedTuple):
    """SQL and the rows that it runs with."""

    sql: str
    rows: Sequence[tuple[Any, ...]]


class Write(NamedTuple):
    """The statements of one commit; `ticket`: its number, one more than that of the write before it."""

    ticket: int
    statements: Sequence[Statement]
    is_durable: Callable[[], None]


OpenDatabase = Callable[[Path], sqlite3.Connection]


class Committer:
    """Writes to the database at `path`. One thread at a time may call it; it starts none, and never waits."""

    def __init__(self, path: Path, open_database: OpenDatabase = opened) -> None:
        """Opens the database.

        :raises ContentError: when the file is no database of statwalk.
        :raises sqlite3.Error: when the disk refuses.
        """
        self.path, self._open_database = path, open_database
        self._connection: sqlite3.Connection | None = open_database(path)
        self.committed = self._newest_in(self._connection)

    def commit(self, batch: Sequence[Write]) -> None:
        """Commits the writes of a batch that the file does not hold yet; they are durable afterwards.

        :raises ContentError: when the file is no database of statwalk any more.
        :raises sqlite3.Error: when the disk refuses; call `distrust` then.
        """
        connection = self._connection or self._verified()
        written = self._newest_in(connection)
        connection.execute("BEGIN IMMEDIATE")
        for write in batch:
            if write.ticket > written:
                for statement in write.statements:
                    connection.executemany(statement.sql, statement.rows)
        connection.execute("UPDATE commits SET ticket = ?", (batch[-1].ticket,))
        connection.execute("COMMIT")
        self.committed = batch[-1].ticket

    def distrust(self) -> None:
        """Closes the database, which rolls back; what is known of the file's state no longer counts."""
        if self._connection is not None:
            self._connection.close()
        self._connection = None

    def _verified(self) -> sqlite3.Connection:
        """Opens the database again after an error."""
        self._connection = connection = self._open_database(self.path)
        # a commit that failed may be in the file all the same: it counts once all of the file is flushed
        busy, *_ = connection.execute("PRAGMA wal_checkpoint(TRUNCATE)").fetchone()
        if busy:
            raise sqlite3.OperationalError("another program reads the database")
        return connection

    def _newest_in(self, connection: sqlite3.Connection) -> int:
        ticket: int = connection.execute("SELECT ticket FROM commits").fetchone()[0]
        return ticket
