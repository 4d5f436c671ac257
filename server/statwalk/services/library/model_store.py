"""The data folder: uploaded characters under the hash of their model, and the machines made from them.

It survives restarts.

    characters/<sha256>.glb   the models; each file is complete
    characters/<sha256>.npz   the checked character of a model (`files.character_archive`)
    names/<name>.json         {"sha256", "bytes"}: the model that a character's name means now
    machines/<name>/          machine folders; the character of each is one of the models
    tmp/                      unfinished files

Every file is written in tmp/, flushed to the disk, and renamed to its place.
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
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from statwalk.character.character import Character
from statwalk.errors import ConflictError, ContentError, StorageError
from statwalk.files.character_archive import read_character
from statwalk.files.machine_yaml.machine_file import FILE_NAME
from statwalk.services.library.disk import flush, flush_folder, move, room_on_disk
from statwalk.services.library.upload_sandbox import checked_beside, read_in_child

NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_-]{0,63}")
SHA = re.compile(r"[0-9a-f]{64}")
LEFTOVER_SECONDS = 3_600.0


@dataclass(frozen=True)
class UploadedCharacter:
    """An uploaded character: `sha256` of its .glb, which has `bytes` bytes."""

    name: str
    sha256: str
    bytes: int


class ModelStore:
    """The data folder; the first upload creates it. Thread-safe."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder.resolve()
        self.models, self.names = self.folder / "characters", self.folder / "names"
        self.machines, self.unfinished = self.folder / "machines", self.folder / "tmp"
        self.lock = threading.RLock()
        self.sweep()

    # --- reading

    def characters(self) -> dict[str, UploadedCharacter]:
        """Returns the uploaded characters by name, sorted."""
        uploads = (self.find(path.stem) for path in sorted(self.names.glob("*.json")))
        return {upload.name: upload for upload in uploads if upload is not None}

    def find(self, name: str) -> UploadedCharacter | None:
        """Returns the character with this name; None if there is none, or if its record is damaged."""
        if not NAME.fullmatch(name):
            return None
        try:
            record = json.loads((self.names / f"{name}.json").read_bytes())
            upload = UploadedCharacter(name, str(record["sha256"]), int(record["bytes"]))
        except (OSError, ValueError, KeyError, TypeError):
            return None
        return upload if SHA.fullmatch(upload.sha256) and self.model(upload.sha256).is_file() else None

    def model(self, sha256: str) -> Path:
        """Returns the path of the model with this hash."""
        return self.models / f"{sha256}.glb"

    def read_model(self, sha256: str) -> bytes:
        """Returns the model with this hash.

        :raises ContentError: when the model is gone, with the last machine or name that used it.
        :raises StorageError: when the disk holds something else by now.
        """
        try:
            data = self.model(sha256).read_bytes()
        except FileNotFoundError:
            raise ContentError(f"the model {sha256[:8]} was deleted while the server worked on it") from None
        if hashlib.sha256(data).hexdigest() != sha256:
            raise StorageError(
                f"the model {sha256[:8]} in the data folder is damaged; upload it again, or restore a backup"
            )
        return data

    def machine_folders(self) -> list[Path]:
        """Returns the folders of the machines in the data folder, sorted by name."""
        return sorted(
            path.parent for path in self.machines.glob(f"*/{FILE_NAME}") if NAME.fullmatch(path.parent.name)
        )

    def machines_of(self, sha256: str) -> list[str]:
        """Returns the names of the machines in the data folder whose character is the model with
        this hash.
        """
        return [
            folder.name for folder in self.machine_folders() if sha256 in _read_or_empty(folder / FILE_NAME)
        ]

    def character(self, sha256: str) -> Character:
        """Returns the checked character of a model in the data folder.

        If the checked character is missing, damaged or from another version of statwalk, a child process
        checks the model again.

        :raises ContentError: when the child refuses the model.
        :raises StorageError: when the model is damaged, or the disk refuses.
        """
        model, data = self.model(sha256), self.read_model(sha256)
        try:
            return read_character(checked_beside(model), data)
        except ContentError:
            with room_on_disk(), self.working() as folder:
                read_in_child(model, folder / "model.glb", sha256)
                self.keep_checked(sha256, checked_beside(folder / "model.glb"))
            return read_character(checked_beside(model), data)

    # --- writing

    @contextmanager
    def working(self) -> Iterator[Path]:
        """Yields a new folder in tmp/ for unfinished files, and removes it afterwards."""
        self.unfinished.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=self.unfinished, ignore_cleanup_errors=True) as folder:
            yield Path(folder)

    def keep_model(self, file: Path) -> tuple[str, int]:
        """Moves a model to its place; returns its hash and its length in bytes."""
        with file.open("rb") as opened:
            sha256 = hashlib.file_digest(opened, "sha256").hexdigest()
            os.fsync(opened.fileno())
            length = os.fstat(opened.fileno()).st_size
        self.models.mkdir(parents=True, exist_ok=True)
        self.keep_checked(sha256, checked_beside(file))
        file.replace(self.model(sha256))
        flush_folder(self.models)
        return sha256, length

    def keep_checked(self, sha256: str, file: Path) -> None:
        """Moves the checked character of a model to its place, if the file exists."""
        if file.is_file():
            flush(file)
            file.replace(checked_beside(self.model(sha256)))

    def keep(self, name: str, file: Path) -> UploadedCharacter:
        """Moves a model to its place, and gives it the name; the name may have meant another model before."""
        with self.lock:
            upload = UploadedCharacter(name, *self.keep_model(file))
            self.names.mkdir(parents=True, exist_ok=True)
            with self.working() as folder:
                record = folder / "record"
                record.write_text(json.dumps({"sha256": upload.sha256, "bytes": upload.bytes}))
                flush(record)
                record.replace(self.names / f"{name}.json")
            flush_folder(self.names)
            self._drop_unused()
            return upload

    def keep_machine(self, name: str, written: Path) -> Path:
        """Moves a machine folder from a `working` folder to its place, and returns the place.

        :raises ConflictError: when a machine has the name.
        """
        with self.lock:
            if (self.machines / name).exists():
                raise ConflictError(f"a machine is called {name!r} already", field="name")
            self.machines.mkdir(parents=True, exist_ok=True)
            for path in written.rglob("*"):
                flush_folder(path) if path.is_dir() else flush(path)
            move(written, self.machines / name, self.machines)
            return self.machines / name

    def forget(self, name: str) -> None:
        """Deletes a character; deletes its model too if no other name means it and no machine uses it."""
        with self.lock:
            record = self.names / f"{name}.json"
            with self.working() as folder:
                move(record, folder / record.name, self.names)
            self._drop_unused()

    def forget_machine(self, name: str) -> None:
        """Deletes a machine; deletes its model too if no name means it and no other machine uses it."""
        with self.lock:
            with self.working() as folder:
                move(self.machines / name, folder / name, self.machines)
            self._drop_unused()

    def rename_machine(self, name: str, new: str) -> Path:
        """Gives a machine another name, which no machine may have; returns its folder."""
        with self.lock:
            move(self.machines / name, self.machines / new, self.machines)
            return self.machines / new

    def _drop_unused(self) -> None:
        """Deletes the models that no name means and no machine uses, as far as the disk lets it."""
        named = {upload.sha256 for upload in self.characters().values()}
        for path in self.models.glob("*.glb"):
            if path.stem not in named and not self.machines_of(path.stem):
                with suppress(OSError):  # the next time, then
                    path.unlink(missing_ok=True)
                    checked_beside(path).unlink(missing_ok=True)

    def sweep(self, seconds: float = LEFTOVER_SECONDS) -> None:
        """Deletes the unfinished files of a server that was killed, if they are so old."""
        for path in self.unfinished.glob("*"):
            with suppress(FileNotFoundError):  # a thread or process that works has removed its own
                if time.time() - path.stat().st_mtime >= seconds:
                    shutil.rmtree(path, ignore_errors=True)


def _read_or_empty(path: Path) -> str:
    """Returns the text of a file, or "" if another thread has just deleted the file."""
    try:
        return path.read_text(encoding="utf-8", errors="replace")
    except OSError:
        return ""
