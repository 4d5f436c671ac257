from pathlib import Path

import captures
import pytest
import typer
from click.testing import Result
from statwalk.character.character import Character
from statwalk.cli.convert import convert
from statwalk.services.library.load import character_from, load
from typer.testing import CliRunner

app = typer.Typer()
app.command()(convert)


@pytest.fixture
def walk(tmp_path: Path) -> Path:
    (tmp_path / "walk.bvh").write_text(captures.walk())
    return tmp_path / "walk.bvh"


def run(walk: Path, *options: str) -> Result:
    return CliRunner().invoke(app, [str(walk), str(walk.with_name("out.glb")), *options])


def test_a_capture_becomes_a_model(walk: Path) -> None:
    assert run(walk, "--scale", "0.01").exit_code == 0
    out = load(walk.with_name("out.glb"))
    assert isinstance(out, Character)
    assert len(out.skeleton) == 23
    assert out.clips["walk"].sample(0).translation[0, 1] == pytest.approx(0.9)


def test_a_capture_is_carried_over_and_the_rest_stays(walk: Path) -> None:
    done = run(walk, "--onto", "faq-walker", "--name", "stroll", "--low-pass", "6")
    assert done.exit_code == 0, done.output
    out = load(walk.with_name("out.glb"))
    assert isinstance(out, Character)
    assert {"stroll", "walk"} <= set(out.clips)
    assert "bones carried over" in done.output


def test_options_that_make_no_sense_are_refused(walk: Path) -> None:
    assert run(walk, "--onto", "faq-walker", "--bone", "Hips").exit_code == 2
    assert run(walk.with_name("out.glb"), "--scale", "2").exit_code == 2
    assert CliRunner().invoke(app, [str(walk), "out.txt"]).exit_code == 2


@pytest.mark.parametrize("onto", [False, True], ids=["source", "target"])
def test_a_part_is_left_out_of_what_is_written(walk: Path, onto: bool) -> None:
    whole, out = character_from("faq-walker"), walk.with_name("out.glb")
    source = [str(walk), str(out), "--onto", "faq-walker"] if onto else ["faq-walker", str(out)]
    eye = whole.parts[-1]
    done = CliRunner().invoke(app, [*source, "--without", f"{eye.node}/{eye.primitive}"])
    assert done.exit_code == 0, done.output
    fewer = character_from(out)
    assert [len(part.positions) for part in fewer.parts] == [len(part.positions) for part in whole.parts[:-1]]
