"""A stage's log in memory whose commands also go to the database, each with the hash of all before it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from functools import partial

from statwalk.services.hosting.store.records import chained, sealed
from statwalk.services.hosting.store.writer import Statement, Writer
from statwalk.stage.history.log import Log
from statwalk.stage.history.log_codec import line_of
from statwalk.stage.state.commands import Command, LogEntry

INSERT = "INSERT INTO commands VALUES (?, ?, ?, ?)"
MOVE_END = "UPDATE ends SET entries = ?2, chain = ?3, digest = ?4 WHERE stage = ?1"
BEGIN_END = "INSERT INTO ends VALUES (?, ?, ?, ?)"


class KeptLog:
    """Follows the protocol `Log`. `place`: how many entries the database has; `chain`: their hash."""

    def __init__(self, log: Log, stage: str, writer: Writer, place: int = 0, chain: bytes = b"") -> None:
        self._log, self._stage, self._writer = log, stage, writer
        self._place, self._chain = place, chain
        self._durable = log.newest if place else 0
        self._gathered: list[Statement] | None = None

    def begun(self, entries: Iterable[LogEntry]) -> list[Statement]:
        """Returns the statements that write the first entries."""
        return self._written(entries, BEGIN_END)

    def _written(self, entries: Iterable[LogEntry], end: str = MOVE_END) -> list[Statement]:
        """The statements that write the next entries, and where the log ends: an entry that is gone is
        missed.
        """
        rows = []
        for entry in entries:
            line = line_of(entry)
            self._place, self._chain = self._place + 1, chained(self._chain, line)
            rows.append((self._stage, self._place, line, self._chain))
        ended = Statement(end, [sealed(self._stage, self._place, self._chain)])
        return [Statement(INSERT, rows), ended]

    def rewritten(self) -> list[Statement]:
        """Returns the statements that write all entries again, as a log of its own: the older ones were
        forgotten.
        """
        self._place, self._chain = 0, b""
        old = Statement("DELETE FROM commands WHERE stage = ?", [(self._stage,)])
        return [old, *self._written(self._log)]

    @contextmanager
    def gathered(self) -> Iterator[list[Statement]]:
        """Puts all that is appended meanwhile, and the statements that the caller adds to the list, into one
        commit. The caller holds the stage.
        """
        statements: list[Statement] = []
        self._gathered = statements
        try:
            yield statements
        finally:
            self._gathered = None
            if statements:
                self._put(statements)

    def written(self, number: int) -> None:
        """Counts the commands up to a number as durable."""
        self._durable = max(self._durable, number)

    def _put(self, statements: list[Statement]) -> None:
        self._writer.put(statements, partial(self.written, self._log.newest))

    # --- the protocol

    def append(self, tick: int, commands: Iterable[Command]) -> list[int]:
        """Appends commands after all other commands of their tick; returns their sequence numbers."""
        new = list(commands)
        numbers = self._log.append(tick, new)
        entries = [LogEntry(number, tick, command) for number, command in zip(numbers, new, strict=True)]
        statements = self._written(entries)
        if self._gathered is None:
            self._put(statements)
        else:
            self._gathered += statements
        return numbers

    @property
    def newest(self) -> int:
        """The sequence number of the newest command; 0 if the log is empty."""
        return self._log.newest

    @property
    def last(self) -> LogEntry | None:
        """The newest entry that came to this log itself."""
        return self._log.last

    @property
    def held(self) -> int:
        """The number of entries that the log holds, or more: what is shared with another log may count."""
        return self._log.held

    def durable(self, number: int, seconds: float = 0.0) -> bool:
        """Returns whether the command of this number, and all commands before it, are on the disk; waits for
        at most `seconds`, and not while the disk refuses.
        """
        return self._writer.wait(lambda: self._durable >= number, seconds)

    def at(self, tick: int) -> list[LogEntry]:
        """Returns the entries of a tick, in the order in which they came."""
        return self._log.at(tick)

    def until(self, tick: int, takes_waiting: bool = False) -> Log:
        """Returns a log in memory that shares the past: forks and copies are kept only if they are held."""
        return self._log.until(tick, takes_waiting)

    def forget(self, tick: int) -> None:
        """Drops the entries up to `tick` from memory; `rewritten` drops them from the disk."""
        self._log.forget(tick)

    def __iter__(self) -> Iterator[LogEntry]:
        """Yields all entries by tick, and in the order in which they came."""
        return iter(self._log)
