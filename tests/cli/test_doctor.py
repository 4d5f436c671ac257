"""`statwalk doctor` names what is damaged, and ends with status 1 then."""

import sqlite3
from collections.abc import Callable
from pathlib import Path

import pytest
import typer
from keeping import keeping
from old_formats import to_format_1, to_format_3
from statwalk.cli.doctor import doctor
from statwalk.errors import ContentError
from statwalk.services.hosting.commands import AddActor, StageSetup
from statwalk.services.hosting.store.database import FILE_NAME, FORMAT
from statwalk.services.library.catalogue import Catalogue


@pytest.fixture
def stage(tmp_path: Path) -> str:
    """A stage in the data folder."""
    with keeping(tmp_path, Catalogue()) as held:
        return held.open(StageSetup(clock="manual", actors=(AddActor("elbow"),))).id


def test_a_whole_folder(stage: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    doctor(tmp_path)
    lines = capsys.readouterr().out.splitlines()
    assert f"stage {stage}: tick 0 of 0, 1 inputs, 0 snapshots whole" in lines
    assert lines[-1] == f"{tmp_path}: nothing is damaged"


@pytest.mark.parametrize("older", [to_format_1, to_format_3])
def test_a_whole_folder_of_an_older_version_is_whole_and_stays_as_it_is(
    stage: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], older: Callable[[Path], None]
) -> None:
    older(tmp_path / FILE_NAME)
    before = (tmp_path / FILE_NAME).read_bytes()
    doctor(tmp_path)
    assert f"stage {stage}: tick 0 of 0, 1 inputs, 0 snapshots whole" in capsys.readouterr().out
    assert (tmp_path / FILE_NAME).read_bytes() == before


def test_a_folder_of_a_newer_version_is_left_to_it(stage: str, tmp_path: Path) -> None:
    database = sqlite3.connect(tmp_path / FILE_NAME)
    database.execute(f"PRAGMA user_version={FORMAT + 1}")
    database.close()
    with pytest.raises(ContentError, match=f"format {FORMAT + 1}"):
        doctor(tmp_path)


def test_a_damaged_stage_is_named(stage: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    database = sqlite3.connect(tmp_path / FILE_NAME)
    with database:
        database.execute("UPDATE commands SET line = replace(line, 'elbow', 'elbov')")
    database.close()
    with pytest.raises(typer.Exit) as ended:
        doctor(tmp_path)
    assert ended.value.exit_code == 1
    assert f"stage {stage}: damaged: entry 1 of the log is damaged" in capsys.readouterr().out


def test_a_damaged_version_of_a_machine_is_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with keeping(tmp_path, Catalogue()) as held:
        current = held.versions.current("elbow")
        held.versions.change(current, current.version.text + "\n# edited\n", "a remark")
    database = sqlite3.connect(tmp_path / FILE_NAME)
    with database:
        database.execute("UPDATE versions SET what = 'another' WHERE number = 2")
    database.close()
    with pytest.raises(typer.Exit):
        doctor(tmp_path)
    assert "machine elbow: 1 version damaged: version 2" in capsys.readouterr().out


def test_a_damaged_model_is_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name, data in {
        f"characters/{'a' * 64}.glb": b"model",
        "names/robot.json": f'{{"sha256": "{"a" * 64}", "bytes": 5}}'.encode(),
    }.items():
        (tmp_path / name).parent.mkdir()
        (tmp_path / name).write_bytes(data)
    with pytest.raises(typer.Exit):
        doctor(tmp_path)
    assert "character robot: 5 bytes damaged: the model is damaged" in capsys.readouterr().out
