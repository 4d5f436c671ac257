"""Keeps the last used characters of the data folder in memory, as the child process has checked them."""

from __future__ import annotations

import threading
from collections import OrderedDict
from dataclasses import replace
from pathlib import Path

from statwalk.character.character import Character
from statwalk.files.character_file import load_character_file
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

    def character_at(self, store: ModelStore | None, path: Path) -> Character:
        """Returns the character that a machine file names: from the store if `path` is in it,
        else from `path`.

        :raises ContentError: when the character is refused.
        """
        if store is not None and path.resolve().parent == store.models:
            return self.character(store, path.stem)
        return load_character_file(path)
