"""Machines as they are edited while stages play them: each edit verified first, kept as a version, and undone by one more."""

from __future__ import annotations

import os
import shutil
import tempfile
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any, Literal

from statwalk.errors import ContentError, StageError
from statwalk.files.machinefile import FILE_NAME, MachineFile, machine_of
from statwalk.loading import shipped_machines_folder
from statwalk.machine.built.build import MotionFacts
from statwalk.machine.checking.findings import Finding
from statwalk.machine.checking.verify import verify
from statwalk.stage.role import Role
from statwalk.web.keeping.catalogue import Catalogue, Entry
from statwalk.web.keeping.hosted import HostedStage
from statwalk.web.problem import Problem

MOST_EDITIONS = 200
Saved = Literal["file", "memory"]


@dataclass(frozen=True)
class Edition:
    """A version of a machine; `at` in seconds since 1970, `what` in a few words."""

    version: int
    at: float
    what: str
    text: str
    before: int = 0
    """the version that an undo leads to; 0: none"""


@dataclass(frozen=True)
class Edited:
    """What an edit is, or would be."""

    edition: Edition
    file: MachineFile
    role: Role
    findings: list[Finding]


class RefusedEdit(Problem):
    """422: the verifier finds what was not wrong before."""

    def __init__(self, findings: list[Finding]) -> None:
        super().__init__(422, f"the table is refused: {findings[0].message}", field=f"line {findings[0].line}")
        self.findings = findings

    def body(self) -> dict[str, Any]:
        """The problem, with the findings."""
        return super().body() | {"findings": [asdict(finding) for finding in self.findings]}


class Editions:
    """The versions of all machines. Safe to use from several threads."""

    def __init__(self, catalogue: Catalogue, stages: Callable[[], list[HostedStage]]) -> None:
        self.catalogue, self.stages = catalogue, stages
        self.lock = threading.RLock()
        self.kept: dict[str, list[Edition]] = {}

    def of(self, name: str) -> list[Edition]:
        """The versions that are remembered, the newest last.

        :raises Problem: 404, if there is no such machine.
        """
        entry = self.catalogue.entry(name)
        with self.lock:
            return list(self.kept.setdefault(name, [Edition(1, time.time(), "as it was read", entry.file.text)]))

    @contextmanager
    def based_on(self, name: str, version: int) -> Iterator[Edition]:
        """The newest version, for one editor at a time.

        :raises Problem: 412, if it is another than `version`: somebody else has changed the machine meanwhile.
        """
        with self.lock:
            newest = self.of(name)[-1]
            if version != newest.version:
                raise Problem(412, f"{name} is at version {newest.version} by now ({newest.what}), not {version}", field="If-Match")
            yield newest

    def checked(self, name: str, text: str, what: str, before: int | None = None) -> Edited:
        """What the text would be as the next version; `before`: where an undo of it leads, if not to the newest now.

        :raises ContentError: if it cannot be read.
        :raises RefusedEdit: if the verifier finds errors that were not there before.
        """
        entry, role = self.catalogue.entry(name), self.catalogue.role(name)
        file = machine_of(text, entry.folder, FILE_NAME)
        if file.character_path != entry.file.character_path:
            raise Problem(422, "an edit keeps the character; make another machine for another one", field="character")
        file.check_root(role.character.skeleton.names)
        new = Role.build(role.name, role.character, file.definition, file.root_joint)
        findings = findings_of(file, new)
        if errors := errors_in(findings):
            known = {one.about for one in errors_in(findings_of(entry.file, role))}
            errors = [one for one in errors if one.about not in known]
        if errors:
            raise RefusedEdit(errors)
        newest = self.of(name)[-1].version
        edition = Edition(newest + 1, time.time(), what, text, newest if before is None else before)
        return Edited(edition, file, new, findings)

    def change(self, name: str, text: str, what: str, *, write: bool = True, before: int | None = None) -> Edited:
        """Makes the text the newest version, in its file (`write`) and on all stages that play it and are not in their past."""
        with self.lock:
            edited = self.checked(name, text, what, before)
            entry = self.catalogue.entry(name)
            if write and saved(entry) == "file":
                put_in_place(entry.folder / FILE_NAME, text)
            self.catalogue.renew(replace(entry, file=edited.file), edited.role)
            self.kept[name] = [*self.of(name), edited.edition][-MOST_EDITIONS:]
            self.play(edited.role, text)
            return edited

    def play(self, role: Role, text: str) -> None:
        """Puts the version on the stages that play the machine. One in its past, or with other joints, keeps its own."""
        for hosted in self.stages():
            with hosted.turn() as stage:
                if role.name in stage.roles and stage.tick == stage.head:
                    try:
                        hosted.edit(role, text)
                    except StageError:
                        continue

    def undo(self, name: str) -> Edited:
        """The version before the newest, as one more; undone again, it goes back further.

        :raises Problem: 409, if there is none.
        """
        with self.lock:
            editions = self.of(name)
            back = next((one for one in editions if one.version == editions[-1].before), None)
            if back is None:
                raise Problem(409, f"there is nothing to undo in {name}")
            return self.change(name, back.text, f"back to version {back.version}", before=back.before)

    def follow(self, name: str) -> Edited | None:
        """The file as it is now as the newest version; None where it says what it said.

        :raises ContentError: if it is refused; the machine stays as it is.
        """
        entry = self.catalogue.entry(name)
        text = (entry.folder / FILE_NAME).read_text(encoding="utf-8", errors="replace")
        if text == entry.file.text:
            return None
        return self.change(name, text, "the file was saved", write=False)


def findings_of(file: MachineFile, role: Role) -> list[Finding]:
    """What the verifier finds."""
    motions = {clip.name: MotionFacts(clip.duration, clip.loop, clip.markers) for clip in role.character.clips.values()}
    return verify(file.definition, motions)


def errors_in(findings: list[Finding]) -> list[Finding]:
    """Those that make a machine something else than its author meant."""
    return [one for one in findings if one.severity == "error"]


def saved(entry: Entry) -> Saved:
    """Where an edit of the machine is kept: in its file, or, for what came with statwalk, until the server stops."""
    return "memory" if entry.folder.is_relative_to(shipped_machines_folder()) else "file"


def put_in_place(path: Path, text: str) -> None:
    """Writes the file whole or not at all; who may read it stays as it was.

    :raises ContentError: if it cannot be written.
    """
    try:
        with tempfile.NamedTemporaryFile("w", dir=path.parent, prefix=".machine-", delete=False, encoding="utf-8", newline="") as file:
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
        if path.exists():
            shutil.copymode(path, file.name)
        Path(file.name).replace(path)
    except OSError as error:
        raise ContentError(f"the file cannot be written: {error.strerror}", file=str(path)) from None
