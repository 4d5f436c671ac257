"""`statwalk replay` plays a log to the state that it had, or says why not."""

import shutil
from pathlib import Path

import pytest
from paths import MACHINES
from statwalk.cli.replay import replay
from statwalk.errors import ContentError, StageError, UnknownNameError
from statwalk.services.library.load import load, load_role
from statwalk.stage.history.engine import ENGINE
from statwalk.stage.stage import Stage


@pytest.fixture
def played(tmp_path: Path) -> tuple[Path, Stage]:
    """The log of an elbow, with an edit."""
    stage = Stage(seed=2)
    actor = stage.add(load("elbow"))
    stage.send(actor, "STRETCH")
    stage.step(20)
    text = (MACHINES / "elbow" / "machine.yaml").read_text() + "\n# edited\n"
    stage.edit(load("elbow@2", text), text)
    stage.step(20)
    path = tmp_path / "elbow.jsonl"
    path.write_text("\n".join(stage.dump()))
    return path, stage


def test_it_says_the_hash(played: tuple[Path, Stage], capsys: pytest.CaptureFixture[str]) -> None:
    path, stage = played
    replay(path)
    assert capsys.readouterr().out == f"after 40 ticks, 1 actor: hash {stage.hash}\n"


def test_it_can_stop_before(played: tuple[Path, Stage], capsys: pytest.CaptureFixture[str]) -> None:
    path, stage = played
    stage.seek(7)
    replay(path, until=7)
    assert capsys.readouterr().out == f"after 7 ticks, 1 actor: hash {stage.hash}\n"


def test_a_machine_of_ones_own(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = tmp_path / "my-elbow"
    shutil.copytree(MACHINES / "elbow", folder)
    stage = Stage()
    stage.add(load_role(folder))
    stage.step(5)
    path = tmp_path / "log.jsonl"
    path.write_text("\n".join(stage.dump()))
    with pytest.raises(UnknownNameError):
        replay(path)
    replay(path, [folder])
    assert capsys.readouterr().out.endswith(f"hash {stage.hash}\n")


def test_a_log_of_another_engine_is_refused(played: tuple[Path, Stage]) -> None:
    path, _ = played
    made_by = f'"engine":{ENGINE},"version":"0.1.0"'
    other = f'"engine":{ENGINE + 1},"version":"3.2.1"'
    path.write_text(path.read_text().replace(made_by, other))
    words = rf"engine {ENGINE + 1} \(statwalk 3.2.1\) played the log; this is engine {ENGINE}"
    with pytest.raises(StageError, match=words):
        replay(path)


def test_a_log_that_was_changed_is_refused(played: tuple[Path, Stage]) -> None:
    path, _ = played
    path.write_text(path.read_text().replace('"event":"STRETCH"', '"event":"BEND"'))
    with pytest.raises(StageError, match="leads to another state at tick 40"):
        replay(path)


def test_a_file_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(ContentError, match="no such file"):
        replay(tmp_path / "none.jsonl")
