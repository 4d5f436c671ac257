"""Reads what the store has kept, and finds what is damaged; the server that owns the folder may go on."""

from __future__ import annotations

import sqlite3
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from statwalk.errors import StorageError
from statwalk.services.hosting.store.records import (
    KeptBeginning,
    KeptKey,
    KeptRole,
    MachineVersion,
    Note,
    StageIdentity,
    StageRecord,
    chained,
    row_digest,
    version_digest,
)


class KeptRecords:
    """The database at `path`, for reading."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def ids(self) -> list[str]:
        """Returns the ids of the stages, in the order in which they were opened.

        :raises StorageError: when the database is damaged.
        """
        return [row[0] for row in self._rows("SELECT id FROM stages ORDER BY rowid")]

    def record(self, stage: str) -> StageRecord:
        """Returns a stage as it was kept.

        :raises StorageError: when the disk does not hold what was written.
        """
        (_, opened, seed, rate, clock, tick, head, digest, paused, speed) = next(
            self._rows("SELECT * FROM stages WHERE id = ?", stage)
        )
        lines, chain = self._lines(stage)
        return StageRecord(
            StageIdentity(stage, opened, seed, rate, clock),
            Note(tick, head, digest, bool(paused), speed),
            self._beginning(stage),
            dict(self._roles(stage)),
            lines,
            chain,
            dict(self._snapshots(stage)),
            dict(self._keys(stage)),
        )

    def _beginning(self, stage: str) -> KeptBeginning | None:
        for tick, number, digest in self._rows(
            "SELECT tick, number, digest FROM beginnings WHERE stage = ?", stage
        ):
            beginning = KeptBeginning(tick, number)
            if row_digest(repr(beginning).encode()) != digest or tick not in dict(self._snapshots(stage)):
                raise StorageError("the state at which its log begins is damaged")
            return beginning
        return None

    def _keys(self, stage: str) -> Iterator[tuple[str, KeptKey]]:
        """The idempotency keys, the oldest first."""
        for key, *answer in self._rows(
            "SELECT key, request, tick, seq, answered_by FROM keys WHERE stage = ? ORDER BY tick, seq", stage
        ):
            yield key, KeptKey(*answer)

    def _roles(self, stage: str) -> Iterator[tuple[str, KeptRole]]:
        for key, text, model, digest in self._rows(
            "SELECT role, text, model, digest FROM roles WHERE stage = ?", stage
        ):
            if row_digest(text.encode(), model) != digest:
                raise StorageError(f"the text of {key} is damaged")
            yield key, KeptRole(text, model)

    def _lines(self, stage: str) -> tuple[tuple[str, ...], bytes]:
        lines, chain = [], b""
        for place, line, link in self._rows(
            "SELECT place, line, chain FROM commands WHERE stage = ? ORDER BY place", stage
        ):
            chain = chained(chain, line)
            lines.append(line)
            if place != len(lines) or link != chain:
                raise StorageError(f"entry {place} of the log is damaged")
        return tuple(lines), chain

    def _snapshots(self, stage: str) -> Iterator[tuple[int, bytes]]:
        """The snapshots, without damaged ones: the log makes each of them again."""
        for tick, data, digest in self._rows(
            "SELECT tick, data, digest FROM snapshots WHERE stage = ? ORDER BY tick", stage
        ):
            if row_digest(data) == digest:
                yield tick, data

    def damaged_snapshots(self, stage: str) -> list[int]:
        """Returns the ticks of the snapshots whose bytes have changed.

        :raises StorageError: when the database is damaged.
        """
        rows = self._rows("SELECT tick, data, digest FROM snapshots WHERE stage = ? ORDER BY tick", stage)
        return [tick for tick, data, digest in rows if row_digest(data) != digest]

    def versions(self) -> dict[str, list[MachineVersion]]:
        """Returns the versions of all machines that were edited, oldest first, without damaged ones.

        :raises StorageError: when the database is damaged.
        """
        found: dict[str, list[MachineVersion]] = {}
        for machine, number, at, what, text, before, digest in self._rows(
            "SELECT * FROM versions ORDER BY machine, number"
        ):
            version = MachineVersion(number, at, what, text, before)
            if version_digest(machine, version) == digest:
                found.setdefault(machine, []).append(version)
        return found

    def damage(self) -> list[str]:
        """Returns what SQLite itself finds wrong with the file.

        :raises StorageError: when the file is no database.
        """
        return [text for (text,) in self._rows("PRAGMA integrity_check") if text != "ok"]

    def copy(self, target: Path) -> None:
        """Writes a copy of the whole database as it is at one instant.

        :raises StorageError: when the database is damaged, or the copy cannot be written.
        """
        try:
            source, copy = self._reader(), sqlite3.connect(target)
            with source, copy:
                source.backup(copy)
            source.close()
            copy.close()
        except sqlite3.Error as error:
            raise StorageError(f"the database {self.path} cannot be copied: {error}") from error

    def _reader(self) -> sqlite3.Connection:
        return sqlite3.connect(f"{self.path.resolve().as_uri()}?mode=ro", uri=True)

    def _rows(self, sql: str, *values: str) -> Iterator[tuple[Any, ...]]:
        """The rows of a query, read by a connection of its own.

        :raises StorageError: when the database is damaged.
        """
        try:
            reader = self._reader()
            try:
                yield from reader.execute(sql, values).fetchall()
            finally:
                reader.close()
        except sqlite3.Error as error:
            raise StorageError(f"the database {self.path} is damaged: {error}") from error
