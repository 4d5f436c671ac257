"""Databases as older versions wrote them: stages without names and origins, hashes without keys, logs
without ends.
"""

import hashlib
import sqlite3
from pathlib import Path

from statwalk.services.hosting.store.records import KeptBeginning, row_digest


def joined(*parts: bytes) -> bytes:
    return hashlib.blake2b(b"\0".join(parts), digest_size=16).digest()


def _of_version(machine, number, at, what, text, before):
    return joined(machine.encode(), f"MachineVersion({number=}, {at=}, {what=}, {text=}, {before=})".encode())


def to_format_4(path: Path) -> None:
    """Rewrites a database of the present format."""
    columns = "machine, number, at, what, text, before"
    connection = sqlite3.connect(path)
    connection.create_function("row_digest", -1, row_digest)
    connection.executescript(
        f"""
        CREATE TABLE old (machine TEXT NOT NULL, number INTEGER NOT NULL, at REAL NOT NULL,
            what TEXT NOT NULL, text TEXT NOT NULL, before INTEGER NOT NULL, digest BLOB NOT NULL,
            PRIMARY KEY (machine, number)
        ) STRICT, WITHOUT ROWID;
        INSERT INTO old SELECT {columns}, row_digest({columns}) FROM versions;
        DROP TABLE versions;
        ALTER TABLE old RENAME TO versions;
        PRAGMA user_version=4;
        """
    )
    connection.close()


def to_format_3(path: Path) -> None:
    """Rewrites a database of the present format."""
    to_format_4(path)
    with sqlite3.connect(path) as connection:
        connection.create_function("row_digest", -1, row_digest)
        for column in ("name", "parent", "forked_tick", "forked_number", "made"):
            connection.execute(f"ALTER TABLE stages DROP COLUMN {column}")
        columns = "id, opened, seed, rate, clock, tick, head, hash, paused, speed, keep_running"
        connection.execute(f"UPDATE stages SET digest = row_digest({columns})")
        connection.execute("PRAGMA user_version=3")
    connection.close()


def to_format_2(path: Path) -> None:
    """Rewrites a database of the present format."""
    to_format_3(path)
    with sqlite3.connect(path) as connection:
        for name, function in {
            "of_role": lambda text, model: joined(text.encode(), model),
            "of_snapshot": joined,
            "of_beginning": lambda *row: joined(repr(KeptBeginning(*row)).encode()),
            "of_version": _of_version,
        }.items():
            connection.create_function(name, -1, function)
        connection.executescript(
            """
            UPDATE roles SET digest = of_role(text, model);
            UPDATE snapshots SET digest = of_snapshot(data);
            UPDATE beginnings SET digest = of_beginning(tick, number);
            UPDATE versions SET digest = of_version(machine, number, at, what, text, before);
            ALTER TABLE stages DROP COLUMN digest;
            ALTER TABLE stages DROP COLUMN keep_running;
            ALTER TABLE keys DROP COLUMN digest;
            DROP TABLE ends;
            PRAGMA user_version=2;
            """
        )
    connection.close()


def to_format_1(path: Path) -> None:
    """Rewrites a database in which nothing was forgotten."""
    to_format_2(path)
    connection = sqlite3.connect(path)
    connection.executescript("DROP TABLE beginnings; PRAGMA user_version=1;")
    connection.close()
