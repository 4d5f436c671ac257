"""A disk below the real database: it is slow, full or broken, and loses what was never flushed."""

import sqlite3
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from simulated.process import Process
from simulated.world import World
from statwalk.services.hosting.store.database import FILE_NAME, opened

FULL, BROKEN = (sqlite3.SQLITE_FULL, "database or disk is full"), (sqlite3.SQLITE_IOERR, "disk I/O error")
QUICK_SECONDS = 0.0005, 0.02
"""of a commit"""


class Disk:
    """The data folder, which outlives the server's processes.

    `full_until`, `broken_until`, `slow_until`: until when commits fail, nothing works, commits take up to
    `slow_seconds`. `is_landing`: the next commit is written and fails all the same.
    """

    def __init__(self, world: World, folder: Path) -> None:
        self.world, self.folder, self.path = world, folder, folder / FILE_NAME
        self.chance = world.chance("disk")
        self.full_until = self.broken_until = self.slow_until = self.slow_seconds = 0.0
        self.is_landing = False
        self.process: Process | None = None
        self._open: list[Database] = []
        self._flushed: bytes | None = None
        """what a power cut leaves; None: all that was written"""

    def open(self, path: Path) -> Any:
        self.check(BROKEN, self.broken_until)
        assert self.process is not None
        database = Database(self, self.process, opened(path))
        self._open.append(database)
        return database

    def check(self, error: tuple[int, str], until: float) -> None:
        if self.world.time < until:
            raise refused(error)

    def killed(self, *, without_power: bool) -> None:
        """The process that had it open has ended."""
        for database in self._open:
            database.real.close()
        self._open.clear()
        if without_power and self._flushed is not None:
            for old in self.folder.glob(FILE_NAME + "*"):
                old.unlink()
            self.path.write_bytes(self._flushed)
            self.world.note("the power cut takes what was never flushed")
        self._flushed = None

    def landed(self, before: bytes) -> None:
        """A commit is written, not flushed."""
        if self._flushed is None:
            self._flushed = before

    def flushed(self) -> None:
        self._flushed = None

    def seconds(self) -> float:
        if self.world.time < self.slow_until:
            return self.chance.uniform(0.0, self.slow_seconds)
        return self.chance.uniform(*QUICK_SECONDS)


class Database:
    """A connection as `opened` gives it, with the faults of the disk. A commit takes its time."""

    def __init__(self, disk: Disk, process: Process, real: sqlite3.Connection) -> None:
        self.disk, self.process, self.real = disk, process, real

    def execute(self, sql: str, values: Any = ()) -> sqlite3.Cursor:
        self.disk.check(BROKEN, self.disk.broken_until)
        if sql == "COMMIT":
            return self._commit()
        cursor = self.real.execute(sql, values)
        if "wal_checkpoint" in sql:
            self.disk.flushed()
        return cursor

    def executemany(self, sql: str, rows: Iterable[Any]) -> sqlite3.Cursor:
        self.disk.check(BROKEN, self.disk.broken_until)
        self.disk.check(FULL, self.disk.full_until)
        return self.real.executemany(sql, rows)

    def close(self) -> None:
        if self in self.disk._open:
            self.disk._open.remove(self)
        self.real.close()

    def _commit(self) -> sqlite3.Cursor:
        seconds, is_late = self.disk.seconds(), self.disk.chance.random() < 0.5
        self.process.sleep(seconds if is_late else 0.0)
        self.disk.check(BROKEN, self.disk.broken_until)
        if self.disk.is_landing:
            self.disk.is_landing = False
            self.disk.landed(self._before())
            self.real.execute("COMMIT")
            self.disk.world.note("a commit is written, and fails")
            raise refused(BROKEN)
        cursor = self.real.execute("COMMIT")
        self.process.sleep(0.0 if is_late else seconds)
        return cursor

    def _before(self) -> bytes:
        """The file as it is without this transaction."""
        reader, copy = sqlite3.connect(self.disk.path), sqlite3.connect(":memory:")
        reader.backup(copy)
        image = copy.serialize()
        reader.close()
        copy.close()
        return image


def refused(error: tuple[int, str]) -> sqlite3.OperationalError:
    code, text = error
    refusal = sqlite3.OperationalError(text)
    refusal.sqlite_errorcode = code
    return refusal
