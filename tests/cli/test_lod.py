"""`statwalk lod`: finds and stores levels of detail, writes coarser models, and refuses in one line."""

import re
from pathlib import Path

import command_line
import pytest
import statwalk
from rig_shapes import cylinder, mesh
from statwalk.character.character import Character


def run(*arguments: object) -> command_line.Ended:
    return command_line.statwalk("lod", *arguments)


def vertices(character: Character) -> int:
    return sum(len(part.positions) for part in character.parts)


@pytest.fixture(scope="module")
def post(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A cylinder with its order, as the command writes it."""
    path = tmp_path_factory.mktemp("lod") / "post.glb"
    path.write_bytes(statwalk.with_detail(mesh(*cylinder())).model_glb)
    return path


def test_the_levels_are_stored_and_listed(tmp_path: Path) -> None:
    (tmp_path / "post.glb").write_bytes(mesh(*cylinder()).model_glb)
    done = run(tmp_path / "post.glb")
    assert done.returncode == 0, done.stderr
    made = statwalk.load(tmp_path / "post-lod.glb")
    rows = [line.split() for line in done.stdout.splitlines() if re.match(r"\s*\d", line)]
    assert [int(row[0]) for row in rows] == list(range(len(made.levels) + 1))
    assert rows[0][1:] == ["986", "1,968", "0.0", "0.0", "0.0"]
    assert [float(row[3]) for row in rows[1:]] == pytest.approx(
        [1000 * level.error for level in made.levels], abs=0.06
    )
    assert f"{len(made.levels)} levels of detail" in done.stdout


@pytest.mark.parametrize(
    ("option", "value", "most"), [("--share", 0.5, 493), ("--vertices", 300, 300), ("--error", 0.01, 985)]
)
def test_a_coarser_model_is_written(post: Path, option: str, value: float, most: int, tmp_path: Path) -> None:
    done = run(post, option, value, "-o", tmp_path / "far.glb")
    assert done.returncode == 0, done.stderr
    coarse = statwalk.load(tmp_path / "far.glb")
    assert vertices(coarse) <= most
    assert f"far.glb: {vertices(coarse):,} of 986 vertices" in done.stdout
    assert coarse.levels == ()


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (("--error", -1), "error is -1.0; it must be at least 0 metres"),
        (("--share", 1.5), "it must be above 0 and at most 1"),
        (("--vertices", 1), "1 vertices are too few"),
        (("--share", 0.5, "--error", 0.1), "exactly one of error, vertices and share"),
        (("-o", "far.obj"), "the file to write is a .glb, not far.obj"),
    ],
)
def test_a_wrong_wish_is_refused(post: Path, options: tuple[object, ...], words: str) -> None:
    done = run(post, *options)
    assert done.returncode == 2
    assert words in " ".join(re.sub(r"[│╭╰─╮╯]", "", done.stderr).split())
    assert not post.with_name("post-lod.glb").exists()


def test_a_model_without_triangles_is_refused(tmp_path: Path) -> None:
    points, faces = cylinder()
    (tmp_path / "dots.glb").write_bytes(mesh(points, faces, mode=0).model_glb)
    done = run(tmp_path / "dots.glb")
    assert done.returncode == 2
    assert "dots.glb" in done.stderr
    assert "no triangles in lists" in " ".join(done.stderr.split())
    assert list(tmp_path.iterdir()) == [tmp_path / "dots.glb"]
