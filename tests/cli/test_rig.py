"""`statwalk rig`: a mesh becomes a model with a skin, and what cannot be rigged is refused in one line."""

from pathlib import Path

import command_line
import statwalk
from rig_shapes import cylinder, human, mesh


def run(*arguments: object) -> command_line.Ended:
    return command_line.statwalk("rig", *arguments)


def test_a_figure_gets_a_human_skeleton(tmp_path: Path) -> None:
    (tmp_path / "figure.glb").write_bytes(mesh(*human()).model_glb)
    done = run(tmp_path / "figure.glb", "--skeleton", "human", "-o", tmp_path / "out.glb")
    assert done.returncode == 0, done.stderr
    assert "21 joints move" in done.stdout
    character = statwalk.load(tmp_path / "out.glb")
    assert "LeftUpperArm" in character.skeleton.names
    assert character.parts[0].skin == 0


def test_what_does_not_fit_is_refused_with_a_reason(tmp_path: Path) -> None:
    (tmp_path / "post.glb").write_bytes(mesh(*cylinder()).model_glb)
    done = run(tmp_path / "post.glb", "--skeleton", "mammal")
    assert done.returncode == 2
    assert "post.glb" in done.stderr
    assert "its legs must be apart" in done.stderr
    assert list(tmp_path.iterdir()) == [tmp_path / "post.glb"]
