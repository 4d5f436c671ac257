"""The database of the data folder: its tables, and how it is opened.

`synchronous=FULL` in WAL mode: a commit returns when it is on the disk, so that a commit survives a power
cut. Each row of a log holds the hash of all rows before it, `ends` says where each log ends, and each other
row holds a hash of itself: a flipped bit is found when a stage is read.
"""

from __future__ import annotations

import os
import sqlite3
from pathlib import Path

from statwalk.errors import ContentError, StorageError
from statwalk.services.hosting.store.records import row_digest
from statwalk.services.hosting.store.upgrades import UPGRADES

FILE_NAME = "statwalk.db"
FORMAT = 5
APPLICATION = 0x5374576B
"""the number by which `file` and SQLite tell whose database it is: "StWk" """
LARGEST_WAL_BYTES = 16 << 20
STAGES = "stages"
KEYS = "keys"
VERSIONS = "versions"
PARTS = ("beginnings", "roles", "commands", "ends", "snapshots", KEYS)
"""the tables with rows of stages"""
SEALED = {
    STAGES: (
        "id, opened, seed, rate, clock, tick, head, hash, paused, speed, keep_running, "
        "name, parent, forked_tick, forked_number, made"
    ),
    "beginnings": "stage, tick, number",
    "roles": "stage, role, text, model",
    "ends": "stage, entries, chain",
    "snapshots": "stage, tick, data",
    "keys": "stage, key, request, tick, seq, answered_by",
}
"""by table, the columns under the hash of a row"""
CACHE_KIB = 64
"""SQLite keeps so much of the database in memory, in place of its 2 MiB: hardly a row is read again before
the next start
"""
PRAGMAS = (
    "journal_mode=WAL",
    "synchronous=FULL",
    f"journal_size_limit={LARGEST_WAL_BYTES}",
    f"cache_size=-{CACHE_KIB}",
)
TABLES = """
CREATE TABLE stages (
    id TEXT PRIMARY KEY, opened TEXT NOT NULL, seed INTEGER NOT NULL, rate INTEGER NOT NULL,
    clock TEXT NOT NULL, tick INTEGER NOT NULL, head INTEGER NOT NULL, hash TEXT NOT NULL,
    paused INTEGER NOT NULL, speed REAL NOT NULL, keep_running INTEGER NOT NULL, name TEXT NOT NULL,
    parent TEXT NOT NULL, forked_tick INTEGER NOT NULL, forked_number INTEGER NOT NULL, made REAL NOT NULL,
    digest BLOB NOT NULL
) STRICT;
CREATE TABLE beginnings (
    stage TEXT PRIMARY KEY, tick INTEGER NOT NULL, number INTEGER NOT NULL, digest BLOB NOT NULL
) STRICT, WITHOUT ROWID;
CREATE TABLE roles (
    stage TEXT NOT NULL, role TEXT NOT NULL, text TEXT NOT NULL, model BLOB NOT NULL, digest BLOB NOT NULL,
    PRIMARY KEY (stage, role)
) STRICT, WITHOUT ROWID;
CREATE TABLE commands (
    stage TEXT NOT NULL, place INTEGER NOT NULL, line TEXT NOT NULL, chain BLOB NOT NULL,
    PRIMARY KEY (stage, place)
) STRICT, WITHOUT ROWID;
CREATE TABLE ends (
    stage TEXT PRIMARY KEY, entries INTEGER NOT NULL, chain BLOB NOT NULL, digest BLOB NOT NULL
) STRICT, WITHOUT ROWID;
CREATE TABLE snapshots (
    stage TEXT NOT NULL, tick INTEGER NOT NULL, data BLOB NOT NULL, digest BLOB NOT NULL,
    PRIMARY KEY (stage, tick)
) STRICT;
CREATE TABLE keys (
    stage TEXT NOT NULL, key TEXT NOT NULL, request BLOB NOT NULL, tick INTEGER NOT NULL,
    seq INTEGER NOT NULL, answered_by TEXT NOT NULL, digest BLOB NOT NULL,
    PRIMARY KEY (stage, key)
) STRICT, WITHOUT ROWID;
CREATE TABLE versions (
    machine TEXT NOT NULL, number INTEGER NOT NULL, at REAL NOT NULL, what TEXT NOT NULL,
    text TEXT NOT NULL, before INTEGER NOT NULL, after INTEGER NOT NULL, author TEXT NOT NULL,
    digest BLOB NOT NULL, PRIMARY KEY (machine, number)
) STRICT, WITHOUT ROWID;
CREATE TABLE commits (only INTEGER PRIMARY KEY CHECK (only = 1), ticket INTEGER NOT NULL) STRICT;
INSERT INTO commits VALUES (1, 0);
"""


DAMAGED = "the database is damaged where it says which tables it has"
_ORPHANS = "DELETE FROM {0} WHERE stage NOT IN (SELECT id FROM stages UNION SELECT stage FROM ends)"
"""a command may have followed the end of its stage; where a log has an end, the stage's row is missing"""
WITH_ORPHANS = KEYS
"""rows of no stage stay here: a flip may have given a row another stage, which reports it"""


def renaming(table: str) -> str:
    """Returns the statement that gives the rows of a stage its new id (the first value, the old one is the
    second); rows that are damaged stay so.
    """
    if table not in SEALED:
        return f"UPDATE {table} SET stage = ?1 WHERE stage = ?2"  # noqa: S608 - our own names
    columns = SEALED[table]
    key, _, rest = columns.partition(", ")
    digest = f"CASE digest WHEN row_digest({columns}) THEN row_digest(?1, {rest}) ELSE digest END"
    return f"UPDATE {table} SET {key} = ?1, digest = {digest} WHERE {key} = ?2"  # noqa: S608 - our own names


def renaming_parent() -> str:
    """Returns the statement that gives the forks of a stage the stage's new id (the first value, the old one
    is the second).
    """
    columns = SEALED[STAGES]
    renamed = columns.replace(" parent,", " ?1,")
    digest = f"CASE digest WHEN row_digest({columns}) THEN row_digest({renamed}) ELSE digest END"
    return f"UPDATE {STAGES} SET parent = ?1, digest = {digest} WHERE parent = ?2"  # noqa: S608 - our own names


def opened(path: Path) -> sqlite3.Connection:
    """Opens the database; makes it if there is none. The caller begins and commits transactions itself.

    :raises ContentError: when the file is no database of statwalk, or of another version.
    :raises StorageError: when the disk refuses.
    :raises sqlite3.Error: when the disk refuses.
    """
    _write_again(path.with_name(f"{path.name}-wal"))
    connection = sqlite3.connect(path, isolation_level=None, check_same_thread=False, timeout=5.0)
    try:
        connection.create_function("row_digest", -1, row_digest, deterministic=True)
        _check_format(connection, path)
        for pragma in PRAGMAS:
            connection.execute(f"PRAGMA {pragma}")
        mode, synchronous = (
            connection.execute(f"PRAGMA {name}").fetchone()[0] for name in ("journal_mode", "synchronous")
        )
        for table in PARTS:
            if table != WITH_ORPHANS:
                connection.execute(_ORPHANS.format(table))
        # gives free space back to the disk; `execute` would give one page back
        connection.executescript("PRAGMA incremental_vacuum")
        if (mode, synchronous) != ("wal", 2):
            raise ContentError(
                f"the folder cannot keep a database in WAL mode (it has {mode}); use one on a local disk",
                file=str(path),
            )
    except UnicodeDecodeError as error:  # SQLite's message repeats what is damaged
        connection.close()
        raise sqlite3.DatabaseError(DAMAGED) from error
    except BaseException:
        connection.close()
        raise
    return connection


def _write_again(log: Path) -> None:
    """Writes SQLite's log once more, if one was left, and flushes it.

    After a flush that failed Linux takes what it did not write for written: SQLite would read commits, and
    the next flush would promise them, that a power cut takes.
    """
    try:
        with log.open("r+b", buffering=0) as file:
            os.pwrite(file.fileno(), file.readall(), 0)
            os.fsync(file.fileno())
    except FileNotFoundError:
        return
    except OSError as error:
        raise StorageError.of(error, "the log of the database") from None


def _check_format(connection: sqlite3.Connection, path: Path) -> None:
    try:
        application, version = (
            connection.execute(f"PRAGMA {name}").fetchone()[0] for name in ("application_id", "user_version")
        )
    except sqlite3.DatabaseError as error:
        if type(error) is not sqlite3.DatabaseError:
            raise  # the disk, and not the file
        raise ContentError(
            f"the file is no database ({error}); move it away, or bring a backup back", file=str(path)
        ) from None
    if (application, version) == (0, 0):
        connection.execute("PRAGMA auto_vacuum=INCREMENTAL")  # before anything is written
        connection.execute("PRAGMA journal_mode=WAL")
        connection.executescript(
            f"BEGIN; {TABLES} PRAGMA application_id={APPLICATION}; PRAGMA user_version={FORMAT}; COMMIT;"
        )
    elif application == APPLICATION and version in UPGRADES:
        connection.execute("BEGIN IMMEDIATE")
        UPGRADES[version](connection)
        connection.execute(f"PRAGMA user_version={version + 1}")
        connection.execute("COMMIT")
        _check_format(connection, path)
    elif (application, version) != (APPLICATION, FORMAT):
        raise ContentError(
            f"the database is of format {version}, and this version of statwalk reads {FORMAT}",
            file=str(path),
        )
