"""What stands for a role in a message to a worker. A role has many megabytes: the worker loads it itself."""

from __future__ import annotations

import hashlib
from functools import lru_cache
from pathlib import Path
from typing import Any
from weakref import WeakKeyDictionary

from statwalk.character.character import Character
from statwalk.character.role import Role
from statwalk.errors import ContentError
from statwalk.files.machine_yaml.capture_lines import CaptureLine
from statwalk.files.machine_yaml.machine_file import FILE_NAME, MachineFile, machine_of
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.library.checked_characters import CheckedCharacters
from statwalk.services.library.model_store import ModelStore
from statwalk.services.work.messages import StandIn

MOST_ROLES, MOST_CHARACTERS = 8, 4
"""that a worker keeps"""


_digests: WeakKeyDictionary[Character, bytes] = WeakKeyDictionary()
_characters: dict[tuple[Path, tuple[CaptureLine, ...]], Character] = {}
"""in a worker: the last ones, by model and captures"""


def model_digest(role: Role) -> bytes:
    """Returns a hash of the model that a role plays: with another model it would be another motion."""
    character = role.character
    if character not in _digests:
        _digests[character] = hashlib.sha256(character.model_glb).digest()
    return _digests[character]


def reference_to(catalogue: Catalogue, value: Any) -> StandIn | None:
    """Returns what stands for a role of the catalogue; None for anything else.

    :raises UnknownNameError: when the machine is not there any more.
    """
    if not isinstance(value, Role):
        return None
    folder, data = catalogue.entry(value.name).folder, catalogue.store and catalogue.store.folder
    return StandIn(loaded_role, (value.name, folder, catalogue.texts[value], data, model_digest(value).hex()))


@lru_cache(MOST_ROLES)
def loaded_role(name: str, folder: Path, text: str, data: Path | None, digest: str) -> Role:
    """Loads a role in a worker; remembers the last ones.

    :raises ContentError: when the files of the machine are not what they were when the server read them.
    """
    file = machine_of(text, folder, FILE_NAME)
    role = Role.build(name, _character(file, folder, data), file.definition, file.root_joint)
    if model_digest(role).hex() != digest:
        _characters.clear()
        raise ContentError("its model is not the one that the server has read", file=name)
    return role


def _character(file: MachineFile, folder: Path, data: Path | None) -> Character:
    """Loads a character, or returns it again; `data`: the data folder."""
    key = file.character_path, file.captures
    if key not in _characters:
        store = ModelStore(data) if data else None
        _characters[key] = CheckedCharacters().of_machine(store, file, folder)
        for oldest in list(_characters)[:-MOST_CHARACTERS]:
            del _characters[oldest]
    return _characters[key]
