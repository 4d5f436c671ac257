"""A disk that refuses the nth change below a folder, as this process asks for it; the database has its own
(`commanded_disk`, and `strace` in `disk_faults`).
"""

import errno
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

CHANGES = "mkdir", "rename", "replace", "unlink", "fsync"
TAKES_ROOM = "mkdir", "open", "fsync"
"""the changes that a full disk refuses; a broken one refuses any"""
NEVER = -1


class RefusingFiles:
    """Counts changes of files below `folder`; the `code` says how the disk refuses: `ENOSPC` every change
    that takes room from the nth on, `EIO` the nth change alone.
    """

    def __init__(self, monkeypatch: pytest.MonkeyPatch, folder: Path) -> None:
        self.folder, self.code, self.left, self.refused = str(folder), errno.EIO, NEVER, 0
        for name in CHANGES:
            monkeypatch.setattr(os, name, self._checked(name, getattr(os, name)))
        monkeypatch.setattr("io.open", self._opened(open))

    def refuse(self, code: int, nth: int) -> None:
        """Begins to refuse with the nth change from now on, 0 the first."""
        self.code, self.left, self.refused = code, nth, 0

    def work(self) -> None:
        """Refuses nothing any more."""
        self.left = NEVER

    def _checked(self, name: str, call: Callable[..., Any]) -> Callable[..., Any]:
        def checked(path: Any, *arguments: Any, **options: Any) -> Any:
            at = os.readlink(f"/proc/self/fd/{path}") if isinstance(path, int) else os.fspath(path)
            self._count(name, str(at))
            return call(path, *arguments, **options)

        return checked

    def _opened(self, call: Callable[..., Any]) -> Callable[..., Any]:
        def opened(path: Any, mode: str = "r", *arguments: Any, **options: Any) -> Any:
            if set(mode) & set("wxa+") and not isinstance(path, int):
                self._count("open", os.fspath(path))
            return call(path, mode, *arguments, **options)

        return opened

    def _count(self, name: str, path: str) -> None:
        is_full = self.code == errno.ENOSPC
        if self.left == NEVER or not path.startswith(self.folder) or (is_full and name not in TAKES_ROOM):
            return
        if self.left > 0:
            self.left -= 1
            return
        self.refused += 1
        if not is_full:
            self.left = NEVER
        raise OSError(self.code, os.strerror(self.code), path)
