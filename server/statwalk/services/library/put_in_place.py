"""Replaces a file whole, or not at all."""

from __future__ import annotations

import os
import secrets
import shutil
from contextlib import suppress
from pathlib import Path

from statwalk.errors import StorageError
from statwalk.files.machine_yaml.machine_file import FILE_NAME
from statwalk.files.machine_yaml.machine_text import MachineText


def put_in_place(path: Path, text: str) -> None:
    """Replaces the file atomically, and keeps its permissions; the text is on the disk afterwards.

    :raises StorageError: when the file cannot be written; it is as it was.
    """
    unfinished = path.with_name(f".machine-{secrets.token_hex(4)}")
    try:
        with unfinished.open("x", encoding="utf-8", newline="") as file:
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
        if path.exists():
            shutil.copymode(path, unfinished)
        unfinished.replace(path)
    except OSError as error:
        with suppress(OSError):
            unfinished.unlink(missing_ok=True)
        raise StorageError.of(error, path.name) from None


def put_machine_in_place(folder: Path, text: MachineText) -> None:
    """Replaces a machine file, and before it the tables that have changed.

    :raises StorageError: when a file cannot be written.
    """
    for name, table in text.tables.items():
        path = folder / name
        if not path.is_file() or path.read_bytes() != table.encode():
            put_in_place(path, table)
    put_in_place(folder / FILE_NAME, text.yaml)
