"""Changes of files that are on the disk afterwards, and the error of a disk that refuses them."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from statwalk.errors import StorageError


@contextmanager
def room_on_disk() -> Iterator[None]:
    """:raises StorageError: when the disk of the data folder refuses."""
    try:
        yield
    except OSError as error:
        raise StorageError.of(error, "the data folder") from None


def flush(path: Path) -> None:
    """Waits until the file's bytes are on the disk."""
    with path.open("rb") as file:
        os.fsync(file.fileno())


def flush_folder(path: Path) -> None:
    """Waits until the folder's names are on the disk; Windows cannot flush a folder."""
    if not hasattr(os, "O_DIRECTORY"):
        return
    descriptor = os.open(path, os.O_RDONLY | os.O_DIRECTORY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


def move(path: Path, target: Path, folder: Path) -> None:
    """Moves a file or a folder into `folder` or out of it, and waits until that is on the disk.

    :raises OSError: when the disk refuses; then `path` is where it was.
    """
    path.rename(target)
    try:
        flush_folder(folder)
    except OSError:
        target.rename(path)
        raise
