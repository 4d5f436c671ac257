"""The idempotency keys of requests that make or rename a machine: they stand in a file of its folder, which
comes to its place together with the machine. So a request that is sent again, for want of an answer, counts
once.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

from statwalk.errors import ConflictError
from statwalk.services.library.model_store import ModelStore

FILE_NAME = ".keys"
FIELD = "Idempotency-Key"


class MadeKey(NamedTuple):
    """Hashes of a key, and of the request that bears it."""

    key: str
    request: str

    @classmethod
    def of(cls, key: str, *request: object) -> MadeKey | None:
        """Returns the key of a request; None without a key."""
        return cls(_digest(key), _digest(repr(request))) if key else None


class NewPlace(NamedTuple):
    """Where a machine is made: under which name in which data folder, by which request."""

    name: str
    store: ModelStore
    key: MadeKey | None = None


def sign(folder: Path, key: MadeKey | None) -> None:
    """Writes into a machine's folder which request makes or renames it, and waits until that is durable."""
    if key is not None:
        with (folder / FILE_NAME).open("a", encoding="ascii") as file:
            file.write(f"{key.key} {key.request}\n")
            file.flush()
            os.fsync(file.fileno())


def made_by(key: MadeKey | None, folders: Iterable[Path]) -> str | None:
    """Returns the name that the machine has which a request made, or is to rename; None: there is none.

    :raises ConflictError: when the key belongs to another request.
    """
    for folder in folders if key is not None else ():
        for line in _lines(folder / FILE_NAME):
            if key is not None and line[0] == key.key:
                if line != key:
                    raise ConflictError("the idempotency key belongs to another request", field=FIELD)
                return folder.name
    return None


def _lines(file: Path) -> list[tuple[str, ...]]:
    """The whole lines of a file: a power cut may have torn the last one."""
    text = file.read_text("ascii", "replace") if file.is_file() else ""
    lines = (tuple(line.split()) for line in text.splitlines())
    return [line for line in lines if len(line) == len(MadeKey._fields)]


def _digest(text: str) -> str:
    return hashlib.blake2b(text.encode(), digest_size=16).hexdigest()
