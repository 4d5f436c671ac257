"""A machine file that is saved while a stage plays it."""

import logging
import os
from pathlib import Path
from shutil import copytree

import pytest
import stages
from paths import MACHINES
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import AddActor, SendEvent, StageSetup
from statwalk.services.hosting.file_watch import FileWatch
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
