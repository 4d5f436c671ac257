"""After a start, machines have the versions that they had; a damaged version is named."""

import shutil
from pathlib import Path

import pytest
from damaging import damaged, emptied
from keeping import keeping, what_it_is
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import AddActor, StageSetup
from statwalk.services.hosting.machine_edits import EditRequest, undo
from statwalk.services.hosting.registry import Registry
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.library.load import shipped_machines_folder


def edited(held: Registry, machine: str = "elbow") -> str:
    """Edits a shipped machine; returns its text."""
    current = held.versions.current(machine)
    text = current.version.text + "\n# edited\n"
    held.versions.change(current, text, "a remark")
    return text


def test_an_edit_of_a_shipped_machine_comes_back(tmp_path: Path) -> None:
    with keeping(tmp_path, Catalogue()) as held:
        text = edited(held)
        before = held.versions.of("elbow")
    with keeping(tmp_path, Catalogue()) as held:
        assert held.catalogue.entry("elbow").file.text == text
        assert held.versions.of("elbow") == before


def test_a_renamed_machine_has_its_versions_when_the_server_starts_again(tmp_path: Path) -> None:
    with keeping(tmp_path, Catalogue()) as held:
        edited(held)
        before = held.versions.of("elbow")
        held.versions.copy("elbow", "hand")
        held.versions.rename("elbow", "hand")
    with keeping(tmp_path, Catalogue()) as held:
        kept = held.store.records.versions() if held.store else {}
        assert (list(kept), kept["hand"]) == (["hand"], before)


def test_an_edit_that_came_back_can_be_undone(tmp_path: Path) -> None:
    with keeping(tmp_path, Catalogue()) as held:
        shipped = held.catalogue.entry("elbow").file.text
        edited(held)
    with keeping(tmp_path, Catalogue()) as held:
        undo(held.versions, EditRequest("elbow", held.versions.current("elbow").version.number))
        assert held.catalogue.entry("elbow").file.text == shipped


def test_a_stage_comes_back_with_the_edit_that_it_played(tmp_path: Path) -> None:
    with keeping(tmp_path, Catalogue()) as held:
        host = held.open(StageSetup(clock="manual", actors=(AddActor("elbow"),)))
        host.handle(ask.Step(5))
        edited(held)
        before = what_it_is(host)
    with keeping(tmp_path, Catalogue()) as held:
        assert what_it_is(held.find(host.id)) == before


# --- damage


def spoilt(folder: Path, version: int) -> None:
    """Changes the text of a version, as a flipped bit does."""
    damaged(folder, f"UPDATE versions SET text = text || '#' WHERE number = {version}")


def test_a_damaged_edit_is_named_among_the_versions_and_the_one_before_counts(tmp_path: Path) -> None:
    with keeping(tmp_path, Catalogue()) as held:
        whole = edited(held)
        edited(held)
    spoilt(tmp_path, 3)
    with keeping(tmp_path, Catalogue()) as held:
        assert held.catalogue.entry("elbow").file.text == whole
        versions = [(version.number, version.what) for version in held.versions.of("elbow")]
    assert versions[1:] == [(2, "a remark"), (4, "version 3 is damaged: version 2 again")]


def test_an_undo_after_a_damaged_edit_takes_back_the_edit_that_counts(tmp_path: Path) -> None:
    with keeping(tmp_path, Catalogue()) as held:
        shipped = held.catalogue.entry("elbow").file.text
        edited(held)
        edited(held)
    spoilt(tmp_path, 3)
    with keeping(tmp_path, Catalogue()) as held:
        undo(held.versions, EditRequest("elbow", held.versions.current("elbow").version.number))
        assert held.catalogue.entry("elbow").file.text == shipped


def test_a_damaged_edit_is_named_once(tmp_path: Path) -> None:
    with keeping(tmp_path, Catalogue()) as held:
        edited(held)
    spoilt(tmp_path, 2)
    for _ in range(2):
        with keeping(tmp_path, Catalogue()) as held:
            assert [version.number for version in held.versions.of("elbow")] == [1, 3]


def test_a_damaged_old_edit_is_told_in_the_log(tmp_path: Path, caplog: pytest.LogCaptureFixture) -> None:
    with keeping(tmp_path, Catalogue()) as held:
        edited(held)
        newest = edited(held)
    spoilt(tmp_path, 2)
    with keeping(tmp_path, Catalogue()) as held:
        assert held.catalogue.entry("elbow").file.text == newest
    assert "elbow comes back without version 2: damaged" in caplog.messages


@pytest.fixture
def elbow(tmp_path: Path) -> Path:
    """The folder of a machine of one's own."""
    return Path(shutil.copytree(shipped_machines_folder() / "elbow", tmp_path / "mine"))


def test_a_file_that_was_saved_meanwhile_is_a_version(tmp_path: Path, elbow: Path) -> None:
    with keeping(tmp_path, Catalogue([elbow])) as held:
        edited(held, "mine")
    with (elbow / "machine.yaml").open("a") as file:
        file.write("# saved\n")
    with keeping(tmp_path, Catalogue([elbow])) as held:
        newest = held.versions.of("mine")[-1]
    assert (newest.number, newest.what, newest.before) == (3, "the file was saved while no server ran", 2)


def test_a_machine_with_a_file_keeps_its_text_if_its_newest_version_is_damaged(
    tmp_path: Path, elbow: Path
) -> None:
    with keeping(tmp_path, Catalogue([elbow])) as held:
        edited(held, "mine")
        text = edited(held, "mine")
    spoilt(tmp_path, 3)
    with keeping(tmp_path, Catalogue([elbow])) as held:
        newest = held.versions.of("mine")[-1]
        assert held.catalogue.entry("mine").file.text == text == newest.text
    assert (newest.number, newest.what) == (4, "version 3 is damaged: the text of the file")


def test_a_version_whose_date_is_gone_does_not_come_back(tmp_path: Path) -> None:
    with keeping(tmp_path, Catalogue()) as held:
        edited(held)
    emptied(tmp_path, "versions", "at")
    with keeping(tmp_path, Catalogue()) as held:
        assert "elbow comes back without version 1, 2: damaged" in held.damage
