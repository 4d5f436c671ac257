"""Two processes that want one data folder at the same instant."""

import multiprocessing
import os
import sys
from collections.abc import Sequence
from multiprocessing import forkserver
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Self
from unittest.mock import patch

from statwalk.errors import ConflictError, StatwalkError
from statwalk.services.hosting.store import store as store_module
from statwalk.services.hosting.store.store import Store

CONTEXT = multiprocessing.get_context("forkserver")
CONTEXT.set_forkserver_preload(["races"])


class FileAsLock:
    """The control: a file with a process number, looked at and then written, as many programs do."""

    def __init__(self, folder: Path) -> None:
        folder.mkdir(parents=True, exist_ok=True)
        self.path = folder / "pid"
        if self.path.exists():
            raise ConflictError("another process uses the data folder")
        self.path.write_text(str(os.getpid()))

    def release(self) -> None:
        self.path.unlink()


def start_forks() -> None:
    """Starts the process from which the others fork; it finds this module by PYTHONPATH only."""
    with patch.dict(os.environ, {"PYTHONPATH": os.pathsep.join(sys.path)}):
        forkserver.ensure_running()


def _race(folders: Connection, is_honest: bool) -> None:
    """Opens the store of each folder that it is told, says whether it has it, and gives it back when told."""
    if not is_honest:
        store_module.FolderLock = FileAsLock  # type: ignore[assignment,misc]
    while folder := folders.recv():
        try:
            store = Store(folder, str)
        except StatwalkError as refusal:
            folders.send(str(refusal))
            folders.recv()
        else:
            folders.send("")
            folders.recv()
            store.close()


class Racers:
    """Two processes that race for one folder after another."""

    def __init__(self, *, is_honest: bool = True) -> None:
        start_forks()
        self.is_honest = is_honest
        self.racers = [self._start() for _ in range(2)]

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        for process, _ in self.racers:
            process.kill()
            process.join()

    def _start(self) -> tuple[multiprocessing.process.BaseProcess, Connection]:
        ours, theirs = CONTEXT.Pipe()
        process = CONTEXT.Process(target=_race, args=(theirs, self.is_honest))
        process.start()
        theirs.close()
        return process, ours

    def run(self, folder: Path, *, kills_winner: bool) -> Sequence[str]:
        """Races for a folder; returns what each was told, empty for a winner. The winner is killed, or gives
        the folder back; then a fresh process must get it at once.
        """
        for _, pipe in self.racers:
            pipe.send(folder)
        told = [pipe.recv() for _, pipe in self.racers]
        for place, refusal in enumerate(told):
            process, pipe = self.racers[place]
            if not refusal and kills_winner:
                process.kill()
                process.join()
                self.racers[place] = self._start()
            else:
                pipe.send("go on")
        return told
