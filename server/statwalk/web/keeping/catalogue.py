"""The machines and characters that this server knows, by name; each is loaded when it is first asked for.

Names change their meaning when something is uploaded or deleted, but what a machine is made of does not: the character of a machine
in the data folder is called by its name and the beginning of its hash (`robot.1a2b3c4d`), which means that content for ever.
"""

from __future__ import annotations

import logging
import threading
from collections import OrderedDict
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from statwalk.character import Character
from statwalk.errors import ContentError
from statwalk.files.machinefile import FILE_NAME, MachineFile, load_machine
from statwalk.files.scenefile import FILE_NAME as SCENE_FILE
from statwalk.files.scenefile import load_scene_file
from statwalk.loading import (
    Scene,
    character_path,
    load_character_file,
    load_role,
    shipped_machines,
    shipped_machines_folder,
    shipped_scenes,
)
from statwalk.stage.role import Role
from statwalk.web.keeping.depot import Depot, Kept
from statwalk.web.problem import Problem

DEFAULT_MACHINE = "faq-walker"
MOST_LOADED = 8
"""uploaded characters that are held in memory beside those of machines"""
log = logging.getLogger(__name__)


@dataclass(frozen=True)
class Entry:
    """A machine folder; `character` is the name its character has in the catalogue; `made`: in the data folder, by this API."""

    name: str
    folder: Path
    file: MachineFile
    character: str
    made: bool = False
    scene: str = ""
    """the shipped scene that it belongs to"""


class Catalogue:
    """Machine folders by name: the given ones first, then the shipped ones, then those of the depot. Safe to use from several threads."""

    def __init__(self, folders: Iterable[Path] = (), depot: Depot | None = None) -> None:
        given = [folder.resolve() for folder in folders]
        shipped = [shipped_machines_folder() / name for name in (*shipped_machines(), *shipped_scenes())]
        self.depot = depot
        self.entries: dict[str, Entry] = {}
        self.owners: dict[str, str] = {}
        self.roles: dict[str, Role] = {}
        self.loaded: OrderedDict[str, Character] = OrderedDict()
        self.lock = threading.RLock()
        self.scene_folders: dict[str, Path] = {}
        for folder in (*given, *shipped):
            if (folder / SCENE_FILE).is_file():
                self.enter_scene(folder)
            else:
                self.enter(folder)
        self.default = next(iter(self.entries), None) if given or DEFAULT_MACHINE not in self.entries else DEFAULT_MACHINE
        for folder in depot.machine_folders() if depot else ():
            try:
                self.adopt(folder)
            except ContentError as error:
                log.warning("a machine of the data folder is left out: %s", error)

    def enter(self, folder: Path, scene: str = "") -> None:
        """Reads a folder's machine file; one that belongs to a scene has its name before its own. The first folder of a name counts.

        :raises ContentError: if the file must be refused.
        """
        name = f"{scene}.{folder.name}" if scene else folder.name
        if name in self.entries:
            return
        if not folder.is_dir():
            raise ContentError("there is no such machine folder", file=str(folder))
        file = load_machine(folder)
        self.entries[name] = Entry(name, folder, file, self.character_name(name, character_path(file)), scene=scene)

    def enter_scene(self, folder: Path) -> None:
        """Reads the machine files of a scene's folder. The first folder of a name counts.

        :raises ContentError: if one of the files must be refused.
        """
        if folder.name not in self.scene_folders:
            load_scene_file(folder)
            self.scene_folders[folder.name] = folder
            for path in sorted(folder.glob(f"*/{FILE_NAME}")):
                self.enter(path.parent, folder.name)

    def scene(self, name: str) -> Scene:
        """The scene of that name, with the machines as they are now.

        :raises Problem: 422, if there is none.
        """
        folder = self.scene_folders.get(name)
        if folder is None:
            raise Problem(422, f"there is no scene {name[:80]!r}", field="scene", known=self.scene_folders)
        file = load_scene_file(folder)
        own = [entry.name for entry in self.entries.values() if entry.scene == name]
        lines = [(f"{name}.{line.machine}" if f"{name}.{line.machine}" in own else line.machine, line) for line in file.actors]
        return Scene(name, file.title, file.description, file.seed, tuple((self.role(machine, 422), line) for machine, line in lines))

    def character_name(self, machine: str, path: Path) -> str:
        """The character file's stem; with the machine's name before it where another file has that stem."""
        for name, owner in self.owners.items():
            if character_path(self.entries[owner].file) == path:
                return name
        name = f"{machine}-{path.stem}" if path.stem in self.owners else path.stem
        self.owners[name] = machine
        return name

    def adopt(self, folder: Path, role: Role | None = None) -> None:
        """Reads a machine folder of the depot, whose `role` may be at hand; one that was given or shipped goes before it.

        :raises ContentError: if the file must be refused.
        """
        file = load_machine(folder)
        sha256 = file.character_path.stem
        with self.lock:
            names = [kept.name for kept in self.uploads().values() if kept.sha256 == sha256]
            version = f"{names[0] if names else folder.name}.{sha256[:8]}"
            if folder.name not in self.entries:
                self.entries = self.entries | {folder.name: Entry(folder.name, folder, file, version, made=True)}
                self.roles |= {folder.name: role} if role else {}

    def renew(self, entry: Entry, role: Role) -> None:
        """Another version of a machine that is here, and the role that it makes."""
        with self.lock:
            self.entries = self.entries | {entry.name: entry}
            self.roles = self.roles | {entry.name: role}

    def drop(self, machine: str) -> None:
        """Forgets a machine of the depot."""
        with self.lock:
            self.entries = {name: entry for name, entry in self.entries.items() if name != machine}
            self.roles.pop(machine, None)

    def entry(self, machine: str, status: int = 404) -> Entry:
        """The machine of that name.

        :raises Problem: `status` (404 for a name in a path, 422 in a body), if there is none; it lists those that exist.
        """
        if machine not in self.entries:
            raise Problem(status, f"there is no machine {machine[:80]!r}", field="machine", known=self.entries)
        return self.entries[machine]

    def role(self, machine: str, status: int = 404) -> Role:
        """The machine with its character, ready to run.

        :raises Problem: as `entry`.
        :raises ContentError: if its character must be refused.
        """
        entry = self.entry(machine, status)
        with self.lock:
            if machine not in self.roles:
                self.roles[machine] = load_role(entry.folder, entry.name)
            return self.roles[machine]

    def uploads(self) -> dict[str, Kept]:
        """The uploaded characters by name; one that came with a machine folder goes before one of the same name."""
        found = self.depot.characters() if self.depot else {}
        return {name: kept for name, kept in found.items() if name not in self.owners}

    def character(self, name: str, status: int = 404) -> Character:
        """The character of that name.

        :raises Problem: `status`, if there is none.
        """
        owner = self.owners.get(name) or next((entry.name for entry in self.entries.values() if entry.character == name), None)
        if owner is not None:
            return self.role(owner).character
        kept = self.uploads().get(name)
        if kept is None or self.depot is None:
            raise Problem(status, f"there is no character {name[:80]!r}", field="character", known=[*self.owners, *self.uploads()])
        return self.load(kept.sha256, self.depot.model(kept.sha256))

    def load(self, sha256: str, model: Path) -> Character:
        """The character of some content; the last few are remembered."""
        with self.lock:
            if sha256 not in self.loaded:
                self.loaded[sha256] = load_character_file(model)
            self.loaded.move_to_end(sha256)
            while len(self.loaded) > MOST_LOADED:
                self.loaded.popitem(last=False)
            return self.loaded[sha256]

    def character_of(self, role: Role) -> str:
        """The catalogue's name for a role's character; a machine that was deleted meanwhile answers for it."""
        entry = self.entries.get(role.name)
        return entry.character if entry else role.name
