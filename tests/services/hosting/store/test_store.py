"""What a disk refuses does not come when it takes writes again."""

from pathlib import Path

import pytest
from commanded_disk import CommandedDisk
from serving import wait_for
from statwalk.errors import StorageError
from statwalk.services.hosting.store.records import MachineVersion
from statwalk.services.library.catalogue import Catalogue

FIRST = MachineVersion(1, 0.0, "", "a")
SECOND = MachineVersion(2, 0.0, "", "b")


def test_a_version_that_was_refused_is_forgotten(tmp_path: Path) -> None:
    disk = CommandedDisk(tmp_path, Catalogue())
    try:
        disk.store.keep_versions("door", [FIRST], 0)
        disk.refuses = True
        with pytest.raises(StorageError):
            disk.store.keep_versions("door", [SECOND], 0)
        disk.refuses = False
        wait_for(lambda: disk.store.writer.trouble is None)
        disk.store.check()
        assert disk.store.records.versions() == {"door": [FIRST]}
    finally:
        disk.store.close()
