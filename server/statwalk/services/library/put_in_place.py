"""Replaces a file whole, or not at all."""

from __future__ import annotations

import os
import secrets
import shutil
from contextlib import suppress
from pathlib import Path

from statwalk.errors import StorageError


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
