"""A machine file that is saved while a stage plays it."""

import logging
import os
from pathlib import Path
from shutil import copytree

import pytest
import stages
from keeping import keeping
from paths import MACHINES
from statwalk.files.machine_yaml.edit.operations import SetCell
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import AddActor, SendEvent, StageSetup
from statwalk.services.hosting.file_watch import FileWatch
from statwalk.services.hosting.machine_edits import EditRequest, change
from statwalk.services.hosting.machine_versions import MachineVersions
from statwalk.services.hosting.registry import Registry
from statwalk.services.library.catalogue import Catalogue


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    copytree(MACHINES / "faq-walker", tmp_path / "mine", ignore=lambda *_: ["make"])
    return tmp_path / "mine"


@pytest.fixture
def registry(folder: Path) -> Registry:
    return stages.registry(Catalogue([folder]))


def save(folder: Path, old: str, new: str) -> None:
    file = folder / "machine.yaml"
    file.write_text(file.read_text().replace(old, new))
    os.utime(file, ns=(1, 1))  # clocks of files may be coarse


def test_what_was_saved_is_played(folder: Path, registry: Registry) -> None:
    host = registry.open(StageSetup(clock="manual", actors=(AddActor("mine"),)))
    watch = FileWatch(registry.versions)
    save(folder, "STAT  | STWK ", "STAT  | WALK ")
    assert watch.look() == ["mine"]
    host.handle(ask.Post((SendEvent("FORWARD"),)))
    host.handle(ask.Step(2))
    assert host.handle(ask.DescribeActors(1))[0].state == "WALK"


def test_what_is_refused_changes_nothing(
    folder: Path, registry: Registry, caplog: pytest.LogCaptureFixture
) -> None:
    watch = FileWatch(registry.versions)
    save(folder, "STAT  | STWK ", "STAT  | STWX ")
    with caplog.at_level(logging.WARNING):
        assert watch.look() == []
    assert "did you mean STWK" in caplog.text
    assert registry.versions.of("mine")[-1].number == 1


def test_nothing_was_saved(registry: Registry) -> None:
    assert FileWatch(registry.versions).look() == []


def test_an_edit_of_the_page_is_not_followed_again(folder: Path, registry: Registry) -> None:
    watch, versions = FileWatch(registry.versions), registry.versions
    current = versions.current("mine")
    versions.change(current, current.version.text.replace("STAT  | STWK ", "STAT  | WALK "), "a cell")
    assert (watch.look(), "STAT  | WALK" in (folder / "machine.yaml").read_text()) == ([], True)


def test_editions_of_a_library_without_stages(folder: Path) -> None:
    versions = MachineVersions(Catalogue([folder]), list)
    assert [one.number for one in versions.of("mine")] == [1]


@pytest.fixture
def table(folder: Path) -> Path:
    """The table of a machine in a file of its own."""
    text = (folder / "machine.yaml").read_text()
    start = text.index("table: |")
    end = text.index("\n\n", start)
    rows = [line.split("|") for line in text[start:end].splitlines()[1:]]
    (folder / "table.csv").write_text("".join(",".join(cell.strip() for cell in row) + "\n" for row in rows))
    (folder / "machine.yaml").write_text(f"{text[:start]}table: table.csv{text[end:]}")
    return folder / "table.csv"


def test_a_saved_table_is_played(table: Path, registry: Registry) -> None:
    watch = FileWatch(registry.versions)
    table.write_text(table.read_text().replace("STAT,STWK", "STAT,WALK"))
    os.utime(table, ns=(1, 1))
    assert watch.look() == ["mine"]
    assert registry.catalogue.role("mine").definition.cells["STAT", "FORWARD"].to == "WALK"


def test_an_edit_of_a_cell_is_written_to_its_table_and_nowhere_else(table: Path, registry: Registry) -> None:
    before, cells = (table.parent / "machine.yaml").read_text(), table.read_text()
    watch = FileWatch(registry.versions)
    change(registry.versions, EditRequest("mine", 1), [SetCell("WALK", "LEFT", "TRGT at end")])
    assert table.read_text() == cells.replace("WALK,WALK,TLFT", "WALK,WALK,TRGT at end")
    assert (table.parent / "machine.yaml").read_text() == before
    assert watch.look() == []  # the edit is a version already


def test_a_stage_comes_back_though_its_table_was_saved_while_no_server_ran(
    table: Path, tmp_path: Path
) -> None:
    with keeping(tmp_path / "data", Catalogue([table.parent])) as held:
        host = held.open(StageSetup(clock="manual", actors=(AddActor("mine"),)))
        host.handle(ask.Post((SendEvent("FORWARD"),)))
        host.handle(ask.Step(200))
        before = host.handle(ask.Describe()).hash
    table.write_text(table.read_text().replace("STAT,STWK", "STAT,WALK"))
    with keeping(tmp_path / "data", Catalogue([table.parent])) as held:
        assert held.find(host.id).handle(ask.Describe()).hash == before
        assert held.catalogue.role("mine").definition.cells["STAT", "FORWARD"].to == "WALK"
