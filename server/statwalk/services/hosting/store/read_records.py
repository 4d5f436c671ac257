"""Reads what the store has kept, and finds what is damaged; the server that owns the folder may go on."""

from __future__ import annotations

import sqlite3
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from statwalk.errors import StorageError
from statwalk.services.hosting.store.database import DAMAGED, SEALED, STAGES
from statwalk.services.hosting.store.records import (
    KeptBeginning,
    KeptKey,
    KeptRole,
    MachineVersion,
    Note,
    Origin,
    StageIdentity,
    StageRecord,
    chained,
    machine_keys,
    row_digest,
)


class KeptRecords:
    """The database at `path`, for reading."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def ids(self) -> list[str]:
        """Returns the ids of the stages, in the order in which they were opened.

        :raises StorageError: when the database is damaged.
        """
        every = "SELECT id FROM stages ORDER BY rowid", "SELECT stage FROM ends"
        return list(dict.fromkeys(row[0] for sql in every for row in self._rows(sql)))

    def record(self, stage: str) -> StageRecord:
        """Returns a stage as it was kept.

        :raises StorageError: when the disk does not hold what was written.
        """
        identity, note = self._stage(stage)
        lines, chain = self._lines(stage)
        return StageRecord(
            identity,
            note,
            self._beginning(stage),
            dict(self._roles(stage)),
            lines,
            chain,
            dict(self._snapshots(stage)),
            dict(self._keys(stage)),
        )

    def _stage(self, stage: str) -> tuple[StageIdentity, Note]:
        columns = f"{SEALED[STAGES]}, digest"
        row = next(self._rows(f"SELECT {columns} FROM stages WHERE id = ?", stage), None)  # noqa: S608 - our own names
        if row is None:
            raise StorageError("the row that says what it is is missing")
        *values, digest = row
        if row_digest(*values) != digest:
            raise StorageError("the row that says what it is is damaged")
        _, opened, seed, rate, clock, tick, head, state, paused, speed, keep_running, *rest = values
        name, parent, forked_tick, forked_number, made = rest
        origin = Origin(parent, forked_tick, forked_number) if parent else None
        identity = StageIdentity(stage, opened, seed, rate, clock, bool(keep_running), made, origin)
        return identity, Note(tick, head, state, bool(paused), speed, name)

    def _beginning(self, stage: str) -> KeptBeginning | None:
        for tick, number, digest in self._rows(
            "SELECT tick, number, digest FROM beginnings WHERE stage = ?", stage
        ):
            if row_digest(stage, tick, number) != digest or tick not in dict(self._snapshots(stage)):
                raise StorageError("the state at which its log begins is damaged")
            return KeptBeginning(tick, number)
        return None

    def _keys(self, stage: str) -> Iterator[tuple[str, KeptKey]]:
        """The idempotency keys, the oldest first."""
        columns = "key, request, tick, seq, answered_by, digest"
        for key, *answer, digest in self._rows(
            f"SELECT {columns} FROM keys WHERE stage NOT IN (SELECT id FROM stages)"  # noqa: S608 - our own names
        ):
            if row_digest(stage, key, *answer) == digest:  # a flip gave the row another stage
                raise StorageError(f"the answer to the request with the key {key} is damaged")
        for key, *answer, digest in self._rows(
            f"SELECT {columns} FROM keys WHERE stage = ? ORDER BY tick, seq",  # noqa: S608 - our own names
            stage,
        ):
            if row_digest(stage, key, *answer) != digest:
                raise StorageError(f"the answer to the request with the key {key} is damaged")
            yield key, KeptKey(*answer)

    def edit_key(self, machine: str, key: str) -> KeptKey | None:
        """Returns what is kept of the answer to an edit with an idempotency key; None: nothing.

        :raises StorageError: when it is damaged.
        """
        owner = machine_keys(machine)
        columns = "request, tick, seq, answered_by, digest"
        for *answer, digest in self._rows(
            f"SELECT {columns} FROM keys WHERE stage = ? AND key = ?",  # noqa: S608 - our own names
            owner,
            key,
        ):
            if row_digest(owner, key, *answer) != digest:
                raise StorageError(f"the answer to the edit with the key {key} is damaged")
            return KeptKey(*answer)
        return None

    def _roles(self, stage: str) -> Iterator[tuple[str, KeptRole]]:
        for key, text, model, digest in self._rows(
            "SELECT role, text, model, digest FROM roles WHERE stage = ?", stage
        ):
            if row_digest(stage, key, text, model) != digest:
                raise StorageError(f"the text of {key} is damaged")
            yield key, KeptRole(text, model)

    def _lines(self, stage: str) -> tuple[tuple[str, ...], bytes]:
        lines, chain = [], b""
        for place, line, link in self._rows(
            "SELECT place, line, chain FROM commands WHERE stage = ? ORDER BY place", stage
        ):
            chain = chained(chain, line) if isinstance(line, str) else b""  # a flip may make it no text
            lines.append(line)
            if place != len(lines) or link != chain:
                raise StorageError(f"entry {place} of the log is damaged")
        end = next(self._rows("SELECT entries, chain, digest FROM ends WHERE stage = ?", stage), None)
        if end != (len(lines), chain, row_digest(stage, len(lines), chain)):
            raise StorageError(f"the log does not end with entry {len(lines)}, the last one that is there")
        return tuple(lines), chain

    def _snapshots(self, stage: str) -> Iterator[tuple[int, bytes]]:
        """The snapshots, without damaged ones: the log makes each of them again."""
        for tick, data, digest in self._rows(
            "SELECT tick, data, digest FROM snapshots WHERE stage = ? ORDER BY tick", stage
        ):
            if row_digest(stage, tick, data) == digest:
                yield tick, data

    def damaged_snapshots(self, stage: str) -> list[int]:
        """Returns the ticks of the snapshots whose bytes have changed.

        :raises StorageError: when the database is damaged.
        """
        rows = self._rows("SELECT tick, data, digest FROM snapshots WHERE stage = ? ORDER BY tick", stage)
        return [tick for tick, data, digest in rows if row_digest(stage, tick, data) != digest]

    def versions(self) -> dict[str, list[MachineVersion]]:
        """Returns the versions of all machines that were edited, oldest first, without damaged ones.

        :raises StorageError: when the database is damaged.
        """
        found: dict[str, list[MachineVersion]] = {}
        for machine, version, is_whole in self._versions():
            if is_whole:
                found.setdefault(machine, []).append(version)
        return found

    def damaged_versions(self) -> dict[str, list[int]]:
        """Returns the numbers of the versions whose rows have changed, by machine; 0: no number any more.

        :raises StorageError: when the database is damaged.
        """
        found: dict[str, list[int]] = {}
        for machine, version, is_whole in self._versions():
            if not is_whole:
                number: Any = version.number
                found.setdefault(str(machine), []).append(number if isinstance(number, int) else 0)
        return found

    def _versions(self) -> Iterator[tuple[str, MachineVersion, bool]]:
        """All versions, and whether each is as it was written."""
        for machine, *row, digest in self._rows("SELECT * FROM versions ORDER BY machine, number"):
            yield machine, MachineVersion(*row), row_digest(machine, *row) == digest

    @property
    def format(self) -> int:
        """The number of the database's format.

        :raises StorageError: when the file is no database.
        """
        return int(next(self._rows("PRAGMA user_version"))[0])

    def damage(self, table: str = "") -> list[str]:
        """Returns what SQLite itself finds wrong with the file, or with the pages of one table."""
        check = f"integrity_check({table})" if table else "integrity_check"
        try:
            return [text for (text,) in self._rows(f"PRAGMA {check}") if text != "ok"]
        except StorageError as error:
            return [str(error)]

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
        except UnicodeDecodeError as error:  # SQLite's message repeats what is damaged
            raise StorageError(f"{self.path}: {DAMAGED}") from error
        except sqlite3.Error as error:
            raise StorageError(f"the database {self.path} is damaged: {error}") from error
