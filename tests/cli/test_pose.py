import numpy as np
import pytest
import typer
from statwalk.cli.pose import pose
from statwalk.files.gltf import read_model
from tiny_model import model
from typer.testing import CliRunner

app = typer.Typer()
app.command()(pose)


@pytest.fixture
def file(tmp_path):
    (tmp_path / "tiny.glb").write_bytes(model())
    return tmp_path / "tiny.glb"


def run(file, *options):
    return CliRunner().invoke(app, [str(file), "--out", str(file.with_name("pose.npz")), *options])


def test_the_file_holds_what_python_says(file):
    assert run(file, "--clip", "Bend", "--time", "0.7").exit_code == 0
    character = read_model(model(), "tiny")
    wanted = character.clips["Bend"].sample(0.7)
    with np.load(file.with_name("pose.npz")) as found:
        assert np.array_equal(found["world"], character.world(wanted))
        assert np.array_equal(found["vertices"], character.vertices(wanted)[0].positions)
        assert found["names"].tolist() == ["hip", "knee", "skin"]
        assert np.array_equal(found["local"][:, 3:7], wanted.rotation)


def test_without_a_clip_it_is_the_pose_at_rest(file):
    run(file)
    with np.load(file.with_name("pose.npz")) as found:
        assert found["local"][1].tolist() == [0, 1, 0, 0, 0, 0, 1, 1, 1, 1]


def test_time_wraps_with_loop(file):
    run(file, "--clip", "Bend", "--time", "1.25", "--loop")
    with np.load(file.with_name("pose.npz")) as found:
        assert found["local"][1, 3:7] == pytest.approx(
            read_model(model(), "t").clips["Bend"].sample(0.25).rotation[1]
        )


def test_a_dot_in_the_name_stays(file):
    run(file, "--out", str(file.with_name("walk.0.3")))
    assert file.with_name("walk.0.3.npz").is_file()


@pytest.mark.parametrize(
    ("options", "said"),
    [(["--clip", "Walk"], "There are: Bend"), (["--time", "nan"], "finite"), (["--out", "/"], "folder")],
    ids=["unknown clip", "no time", "a folder"],
)
def test_mistakes_are_explained(file, options, said):
    result = run(file, *options)
    assert result.exit_code == 2
    assert said in " ".join(result.output.split())
