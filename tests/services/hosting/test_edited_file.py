"""The file of an edited machine holds the old text again, if the store refuses the new one."""

from pathlib import Path

import pytest
from edit_texts import DOOR
from statwalk.errors import StorageError
from statwalk.files.machine_yaml.machine_file import FILE_NAME, load_machine
from statwalk.services.hosting.edited_file import written
from statwalk.services.hosting.store.records import MachineVersion
from statwalk.services.library.entry import Entry


@pytest.fixture
def entry(tmp_path: Path) -> Entry:
    (tmp_path / FILE_NAME).write_text(f"character: door.glb\n{DOOR}")
    return Entry("door", tmp_path, load_machine(tmp_path), "door")


def version(entry: Entry) -> MachineVersion:
    return MachineVersion(2, 0.0, "", f"{entry.file.text}# new\n")


def test_it_holds_the_new_text(entry: Entry) -> None:
    with written(entry, version(entry)):
        pass
    assert load_machine(entry.folder).text == f"{entry.file.text}# new\n"


def test_it_holds_the_old_text_if_the_version_cannot_be_kept(entry: Entry) -> None:
    with pytest.raises(StorageError), written(entry, version(entry)):
        raise StorageError("the disk is full")
    assert load_machine(entry.folder).text == entry.file.text
    assert [path.name for path in entry.folder.iterdir()] == [FILE_NAME]
