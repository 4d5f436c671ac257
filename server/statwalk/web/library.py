"""The machines and characters that this server knows, by name; each is loaded when it is first asked for."""

from __future__ import annotations

import threading
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from statwalk.character import Character
from statwalk.errors import ContentError
from statwalk.files.machinefile import MachineFile, load_machine
from statwalk.loading import load_role, shipped_machines, shipped_machines_folder
from statwalk.stage.role import Role
from statwalk.web.problem import Problem

DEFAULT_MACHINE = "faq-walker"


@dataclass(frozen=True)
class Entry:
    """A machine folder; `character` is the name its character has in the library."""

    name: str
    folder: Path
    file: MachineFile
    character: str


class Library:
    """Machine folders by name: the given ones first, then the shipped ones. Safe to use from several threads."""

    def __init__(self, folders: Iterable[Path] = ()) -> None:
        given = [folder.resolve() for folder in folders]
        shipped = [shipped_machines_folder() / name for name in shipped_machines()]
        self.entries: dict[str, Entry] = {}
        self.owners: dict[str, str] = {}
        self.roles: dict[str, Role] = {}
        self.lock = threading.RLock()
        for folder in (*given, *shipped):
            self.enter(folder)
        self.default = next(iter(self.entries), None) if given or DEFAULT_MACHINE not in self.entries else DEFAULT_MACHINE

    def enter(self, folder: Path) -> None:
        """Reads a folder's machine file. The first folder of a name counts.

        :raises ContentError: if the file must be refused.
        """
        if folder.name in self.entries:
            return
        if not folder.is_dir():
            raise ContentError("there is no such machine folder", file=str(folder))
        file = load_machine(folder)
        self.entries[folder.name] = Entry(folder.name, folder, file, self.character_name(folder.name, file.character_path))

    def character_name(self, machine: str, path: Path) -> str:
        """The character file's stem; with the machine's name before it where another file has that stem."""
        for name, owner in self.owners.items():
            if self.entries[owner].file.character_path == path:
                return name
        name = f"{machine}-{path.stem}" if path.stem in self.owners else path.stem
        self.owners[name] = machine
        return name

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
                self.roles[machine] = load_role(entry.folder)
            return self.roles[machine]

    def character(self, name: str) -> Character:
        """The character of that name.

        :raises Problem: 404, if there is none.
        """
        if name not in self.owners:
            raise Problem(404, f"there is no character {name[:80]!r}", field="character", known=self.owners)
        return self.role(self.owners[name]).character

    def character_of(self, role: Role) -> str:
        """The library's name for a role's character."""
        return self.entries[role.name].character
