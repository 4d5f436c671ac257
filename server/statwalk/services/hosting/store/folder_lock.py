"""The lock of the data folder: one server at a time uses it. The kernel holds the lock, so that a killed
server leaves none behind.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path

from statwalk.errors import ConflictError

FILE_NAME = "lock"


class FolderLock:
    """The lock of one folder, from now until `release` or the end of the process."""

    def __init__(self, folder: Path) -> None:
        """Takes the lock; makes the folder if there is none.

        :raises ConflictError: when another process holds the lock; the error names the process.
        """
        folder.mkdir(parents=True, exist_ok=True)
        self._descriptor = os.open(folder / FILE_NAME, os.O_RDWR | os.O_CREAT, 0o600)
        if not _is_taken(self._descriptor):
            holder = os.pread(self._descriptor, 20, 0).decode("ascii", "replace").strip()
            os.close(self._descriptor)
            raise ConflictError(
                f"{f'process {holder}' if holder else 'another process'} uses the data folder {folder} "
                "already; stop it, or name another folder with --data"
            )
        os.ftruncate(self._descriptor, 0)
        os.pwrite(self._descriptor, f"{os.getpid()}\n".encode(), 0)

    def release(self) -> None:
        """Gives the lock back."""
        os.close(self._descriptor)


def _is_taken(descriptor: int) -> bool:
    """Takes the lock of an open file, unless another process has it; returns whether it is taken now."""
    if sys.platform == "win32":
        return True  # SQLite's own locks remain there
    import fcntl

    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        return False
    return True
