"""The data folder: uploaded characters under the hash of their content, and the machines made of them. It survives restarts.

    characters/<sha256>.glb   the models; a file is there whole or not at all
    names/<name>.json         {"sha256", "bytes"}: which content a character's name means now
    machines/<name>/          machine folders, whose character is one of the models
    tmp/                      what is not finished yet

Everything is written beside its place, flushed to the disk, and renamed into it.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
import shutil
import tempfile
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from statwalk.files.machinefile import FILE_NAME

NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_-]{0,63}")
SHA = re.compile(r"[0-9a-f]{64}")
LEFTOVER_SECONDS = 3_600.0


@dataclass(frozen=True)
class Kept:
    """An uploaded character: `sha256` of its .glb, which has `bytes` bytes."""

    name: str
    sha256: str
    bytes: int


class Depot:
    """The data folder. Safe to use from several threads; the folder is made when something is first kept."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder.resolve()
        self.models, self.names = self.folder / "characters", self.folder / "names"
        self.machines, self.unfinished = self.folder / "machines", self.folder / "tmp"
        self.lock = threading.RLock()
        self.sweep()

    # --- reading

    def characters(self) -> dict[str, Kept]:
        """The uploaded characters by name, sorted."""
        found = (self.find(path.stem) for path in sorted(self.names.glob("*.json")))
        return {kept.name: kept for kept in found if kept is not None}

    def find(self, name: str) -> Kept | None:
        """The character of that name; None where there is none, or its record is damaged."""
        if not NAME.fullmatch(name):
            return None
        try:
            record = json.loads((self.names / f"{name}.json").read_bytes())
            kept = Kept(name, str(record["sha256"]), int(record["bytes"]))
        except (OSError, ValueError, KeyError, TypeError):
            return None
        return kept if SHA.fullmatch(kept.sha256) and self.model(kept.sha256).is_file() else None

    def model(self, sha256: str) -> Path:
        """Where the model of that content is."""
        return self.models / f"{sha256}.glb"

    def machine_folders(self) -> list[Path]:
        """The machines made here, sorted by name."""
        return sorted(path.parent for path in self.machines.glob(f"*/{FILE_NAME}") if NAME.fullmatch(path.parent.name))

    def machines_of(self, sha256: str) -> list[str]:
        """The machines whose character has that content."""
        return [folder.name for folder in self.machine_folders() if sha256 in read_or_empty(folder / FILE_NAME)]

    # --- writing

    @contextmanager
    def working(self) -> Iterator[Path]:
        """A folder for what is not finished, on the same disk; it is gone afterwards."""
        self.unfinished.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=self.unfinished) as folder:
            yield Path(folder)

    def keep_model(self, file: Path) -> tuple[str, int]:
        """Moves a model to its place; its hash and length."""
        with file.open("rb") as opened:
            sha256 = hashlib.file_digest(opened, "sha256").hexdigest()
            os.fsync(opened.fileno())
            length = os.fstat(opened.fileno()).st_size
        self.models.mkdir(parents=True, exist_ok=True)
        file.replace(self.model(sha256))
        flush_folder(self.models)
        return sha256, length

    def keep(self, name: str, file: Path) -> Kept:
        """Moves a model to its place, and lets `name` mean it from now on."""
        with self.lock:
            kept = Kept(name, *self.keep_model(file))
            self.names.mkdir(parents=True, exist_ok=True)
            with self.working() as folder:
                record = folder / "record"
                record.write_text(json.dumps({"sha256": kept.sha256, "bytes": kept.bytes}))
                flush(record)
                record.replace(self.names / f"{name}.json")
            flush_folder(self.names)
            self.drop_unused()
            return kept

    def keep_machine(self, name: str, written: Path) -> Path:
        """Moves a machine folder that was written in `working` to its place, where there must be none of that name."""
        with self.lock:
            self.machines.mkdir(parents=True, exist_ok=True)
            for path in written.iterdir():
                flush(path)
            written.rename(self.machines / name)
            flush_folder(self.machines)
            return self.machines / name

    def forget(self, name: str) -> None:
        """Lets go of a character; its model, if no machine is made of it."""
        with self.lock:
            (self.names / f"{name}.json").unlink(missing_ok=True)
            flush_folder(self.names)
            self.drop_unused()

    def forget_machine(self, name: str) -> None:
        """Lets go of a machine; its model, if nothing else needs it."""
        with self.lock:
            with self.working() as folder:
                (self.machines / name).rename(folder / name)
                flush_folder(self.machines)
            self.drop_unused()

    def drop_unused(self) -> None:
        """Removes the models that no name means and no machine is made of."""
        named = {kept.sha256 for kept in self.characters().values()}
        for path in self.models.glob("*.glb"):
            if path.stem not in named and not self.machines_of(path.stem):
                path.unlink(missing_ok=True)

    def sweep(self) -> None:
        """Removes what a server left unfinished when it was killed."""
        for path in self.unfinished.glob("*"):
            if time.time() - path.stat().st_mtime > LEFTOVER_SECONDS:
                shutil.rmtree(path, ignore_errors=True)


def read_or_empty(path: Path) -> str:
    """The text of a file that may just have gone."""
    try:
        return path.read_text(encoding="utf-8", errors="replace")
    except OSError:
        return ""


def flush(path: Path) -> None:
    """Until the file's bytes are on the disk."""
    with path.open("rb") as file:
        os.fsync(file.fileno())


def flush_folder(path: Path) -> None:
    """Until the folder's names are on the disk, where the system can do that."""
    if not hasattr(os, "O_DIRECTORY"):
        return
    opened = os.open(path, os.O_RDONLY | os.O_DIRECTORY)
    try:
        os.fsync(opened)
    finally:
        os.close(opened)
