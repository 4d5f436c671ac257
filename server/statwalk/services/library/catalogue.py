"""The machines and characters of the server, by name; each is loaded on first use.

An upload may give a character's name another model. A machine in the data folder keeps its model, so the name
of its character holds the first digits of the model's hash: `robot.1a2b3c4d` is the same model for ever.
"""

from __future__ import annotations

import logging
import threading
from collections.abc import Iterable
from functools import partial
from pathlib import Path
from weakref import WeakKeyDictionary

from statwalk.character.character import Character
from statwalk.character.role import Role
from statwalk.errors import ContentError, UnknownNameError
from statwalk.files.machine_yaml.machine_file import FILE_NAME, load_machine, machine_of
from statwalk.files.scene import FILE_NAME as SCENE_FILE
from statwalk.files.scene import load_scene_file
from statwalk.services.library.checked_characters import CheckedCharacters
from statwalk.services.library.entry import Entry
from statwalk.services.library.load import (
    character_path,
    load_role,
    shipped_machines,
    shipped_machines_folder,
)
from statwalk.services.library.load_scene import Scene, shipped_scenes
from statwalk.services.library.model_store import ModelStore, UploadedCharacter

DEFAULT_MACHINE = "faq-walker"
log = logging.getLogger(__name__)


class Catalogue:
    """Finds machines by name: in `folders`, then in the shipped folders, then in the store. Thread-safe."""

    def __init__(self, folders: Iterable[Path] = (), store: ModelStore | None = None) -> None:
        user_folders = [folder.resolve() for folder in folders]
        shipped = [shipped_machines_folder() / name for name in (*shipped_machines(), *shipped_scenes())]
        self.store = store
        self.entries: dict[str, Entry] = {}
        self.owners: dict[str, str] = {}
        self.roles: dict[str, Role] = {}
        self.texts: WeakKeyDictionary[Role, str] = WeakKeyDictionary()
        """the machine file's text of every role"""
        self.checked = CheckedCharacters()
        self.lock = threading.RLock()
        self.scene_folders: dict[str, Path] = {}
        for folder in (*user_folders, *shipped):
            if (folder / SCENE_FILE).is_file():
                self._enter_scene(folder)
            else:
                self.enter(folder)
        self.default = (
            next(iter(self.entries), None)
            if user_folders or DEFAULT_MACHINE not in self.entries
            else DEFAULT_MACHINE
        )
        for folder in store.machine_folders() if store else ():
            try:
                self.adopt(folder)
            except ContentError as error:
                log.warning("a machine of the data folder is skipped: %s", error)

    def enter(self, folder: Path, scene: str = "") -> None:
        """Adds the machine of a folder; a machine of a scene is called SCENE.MACHINE.

        Does nothing if a machine has this name already.

        :raises ContentError: when the machine file is refused.
        """
        name = f"{scene}.{folder.name}" if scene else folder.name
        if name in self.entries:
            return
        if not folder.is_dir():
            raise ContentError("this is no folder; name a folder with a machine.yaml", file=str(folder))
        file = load_machine(folder)
        self.entries[name] = Entry(
            name, folder, file, self.character_name(name, character_path(file)), scene=scene
        )

    def _enter_scene(self, folder: Path) -> None:
        """Adds a scene and the machines in its folder; does nothing if a scene has this name already.

        :raises ContentError: when a file is refused.
        """
        if folder.name not in self.scene_folders:
            load_scene_file(folder)
            self.scene_folders[folder.name] = folder
            for path in sorted(folder.glob(f"*/{FILE_NAME}")):
                self.enter(path.parent, folder.name)

    def scene(self, name: str) -> Scene:
        """Returns the scene with this name, with the newest versions of its machines.

        :raises UnknownNameError: when no scene has this name.
        """
        folder = self.scene_folders.get(name)
        if folder is None:
            raise UnknownNameError("scene", name, self.scene_folders)
        file = load_scene_file(folder)
        own = [entry.name for entry in self.entries.values() if entry.scene == name]
        lines = [
            (f"{name}.{line.machine}" if f"{name}.{line.machine}" in own else line.machine, line)
            for line in file.actors
        ]
        return Scene(
            name,
            file.title,
            file.description,
            file.seed,
            tuple((self.role(machine), line) for machine, line in lines),
        )

    def character_name(self, machine: str, path: Path) -> str:
        """Returns the stem of a character file, after the machine's name if another file has this stem."""
        for name, owner in self.owners.items():
            if character_path(self.entries[owner].file) == path:
                return name
        name = f"{machine}-{path.stem}" if path.stem in self.owners else path.stem
        self.owners[name] = machine
        return name

    def adopt(self, folder: Path, role: Role | None = None) -> None:
        """Adds a machine folder of the store; does nothing if a machine has this name already.

        `role`: the machine's role, if it is built already.

        :raises ContentError: when the machine file is refused.
        """
        file = load_machine(folder)
        sha256 = file.character_path.stem
        with self.lock:
            names = [upload.name for upload in self.uploads().values() if upload.sha256 == sha256]
            version = f"{names[0] if names else folder.name}.{sha256[:8]}"
            if folder.name not in self.entries:
                self.entries = self.entries | {
                    folder.name: Entry(folder.name, folder, file, version, made=True)
                }
                if role:
                    self.roles[folder.name], self.texts[role] = role, file.text

    def renew(self, entry: Entry, role: Role) -> None:
        """Replaces a machine by another version of it."""
        with self.lock:
            self.entries = self.entries | {entry.name: entry}
            self.roles = self.roles | {entry.name: role}
            self.texts[role] = entry.file.text

    def drop(self, machine: str) -> None:
        """Removes a machine of the store."""
        with self.lock:
            self.entries = {name: entry for name, entry in self.entries.items() if name != machine}
            self.roles.pop(machine, None)

    def entry(self, machine: str) -> Entry:
        """Returns the entry of the machine with this name.

        :raises UnknownNameError: when no machine has this name; the error lists the names of all machines.
        """
        if machine not in self.entries:
            raise UnknownNameError("machine", machine, self.entries)
        return self.entries[machine]

    def can_load(self, role: Role) -> bool:
        """Whether a worker can load a role from its machine's files: not after the machine was deleted."""
        return role.name in self.entries and role in self.texts

    def role(self, machine: str) -> Role:
        """Returns the role of a machine: the compiled machine with its character.

        :raises UnknownNameError: when no machine has this name.
        :raises ContentError: when the machine or its character is refused.
        """
        entry = self.entry(machine)
        with self.lock:
            if machine not in self.roles:
                text = entry.file.text
                role = load_role(entry.folder, entry.name, text, partial(self.checked.of_machine, self.store))
                self.roles[machine], self.texts[role] = role, text
            return self.roles[machine]

    def version(self, machine: str, text: str) -> Role:
        """Returns the role of a machine with `text` in place of its machine file.

        :raises UnknownNameError: when no machine has this name.
        :raises ContentError: when the text is refused.
        """
        entry, role = self.entry(machine), self.role(machine)
        if entry.file.text == text:
            return role
        file = machine_of(text, entry.folder, FILE_NAME)
        if file.captures != entry.file.captures:
            role = load_role(entry.folder, machine, text, partial(self.checked.of_machine, self.store))
        else:
            file.check_root(role.character.skeleton.names)
            role = Role.build(role.name, role.character, file.definition, file.root_joint)
        self.texts[role] = text
        return role

    def uploads(self) -> dict[str, UploadedCharacter]:
        """Returns the uploaded characters by name, without names that a machine folder's character has."""
        uploads = self.store.characters() if self.store else {}
        return {name: upload for name, upload in uploads.items() if name not in self.owners}

    def character(self, name: str) -> Character:
        """Returns the character with this name.

        :raises UnknownNameError: when no character has this name.
        """
        owner = self._owner(name)
        if owner is not None:
            return self.role(owner).character
        return self.checked.character(self._store_with(name), self.uploads()[name].sha256)

    def model_glb(self, name: str) -> bytes:
        """Returns the model of a character as a .glb, without loading an uploaded character.

        :raises UnknownNameError: when no character has this name.
        """
        owner = self._owner(name)
        if owner is not None:
            return self.role(owner).character.model_glb
        return self._store_with(name).read_model(self.uploads()[name].sha256)

    def _owner(self, name: str) -> str | None:
        """Returns the machine in whose folder the character is, or the first machine made from it."""
        machines = (entry.name for entry in self.entries.values() if entry.character == name)
        return self.owners.get(name) or next(machines, None)

    def _store_with(self, name: str) -> ModelStore:
        """Returns the store.

        :raises UnknownNameError: when the store has no uploaded character with this name.
        """
        if self.store is None or name not in self.uploads():
            raise UnknownNameError("character", name, [*self.owners, *self.uploads()])
        return self.store

    def character_of(self, role: Role) -> str:
        """Returns the catalogue's name for a role's character; for a deleted machine, the machine's name."""
        entry = self.entries.get(role.name)
        return entry.character if entry else role.name
