"""One process has a folder; the kernel knows when it ends."""

import subprocess
import sys
from pathlib import Path

import pytest
from statwalk.errors import ConflictError
from statwalk.services.hosting.store.folder_lock import FolderLock

HOLDS = """
import sys
from pathlib import Path
from statwalk.services.hosting.store.folder_lock import FolderLock
lock = FolderLock(Path(sys.argv[1]))
print("has it", flush=True)
sys.stdin.read()
"""


def test_another_process_is_named_until_it_ends(tmp_path: Path) -> None:
    command = [sys.executable, "-c", HOLDS, str(tmp_path)]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as other:
        assert other.stdout is not None
        assert other.stdout.readline() == "has it\n"
        with pytest.raises(ConflictError, match=f"process {other.pid} uses the data folder"):
            FolderLock(tmp_path)
        other.kill()
        other.wait()
        FolderLock(tmp_path).release()


def test_a_lock_that_is_given_back_can_be_taken(tmp_path: Path) -> None:
    FolderLock(tmp_path).release()
    FolderLock(tmp_path).release()
