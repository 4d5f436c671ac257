"""Replaces the files of a machine whole, or not at all."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from statwalk.errors import StorageError
from statwalk.files.machine_yaml.machine_file import FILE_NAME
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.services.library.disk import flush_folder

NEW, OLD = ".machine-new-", ".machine-old-"


@contextmanager
def put_machine_in_place(folder: Path, text: MachineText) -> Iterator[None]:
    """Replaces a machine file and the tables that have changed, with their permissions; the texts are on the
    disk when the context begins. One thread at a time may do it in a folder.

    An error in the context puts all files back as they were.

    :raises StorageError: when a file cannot be written.
    """
    texts = {folder / name: table for name, table in text.tables.items()} | {folder / FILE_NAME: text.yaml}
    _remove_unfinished(folder)  # of a server that was killed
    changed = [path for path, content in texts.items() if not _holds(path, content)]
    replaced: list[Path] = []
    try:
        for path in changed:
            _write(path, texts[path])
        for path in changed:
            _beside(path, NEW).replace(path)
            replaced.append(path)
        flush_folder(folder)
        yield
    except Exception as error:
        for path in replaced:
            _put_back(path)
        if isinstance(error, OSError):
            raise StorageError.of(error, FILE_NAME) from None
        raise
    finally:
        _remove_unfinished(folder)


def _beside(path: Path, mark: str) -> Path:
    return path.with_name(f"{mark}{path.name}")


def _holds(path: Path, content: str) -> bool:
    return path.is_file() and path.read_bytes() == content.encode()


def _write(path: Path, text: str) -> None:
    """Writes the new file beside the old one, and a copy of the old one, to which a rename goes back."""
    new = _beside(path, NEW)
    with new.open("x", encoding="utf-8", newline="") as file:
        file.write(text)
        file.flush()
        os.fsync(file.fileno())
    if path.exists():
        shutil.copymode(path, new)
        shutil.copy2(path, _beside(path, OLD))


def _put_back(path: Path) -> None:
    old = _beside(path, OLD)
    with suppress(OSError):
        if old.exists():
            old.replace(path)
        else:  # there was no such table before
            path.unlink()


def _remove_unfinished(folder: Path) -> None:
    for mark in (NEW, OLD):
        for file in folder.glob(f"{mark}*"):
            with suppress(OSError):
                file.unlink(missing_ok=True)
