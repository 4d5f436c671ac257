"""Keeps the last used characters of the data folder in memory, as the child process has checked them."""

from __future__ import annotations

import threading
from collections import OrderedDict
from dataclasses import replace
from pathlib import Path

from statwalk.character.character import Character
from statwalk.files.machine_yaml.machine_file import MachineFile
from statwalk.services.cancel import NEVER, CancelToken
from statwalk.services.library.capture_sandbox import captured
from statwalk.services.library.disk import room_on_disk
from statwalk.services.library.load import character_of, character_path
from statwalk.services.library.model_store import ModelStore

MOST_LOADED = 8
"""uploaded characters in memory, besides the characters of machines"""


class CheckedCharacters:
    """Keeps characters by the hash of their model. Thread-safe."""

    def __init__(self) -> None:
        self.loaded: OrderedDict[str, Character] = OrderedDict()
        self.lock = threading.Lock()

    def character(self, store: ModelStore, sha256: str) -> Character:
        """Returns the uploaded character with this model; the hash is the character's name.

        :raises ContentError: when the child has to check the model again, and refuses it.
        """
        with self.lock:
            if sha256 not in self.loaded:
                self.loaded[sha256] = replace(store.character(sha256), name=sha256)
            self.loaded.move_to_end(sha256)
            while len(self.loaded) > MOST_LOADED:
                self.loaded.popitem(last=False)
            return self.loaded[sha256]

    def of_machine(
        self, store: ModelStore | None, file: MachineFile, folder: Path, token: CancelToken = NEVER
    ) -> Character:
        """Returns the character that a machine file in `folder` names, with its captured motions. A child
        process has read what is in the store.

        :raises ContentError: when a file is refused.
        :raises StorageError: when the disk refuses what the child writes.
        :raises CancelledError: when the token is cancelled.
        """
        path = character_path(file)
        if store is None or path.resolve().parent != store.models:
            return character_of(file, folder)
        character = self.character(store, path.stem)
        if not file.captures:
            return character
        with room_on_disk(), store.working() as working:
            return captured(character, file, folder, working, token)
