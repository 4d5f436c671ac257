"""A machine file that is saved while a stage plays it."""

import logging
import os
from pathlib import Path
from shutil import copytree

import pytest
from statwalk.web.keeping.catalogue import Catalogue
from statwalk.web.keeping.editions import Editions
from statwalk.web.keeping.registry import Registry
from statwalk.web.keeping.watching import Watch
from statwalk.web.schemas import NewActor, NewStage
from statwalk.web.settings import Settings
from where import MACHINES


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    copytree(MACHINES / "faq-walker", tmp_path / "mine", ignore=lambda *_: ["make"])
    return tmp_path / "mine"


@pytest.fixture
def registry(folder: Path) -> Registry:
    return Registry(Catalogue([folder]), Settings())


def save(folder: Path, old: str, new: str) -> None:
    file = folder / "machine.yaml"
    file.write_text(file.read_text().replace(old, new))
    os.utime(file, ns=(1, 1))  # clocks of files may be coarse


def test_what_was_saved_is_played(folder: Path, registry: Registry) -> None:
    hosted = registry.open(NewStage(clock="manual", actors=[NewActor(machine="mine")]))
    watch = Watch(registry.editions)
    save(folder, "STAT  | STWK ", "STAT  | WALK ")
    assert watch.look() == ["mine"]
    hosted.stage.send(1, "FORWARD")
    hosted.stage.step(2)
    assert hosted.stage.actor(1).state == "WALK"


def test_what_is_refused_changes_nothing(folder: Path, registry: Registry, caplog: pytest.LogCaptureFixture) -> None:
    watch = Watch(registry.editions)
    save(folder, "STAT  | STWK ", "STAT  | STWX ")
    with caplog.at_level(logging.WARNING):
        assert watch.look() == []
    assert "did you mean STWK" in caplog.text
    assert registry.editions.of("mine")[-1].version == 1


def test_nothing_was_saved(registry: Registry) -> None:
    assert Watch(registry.editions).look() == []


def test_an_edit_of_the_page_is_not_followed_again(folder: Path, registry: Registry) -> None:
    watch, editions = Watch(registry.editions), registry.editions
    editions.change("mine", editions.of("mine")[-1].text.replace("STAT  | STWK ", "STAT  | WALK "), "a cell")
    assert (watch.look(), "STAT  | WALK" in (folder / "machine.yaml").read_text()) == ([], True)


def test_editions_of_a_library_without_stages(folder: Path) -> None:
    editions = Editions(Catalogue([folder]), list)
    assert [one.version for one in editions.of("mine")] == [1]
