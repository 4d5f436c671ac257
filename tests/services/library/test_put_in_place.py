"""A machine's files are replaced together, or not at all."""

import errno
from pathlib import Path

import pytest
from refusing_files import RefusingFiles
from statwalk.errors import StorageError
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.services.library.put_in_place import put_machine_in_place

OLD = MachineText("old", {"a.csv": "1"})
NEW = MachineText("new", {"a.csv": "2", "b.csv": "3"})


def put(folder: Path, text: MachineText) -> None:
    with put_machine_in_place(folder, text):
        pass


def files(folder: Path) -> dict[str, str]:
    return {path.name: path.read_text() for path in folder.iterdir()}


def test_they_are_replaced_and_nothing_else_stays(tmp_path: Path) -> None:
    put(tmp_path, OLD)
    (tmp_path / ".machine-new-a.csv").write_text("of a server that was killed")
    put(tmp_path, NEW)
    assert files(tmp_path) == {"machine.yaml": "new", "a.csv": "2", "b.csv": "3"}


def test_the_permissions_stay(tmp_path: Path) -> None:
    put(tmp_path, OLD)
    (tmp_path / "machine.yaml").chmod(0o640)
    put(tmp_path, NEW)
    assert (tmp_path / "machine.yaml").stat().st_mode & 0o777 == 0o640


@pytest.mark.parametrize("code", [errno.ENOSPC, errno.EIO], ids=errno.errorcode.__getitem__)
def test_all_are_as_they_were_whatever_the_disk_refuses(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, code: int
) -> None:
    put(tmp_path, OLD)
    before, disk = files(tmp_path), RefusingFiles(monkeypatch, tmp_path)
    for nth in range(100):
        disk.refuse(code, nth)
        try:
            put(tmp_path, NEW)
        except StorageError:
            disk.work()
            assert files(tmp_path) == before
        else:
            break
    assert nth > 3


def test_all_are_as_they_were_after_any_error_in_the_context(tmp_path: Path) -> None:
    put(tmp_path, OLD)
    before = files(tmp_path)
    with pytest.raises(KeyError), put_machine_in_place(tmp_path, NEW):
        raise KeyError
    assert files(tmp_path) == before
