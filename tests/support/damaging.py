"""Damages the database of a data folder, as a bad disk does."""

import sqlite3
from pathlib import Path

from statwalk.services.hosting.store.database import FILE_NAME


def damaged(folder: Path, change: str) -> None:
    """Changes rows of the database by a statement."""
    connection = sqlite3.connect(folder / FILE_NAME)
    with connection:
        assert connection.execute(change).rowcount > 0
    connection.close()


def emptied(folder: Path, table: str, column: str) -> None:
    """Takes the values of a column away, which a flip of one bit can do in spite of NOT NULL."""
    for change in (
        f"UPDATE sqlite_schema SET sql = replace(sql, '{column} REAL NOT NULL', '{column} REAL')",
        f"UPDATE {table} SET {column} = NULL",
        f"UPDATE sqlite_schema SET sql = replace(sql, '{column} REAL', '{column} REAL NOT NULL')",
    ):
        connection = sqlite3.connect(folder / FILE_NAME)
        with connection:
            connection.execute("PRAGMA writable_schema = ON")
            assert connection.execute(change).rowcount > 0
        connection.close()
