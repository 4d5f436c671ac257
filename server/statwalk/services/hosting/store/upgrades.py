"""Brings databases of older formats up to date, each in one transaction."""

from __future__ import annotations

import hashlib
import sqlite3
from collections.abc import Callable
from typing import Any

from statwalk.services.hosting.store.records import sealed


def _to_2(database: sqlite3.Connection) -> None:
    """Stages that have forgotten begin with a state."""
    database.execute(
        "CREATE TABLE beginnings (stage TEXT PRIMARY KEY, tick INTEGER NOT NULL, number INTEGER NOT NULL, "
        "digest BLOB NOT NULL) STRICT, WITHOUT ROWID"
    )


def _to_3(database: sqlite3.Connection) -> None:
    """Each row has a hash of all its values, its key too, and each log an end; rows that were damaged before
    get none.
    """
    for change in (
        "ALTER TABLE stages ADD COLUMN keep_running INTEGER NOT NULL DEFAULT 0",
        "ALTER TABLE stages ADD COLUMN digest BLOB NOT NULL DEFAULT x''",
        "ALTER TABLE keys ADD COLUMN digest BLOB NOT NULL DEFAULT x''",
        "CREATE TABLE ends (stage TEXT PRIMARY KEY, entries INTEGER NOT NULL, chain BLOB NOT NULL, "
        "digest BLOB NOT NULL) STRICT, WITHOUT ROWID",
    ):
        database.execute(change)
    for table, (columns, before) in SEALED_IN_3.items():
        name = f"{table}_were_whole"
        database.create_function(name, -1, before)
        digest = f"CASE WHEN {name}(digest, {columns}) THEN row_digest({columns}) ELSE x'' END"
        database.execute(f"UPDATE {table} SET digest = {digest}")  # noqa: S608 - our own names
    for stage, entries in database.execute(
        "SELECT id, (SELECT count(*) FROM commands WHERE stage = id) FROM stages"
    ).fetchall():
        last = "SELECT chain FROM commands WHERE stage = ? ORDER BY place DESC LIMIT 1"
        (chain,) = database.execute(last, (stage,)).fetchone() or (b"",)
        database.execute("INSERT INTO ends VALUES (?, ?, ?, ?)", sealed(stage, entries, chain))


def _to_4(database: sqlite3.Connection) -> None:
    """Stages have names, the time when they were made, and forks know where they began; rows that were
    damaged before stay so.
    """
    new = {
        "name": "TEXT",
        "parent": "TEXT",
        "forked_tick": "INTEGER",
        "forked_number": "INTEGER",
        "made": "REAL",
    }
    for name, kind in new.items():
        default = "''" if kind == "TEXT" else "0"
        database.execute(f"ALTER TABLE stages ADD COLUMN {name} {kind} NOT NULL DEFAULT {default}")
    old, _ = SEALED_IN_3["stages"]
    digest = f"row_digest({old}, {', '.join(new)})"
    whole = f"CASE digest WHEN row_digest({old}) THEN {digest} ELSE x'' END"
    database.execute(f"UPDATE stages SET digest = {whole}")  # noqa: S608 - our own names


def _to_5(database: sqlite3.Connection) -> None:
    """A version says what a redo brings back, and who made it."""
    columns = "machine, number, at, what, text, before"
    database.execute("ALTER TABLE versions RENAME TO versions_4")
    database.execute(
        "CREATE TABLE versions (machine TEXT NOT NULL, number INTEGER NOT NULL, at REAL NOT NULL, "
        "what TEXT NOT NULL, text TEXT NOT NULL, before INTEGER NOT NULL, after INTEGER NOT NULL, "
        "author TEXT NOT NULL, digest BLOB NOT NULL, PRIMARY KEY (machine, number)) STRICT, WITHOUT ROWID"
    )
    digest = f"CASE digest WHEN row_digest({columns}) THEN row_digest({columns}, 0, '') ELSE x'' END"
    database.execute(
        f"INSERT INTO versions SELECT {columns}, 0, '', {digest} FROM versions_4"  # noqa: S608 - our own names
    )
    database.execute("DROP TABLE versions_4")


def _joined(*parts: bytes) -> bytes:
    """The hash of format 2."""
    return hashlib.blake2b(b"\0".join(parts), digest_size=16).digest()


# whether a row was whole by the hash of format 2; its key was not under the hash


def _unknown(*_: Any) -> bool:
    return True


def _beginning_was_whole(digest: bytes, *row: Any) -> bool:
    return digest == _joined("KeptBeginning(tick={}, number={})".format(*row[1:]).encode())


def _role_was_whole(digest: bytes, *row: Any) -> bool:
    return digest == _joined(row[2].encode(), row[3])


def _snapshot_was_whole(digest: bytes, *row: Any) -> bool:
    return digest == _joined(row[2])


def _version_was_whole(digest: bytes, *row: Any) -> bool:
    machine, number, at, what, text, before = row
    version = f"MachineVersion({number=}, {at=}, {what=}, {text=}, {before=})"
    return digest == _joined(machine.encode(), version.encode())


SEALED_IN_3: dict[str, tuple[str, Callable[..., bool]]] = {
    "stages": ("id, opened, seed, rate, clock, tick, head, hash, paused, speed, keep_running", _unknown),
    "keys": ("stage, key, request, tick, seq, answered_by", _unknown),
    "beginnings": ("stage, tick, number", _beginning_was_whole),
    "roles": ("stage, role, text, model", _role_was_whole),
    "snapshots": ("stage, tick, data", _snapshot_was_whole),
    "versions": ("machine, number, at, what, text, before", _version_was_whole),
}
"""by table, the columns under the hash of a row, and whether a row was whole"""
UPGRADES: dict[int, Callable[[sqlite3.Connection], None]] = {1: _to_2, 2: _to_3, 3: _to_4, 4: _to_5}
"""by format, what brings a database to the next format; the connection has the function `row_digest`"""
