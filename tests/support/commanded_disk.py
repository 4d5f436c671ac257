"""A disk that is slow, or refuses, when a test says so; below the real database."""

import sqlite3
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any

from serving import PATIENCE
from stages import registry
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.store.database import opened
from statwalk.services.hosting.store.store import Store
from statwalk.services.hosting.store.writer import Writer
from statwalk.services.library.catalogue import Catalogue


class CommandedDisk:
    """Commits wait while `goes_on` is not set, and everything fails while it `refuses`."""

    def __init__(self, folder: Path, catalogue: Catalogue) -> None:
        self.goes_on, self.refuses = threading.Event(), False
        self.goes_on.set()
        open_writer = partial(Writer, open_database=self.open)
        self.store = Store(folder, catalogue.texts.__getitem__, open_writer)

    def open(self, path: Path) -> Any:
        self._check()
        self.connection = opened(path)
        return self

    def execute(self, sql: str, values: Any = ()) -> sqlite3.Cursor:
        self._check()
        if sql == "COMMIT":
            self.goes_on.wait(PATIENCE)
        return self.connection.execute(sql, values)

    def executemany(self, sql: str, rows: Any) -> sqlite3.Cursor:
        return self.connection.executemany(sql, rows)

    def close(self) -> None:
        self.connection.close()

    def _check(self) -> None:
        if self.refuses:
            raise sqlite3.OperationalError("disk I/O error")

    def writes(self) -> int:
        """How many writes were handed over, with this one."""
        return self.store.writer.put(())


@contextmanager
def kept_on_disk(folder: Path) -> Iterator[tuple[Registry, CommandedDisk]]:
    """A registry that keeps its stages, and the disk."""
    catalogue = Catalogue()
    held, disk = registry(catalogue), CommandedDisk(folder, catalogue)
    held.store = disk.store
    try:
        yield held, disk
    finally:
        disk.refuses = False
        disk.goes_on.set()
        disk.store.close()
