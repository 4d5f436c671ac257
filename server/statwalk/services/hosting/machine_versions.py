"""Edits machines while stages play them. Each edit is verified first and becomes a version; an undo is one
more version.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterable
from contextlib import nullcontext
from dataclasses import dataclass, replace
from typing import NamedTuple

from statwalk.character.role import Role
from statwalk.errors import RefusedEditError, VersionConflictError, existing
from statwalk.files.machine_yaml.machine_file import FILE_NAME, MachineFile, load_machine, machine_of
from statwalk.machine.lint.findings import Finding
from statwalk.services.cancel import NEVER, CancelToken
from statwalk.services.hosting.edit_keys import EditKey, EditKeys
from statwalk.services.hosting.edited_file import written
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.hosting.stage_messages import Edit
from statwalk.services.hosting.store.records import MachineVersion
from statwalk.services.hosting.store.store import Store
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.library.entry import Entry
from statwalk.services.library.measuring import findings_of

MOST_VERSIONS = 200


@dataclass(frozen=True)
class Edited:
    """The result of an edit, or of a dry run."""

    version: MachineVersion
    file: MachineFile
    role: Role
    findings: list[Finding]


class Step(NamedTuple):
    """The versions that an undo and a redo bring back; 0: there is none."""

    before: int
    after: int


class CurrentMachine(NamedTuple):
    """A machine with its newest version."""

    entry: Entry
    role: Role
    version: MachineVersion


class MachineVersions:
    """The versions of all machines. Thread-safe."""

    def __init__(
        self, catalogue: Catalogue, stages: Callable[[], list[StageHost]], store: Store | None = None
    ) -> None:
        self.catalogue, self.stages, self.store = catalogue, stages, store
        self.keys = EditKeys(store)
        self.lock = threading.RLock()
        """held only to read or replace the entry, the role and the versions of a machine together"""
        self.storing = threading.Lock()
        """held by the one edit that is written to its file and to the stages"""
        self.versions_of: dict[str, list[MachineVersion]] = {}

    def of(self, name: str) -> list[MachineVersion]:
        """Returns the newest versions of a machine, at most `MOST_VERSIONS`, oldest first.

        :raises UnknownNameError: when no machine has this name.
        """
        entry = self.catalogue.entry(name)
        with self.lock:
            return list(
                self.versions_of.setdefault(
                    name, [MachineVersion(1, time.time(), "as it was read", entry.file.text)]
                )
            )

    def current(self, name: str) -> CurrentMachine:
        """Returns a machine with its newest version. Does not wait for edits.

        :raises UnknownNameError: when no machine has this name.
        """
        self.catalogue.role(name)  # reads the character, if needed, before the lock is taken
        with self.lock:
            return CurrentMachine(self.catalogue.entry(name), self.catalogue.role(name), self.of(name)[-1])

    def version(self, name: str, number: int) -> MachineVersion:
        """Returns a version of a machine.

        :raises UnknownNameError: when no machine has this name, or the version is not kept.
        """
        versions = {str(version.number): version for version in self.of(name)}
        return existing("version", str(number), versions)

    def based_on(self, name: str, number: int) -> CurrentMachine:
        """Returns a machine with its newest version, if that is version `number`.

        :raises VersionConflictError: when the newest version is not `number`: another editor has changed the
            machine meanwhile.
        """
        current = self.current(name)
        newest = current.version
        if number != newest.number:
            raise VersionConflictError(
                f"{name} is at version {newest.number} now ({newest.what}), not {number}; read it again",
                field="version",
            )
        return current

    def checked(
        self,
        current: CurrentMachine,
        text: str,
        what: str,
        step: Step | None = None,
        author: str = "",
        token: CancelToken = NEVER,
    ) -> Edited:
        """Returns the edit that would replace `current` by the text, without making it. Holds no lock.

        `step`: what undo and redo bring back after the edit; None means `current`, and nothing.
        `token` cancels the verification.

        :raises ContentError: when the text cannot be read.
        :raises RefusedEditError: when the text names another character, or the verifier finds errors that the
            machine does not have now.
        """
        entry, role, version = current
        file = machine_of(text, entry.folder, FILE_NAME)
        if file.character_path != entry.file.character_path:
            raise RefusedEditError(
                "an edit cannot change the character; make a new machine for another character",
                field="character",
            )
        file.check_root(role.character.skeleton.names)
        token.check()
        new = Role.build(role.name, role.character, file.definition, file.root_joint, before=role)
        findings = list(findings_of(new, token=token))
        if errors := _errors_in(findings):
            earlier = {finding.about for finding in _errors_in(findings_of(role, token=token))}
            errors = [finding for finding in errors if finding.about not in earlier]
        if errors:
            raise RefusedEditError(
                f"the table is refused: {errors[0].message}", field=f"line {errors[0].line}", findings=errors
            )
        if file.text == version.text and step is None:
            return Edited(version, file, new, findings)
        before, after = step or Step(version.number, 0)
        number, at = version.number + 1, time.time()
        return Edited(MachineVersion(number, at, what, file.text, before, after, author), file, new, findings)

    def change(
        self,
        current: CurrentMachine,
        text: str,
        what: str,
        *,
        write: bool = True,
        step: Step | None = None,
        author: str = "",
        token: CancelToken = NEVER,
        key: EditKey | None = None,
    ) -> Edited:
        """Makes the text the newest version: in the machine's file (`write`), and on every stage that plays
        the machine and whose playhead is at its newest tick. The same text makes no version.

        :raises ContentError: when the text cannot be read.
        :raises StorageError: when the file cannot be written, or the version cannot be kept.
        :raises RefusedEditError: when `checked` refuses the text.
        :raises VersionConflictError: when another edit is made while this one is verified.
        """
        edited, name = self.checked(current, text, what, step, author, token), current.entry.name
        with self.storing:
            entry = self.based_on(name, current.version.number).entry
            self.check_storage()
            self.keys.keep(name, key, edited.version)
            if edited.version is current.version:
                return edited
            versions = [*self.of(name), edited.version]
            with written(entry, edited.version) if write else nullcontext():
                self.keep(name, versions)
            with self.lock:
                self.catalogue.renew(replace(entry, file=edited.file), edited.role)
                self.versions_of[name] = versions[-MOST_VERSIONS:]
            for host in self.stages():
                host.look(Edit(name, edited.version.text))
        return edited

    def check_storage(self) -> None:
        """:raises StorageError: when the disk refuses to keep what changes."""
        if self.store:
            self.store.check()

    def keep(self, name: str, versions: list[MachineVersion]) -> None:
        """Keeps the newest of the versions of a machine in the store, if there is one.

        :raises StorageError: when the disk refuses.
        """
        if self.store:
            # the first version is kept with the first edit
            new = versions if len(versions) == 2 else versions[-1:]
            self.store.keep_versions(name, new, versions[-1].number - MOST_VERSIONS)

    def forget(self, name: str) -> None:
        """Forgets the versions of a machine that is deleted.

        :raises StorageError: when the disk refuses.
        """
        with self.lock:
            self.versions_of.pop(name, None)
        if self.store:
            self.store.forget_versions(name)

    def copy(self, name: str, new: str) -> None:
        """Keeps the versions of a machine for another name too; :raises StorageError: if the disk refuses."""
        if self.store and (kept := self.versions_of.get(name)):
            self.store.copy_versions(new, kept)

    def rename(self, name: str, new: str) -> None:
        """Has a machine that got another name keep its versions, of which `copy` made a copy."""
        with self.lock:
            if kept := self.versions_of.pop(name, None):
                self.versions_of[new] = kept
        if self.store:
            self.store.drop_versions(name)

    def follow(self, name: str) -> Edited | None:
        """Makes the text of the machine's file the newest version; returns None if the text is unchanged.

        :raises ContentError: when the text is refused; the machine keeps its version.
        """
        current = self.current(name)
        text = load_machine(current.entry.folder).text
        if text == current.entry.file.text:
            return None
        return self.change(current, text, "the file was saved", write=False)


def _errors_in(findings: Iterable[Finding]) -> list[Finding]:
    return [finding for finding in findings if finding.severity == "error"]
