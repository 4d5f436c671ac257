"""`statwalk serve --watch`: a machine file that was saved is an edit like any other: verified first, then in force on all stages."""

from __future__ import annotations

import logging
from collections.abc import Iterator

from statwalk.errors import StatwalkError
from statwalk.files.machinefile import FILE_NAME
from statwalk.web.keeping.editions import Editions, saved
from statwalk.web.problem import Problem

log = logging.getLogger(__name__)
Stamp = tuple[int, int]


class Watch:
    """The files of the machines that may be edited, and when each was saved last."""

    def __init__(self, editions: Editions) -> None:
        self.editions = editions
        self.stamps = dict(self.files())

    def files(self) -> Iterator[tuple[str, Stamp]]:
        """Name and stamp of each file that is there."""
        for name, entry in self.editions.catalogue.entries.items():
            try:
                stat = (entry.folder / FILE_NAME).stat()
            except OSError:
                continue  # a file that is being replaced is there again the next time
            if saved(entry) == "file":
                yield name, (stat.st_mtime_ns, stat.st_size)

    def look(self) -> list[str]:
        """Follows what was saved since the last look; the names of the machines that are another version now. What is refused is said."""
        now = dict(self.files())
        changed = [name for name, stamp in now.items() if self.stamps.get(name, stamp) != stamp]
        self.stamps = now
        return [name for name in changed if self.follow(name)]

    def follow(self, name: str) -> bool:
        """One file; whether it made another version."""
        try:
            edited = self.editions.follow(name)
        except (StatwalkError, Problem, OSError) as error:
            log.warning("%s stays as it is: %s", name, error.detail if isinstance(error, Problem) else error)
            return False
        if edited is None:
            return False
        log.warning("%s is at version %d now", name, edited.edition.version)
        for finding in edited.findings:
            if finding.severity != "info":
                log.warning("%s, line %d: %s: %s", name, finding.line, finding.severity, finding.message)
        return True
