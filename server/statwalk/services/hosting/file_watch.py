"""`statwalk serve --watch`: a saved machine file is an edit; it is verified, then played on all stages."""

from __future__ import annotations

import logging
from collections.abc import Iterator

from statwalk.errors import StatwalkError
from statwalk.files.machine_yaml.machine_file import FILE_NAME
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.services.hosting.edited_file import saved
from statwalk.services.hosting.machine_versions import MachineVersions

log = logging.getLogger(__name__)
Stamp = tuple[int, ...]
"""of each of a machine's files: its time of modification in nanoseconds, and its size in bytes"""


class FileWatch:
    """Watches the files of all machines whose edits are kept in their files."""

    def __init__(self, versions: MachineVersions) -> None:
        self.versions = versions
        self.stamps = dict(self.files())

    def files(self) -> Iterator[tuple[str, Stamp]]:
        """Yields the machine's name and the stamp of each machine file, with its tables."""
        for name, entry in self.versions.catalogue.entries.items():
            names = (FILE_NAME, *MachineText.of(entry.file.text).tables)
            try:
                stats = [(entry.folder / file).stat() for file in names]
            except OSError:
                continue  # an editor is replacing the file: the next look finds it
            if saved(entry) == "file":
                yield name, tuple(part for stat in stats for part in (stat.st_mtime_ns, stat.st_size))

    def look(self) -> list[str]:
        """Edits the machines whose files were saved since the last look; returns the names of the machines
        that have a new version.

        Logs why a file is refused.
        """
        stamps = dict(self.files())
        changed = [name for name, stamp in stamps.items() if self.stamps.get(name, stamp) != stamp]
        self.stamps = stamps
        return [name for name in changed if self.follow(name)]

    def follow(self, name: str) -> bool:
        """Edits one machine from its file; returns whether the machine has a new version."""
        try:
            edited = self.versions.follow(name)
        except (StatwalkError, OSError) as error:
            log.warning("%s keeps its version: %s", name, error)
            return False
        if edited is None:
            return False
        log.warning("%s is now at version %d", name, edited.version.number)
        for finding in edited.findings:
            if finding.severity != "info":
                log.warning("%s, line %d: %s: %s", name, finding.line, finding.severity, finding.message)
        return True
