"""A backup holds a data folder as it was at one instant; it comes back into an empty folder only."""

import zipfile
from pathlib import Path

import pytest
from keeping import keeping, what_it_is
from statwalk.errors import ConflictError, ContentError
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import AddActor, StageSetup
from statwalk.services.hosting.store.backup import back_up, bring_back
from statwalk.services.library.catalogue import Catalogue


@pytest.fixture(scope="module")
def catalogue() -> Catalogue:
    return Catalogue()


def test_a_stage_comes_back_from_a_backup_that_was_made_while_it_went_on(
    tmp_path: Path, catalogue: Catalogue
) -> None:
    with keeping(tmp_path / "data", catalogue) as held:
        host = held.open(StageSetup(clock="manual", actors=(AddActor("elbow"),)))
        host.handle(ask.Step(20))
        before = what_it_is(host)
        back_up(tmp_path / "data", tmp_path / "backup.zip")
        host.handle(ask.Step(20))
    bring_back(tmp_path / "backup.zip", tmp_path / "new")
    with keeping(tmp_path / "new", catalogue) as held:
        assert what_it_is(held.find(host.id)) == before


def test_the_files_of_a_data_folder_are_in_it_and_no_others(tmp_path: Path) -> None:
    kept = {
        f"characters/{'a' * 64}.glb": b"model",
        "names/robot.json": b"{}",
        "machines/robot/machine.yaml": b"x",
        "machines/robot/my walk (1).bvh": b"y",
        "machines/robot/takes/one/walk.bvh": b"u",
        "machines/robot/.keys": b"z",
    }
    for name, data in (kept | {"lock": b"1", "tmp/half": b"", "notes.txt": b"mine"}).items():
        (tmp_path / "data" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "data" / name).write_bytes(data)
    back_up(tmp_path / "data", tmp_path / "backup.zip")
    bring_back(tmp_path / "backup.zip", tmp_path / "new")
    found = {path.relative_to(tmp_path / "new").as_posix(): path for path in (tmp_path / "new").rglob("*")}
    assert {name: path.read_bytes() for name, path in found.items() if path.is_file()} | {"lock": b""} == {
        **kept,
        "lock": b"",
    }


def test_an_older_backup_is_not_written_over(tmp_path: Path) -> None:
    (tmp_path / "backup.zip").write_bytes(b"precious")
    with pytest.raises(ConflictError, match="exists already"):
        back_up(tmp_path, tmp_path / "backup.zip")
    assert (tmp_path / "backup.zip").read_bytes() == b"precious"


def test_a_folder_with_data_is_left_alone(tmp_path: Path, catalogue: Catalogue) -> None:
    with keeping(tmp_path / "data", catalogue):
        back_up(tmp_path / "data", tmp_path / "backup.zip")
    with pytest.raises(ConflictError, match="holds data already"):
        bring_back(tmp_path / "backup.zip", tmp_path / "data")


@pytest.mark.parametrize(
    "name",
    [
        "../escaped.txt",
        "/etc/escaped",
        "machines/../../x",
        "machines/robot/../../x",
        "machines/robot/a/.hidden",
        "notes.txt",
        "names/a/b.json",
    ],
)
def test_nothing_else_is_unpacked(tmp_path: Path, name: str) -> None:
    with zipfile.ZipFile(tmp_path / "backup.zip", "w") as archive:
        archive.writestr(name, "x")
    with pytest.raises(ContentError, match="no backup"):
        bring_back(tmp_path / "backup.zip", tmp_path / "new")
    assert [path.name for path in (tmp_path / "new").iterdir()] == ["lock"]


def test_another_file_is_no_backup(tmp_path: Path) -> None:
    (tmp_path / "backup.zip").write_bytes(b"PK and so on")
    with pytest.raises(ContentError, match="no backup"):
        bring_back(tmp_path / "backup.zip", tmp_path / "new")
