"""The store of the data folder that a server owns: it keeps stages and versions of machines."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path

from statwalk.character.role import Role
from statwalk.errors import StorageError
from statwalk.services.hosting.store import database
from statwalk.services.hosting.store.folder_lock import FolderLock
from statwalk.services.hosting.store.kept_stage import KeptStage
from statwalk.services.hosting.store.read_records import KeptRecords
from statwalk.services.hosting.store.records import (
    KeptKey,
    MachineVersion,
    StageIdentity,
    machine_keys,
    sealed,
    version_row,
)
from statwalk.services.hosting.store.writer import Statement, Writer

PATIENCE_SECONDS = 20.0
"""how long a request waits for a disk that is only slow"""
MOST_EDIT_KEYS = 1_000
"""keys that are kept for one machine; the keys of the oldest versions are forgotten first"""
FORGET_KEYS = "DELETE FROM keys WHERE stage = ?"


class Store:
    """The database of a data folder that this process owns. Thread-safe."""

    def __init__(
        self,
        folder: Path,
        text_of: Callable[[Role], str],
        open_writer: Callable[[Path], Writer] = Writer,
    ) -> None:
        """Takes the folder, and opens its database; `text_of` gives the machine file's text of a role.

        :raises ConflictError: when another process uses the folder.
        :raises ContentError: when the database cannot be read.
        :raises StorageError: when the folder cannot be written.
        """
        try:
            self._lock = FolderLock(folder)
        except OSError as error:
            raise StorageError(f"the data folder {folder} cannot be used: {error.strerror}") from None
        path, self.text_of = folder / database.FILE_NAME, text_of
        self.records = KeptRecords(path)
        try:
            self.writer = open_writer(path)
        except BaseException:
            self._lock.release()
            raise

    def close(self) -> None:
        """Writes what waits, and gives the folder back."""
        self.writer.close()
        self._lock.release()

    def check(self) -> None:
        """Waits until the disk has taken a write.

        :raises StorageError: when the disk refuses.
        """
        self.writer.check()
        self.writer.put(())
        self.flush()

    def flush(self) -> None:
        """Waits until everything so far is durable.

        :raises StorageError: when the disk refuses.
        """
        self.writer.flush(PATIENCE_SECONDS)

    # --- stages

    def stage(self, identity: StageIdentity) -> KeptStage:
        """Returns the keeper of a stage, which has not begun."""
        return KeptStage(identity, self.writer, self.text_of)

    def drop(self, stage: str) -> None:
        """Forgets a stage."""
        deleted = [Statement(f"DELETE FROM {table} WHERE stage = ?", [(stage,)]) for table in database.PARTS]  # noqa: S608 - our own names
        self.writer.put([Statement("DELETE FROM stages WHERE id = ?", [(stage,)]), *deleted])

    def rename(self, stage: str, name: str) -> None:
        """Gives a stage another id, also where its forks name it."""
        tables = database.STAGES, *database.PARTS
        renamings = [*map(database.renaming, tables), database.renaming_parent()]
        self.writer.put([Statement(sql, [(name, stage)]) for sql in renamings])

    # --- versions of machines

    def keep_versions(self, machine: str, versions: Iterable[MachineVersion], old: int) -> None:
        """Keeps versions of a machine, forgets those up to the number `old`, and waits until it is durable.

        :raises StorageError: when the disk refuses; then the versions are forgotten.
        """
        rows = [version_row(machine, version) for version in versions]
        self.writer.put(
            [
                Statement("INSERT OR REPLACE INTO versions VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)", rows),
                Statement("DELETE FROM versions WHERE machine = ? AND number <= ?", [(machine, old)]),
            ]
        )
        try:
            self.flush()
        except StorageError:  # what was handed over is written when the disk takes writes again
            forget = "DELETE FROM versions WHERE machine = ? AND number = ?"
            self.writer.put([Statement(forget, [row[:2] for row in rows])])
            raise

    def keep_edit_key(self, machine: str, key: str, answer: KeptKey) -> None:
        """Keeps the key of an edit, forgets the oldest ones, and waits until it is durable.

        :raises StorageError: when the disk refuses.
        """
        owner = machine_keys(machine)
        self.writer.put(
            [
                Statement(
                    "INSERT OR REPLACE INTO keys VALUES (?, ?, ?, ?, ?, ?, ?)", [sealed(owner, key, *answer)]
                ),
                Statement(
                    "DELETE FROM keys WHERE stage = ?1 AND key NOT IN "
                    "(SELECT key FROM keys WHERE stage = ?1 ORDER BY tick DESC LIMIT ?2)",
                    [(owner, MOST_EDIT_KEYS)],
                ),
            ]
        )
        self.flush()

    def copy_versions(self, new: str, versions: Iterable[MachineVersion]) -> None:
        """Keeps the versions of a machine under another name too, in place of what that name had, and waits
        until that is durable.

        :raises StorageError: when the disk refuses.
        """
        rows = [version_row(new, version) for version in versions]
        self.drop_versions(new, Statement("INSERT INTO versions VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)", rows))
        self.flush()

    def drop_versions(self, machine: str, *then: Statement) -> None:
        """Forgets the versions of a machine; `then` goes into the same commit."""
        forget = Statement("DELETE FROM versions WHERE machine = ?", [(machine,)])
        self.writer.put([forget, Statement(FORGET_KEYS, [(machine_keys(machine),)]), *then])

    def forget_versions(self, machine: str) -> None:
        """Forgets the versions of a machine, and waits until that is durable.

        :raises StorageError: when the disk refuses.
        """
        self.drop_versions(machine)
        self.flush()
