"""`statwalk draw`: a film strip in a file, and one line about an error."""

import xml.etree.ElementTree as ET
from pathlib import Path

import tiny_model
import typer
from statwalk.cli.draw import draw
from typer.testing import CliRunner, Result

app = typer.Typer()
app.command()(draw)
SVG = "{http://www.w3.org/2000/svg}"


def run(folder: Path, *options: str, out: str = "tiny.svg") -> Result:
    (folder / "tiny.glb").write_bytes(tiny_model.model())
    return CliRunner().invoke(app, [str(folder / "tiny.glb"), str(folder / out), *options])


def test_it_draws_a_strip(tmp_path: Path) -> None:
    assert run(tmp_path, "--clip", "Bend", "--frames", "3", "--side", "front").exit_code == 0
    root = ET.parse(tmp_path / "tiny.svg").getroot()
    assert [picture.findtext(f"{SVG}text") for picture in root.findall(f"{SVG}g")] == [
        "Bend 0.00 s",
        "Bend 0.50 s",
        "Bend 1.00 s",
    ]


def test_it_draws_the_pose_at_rest(tmp_path: Path) -> None:
    assert run(tmp_path).exit_code == 0
    assert "at rest" in (tmp_path / "tiny.svg").read_text()


def test_other_files_are_refused(tmp_path: Path) -> None:
    assert run(tmp_path, out="tiny.png").exit_code == 2
    assert not (tmp_path / "tiny.png").exists()
