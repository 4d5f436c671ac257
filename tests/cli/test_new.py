"""`statwalk new`: a folder that verifies and plays."""

import pygltflib
from command_line import statwalk
from paths import GLTF, MACHINES, needs_assets

WALKER = MACHINES / "faq-walker" / "walker.glb"


@needs_assets
def test_new_verify_and_play(tmp_path):
    made = statwalk("new", GLTF / "RobotExpressive.glb", cwd=tmp_path)
    assert made.returncode == 0, made.stderr
    assert "14 states; it begins in STAT" in made.stdout
    assert statwalk("verify", "RobotExpressive", cwd=tmp_path).returncode == 0
    played = statwalk("play", "RobotExpressive", "--events", "0:+FORWARD", "--seconds", "1", cwd=tmp_path)
    assert "after 60 ticks: WALK" in played.stdout


def test_again_in_the_same_place_is_refused(tmp_path):
    statwalk("new", WALKER, "robot", cwd=tmp_path)
    again = statwalk("new", WALKER, "robot", cwd=tmp_path)
    assert again.returncode == 2
    assert "this folder already holds a machine" in again.stderr


def test_a_model_that_is_not_there(tmp_path):
    done = statwalk("new", "nothing.glb", cwd=tmp_path)
    assert done.returncode == 2
    assert "nothing.glb: there is no such file" in done.stderr


def test_a_file_where_the_folder_should_be(tmp_path):
    (tmp_path / "taken").write_text("")
    made = statwalk("new", WALKER, "taken", cwd=tmp_path)
    assert (made.returncode, made.stdout) == (2, "")
    assert "taken" in made.stderr
    assert made.stderr.count("\n") == 1


def test_a_model_that_stays_where_it_is_is_named_from_the_folder(tmp_path):
    (tmp_path / "robot.glb").write_bytes((WALKER).read_bytes())
    statwalk("new", "robot.glb", "machines/robot", "--no-copy", cwd=tmp_path)
    (tmp_path / "here").mkdir()
    for name in ("robot.glb", "machines"):
        (tmp_path / name).rename(tmp_path / "here" / name)
    assert statwalk("verify", "here/machines/robot", cwd=tmp_path).returncode == 0


def test_the_version(tmp_path):
    assert statwalk("--version", cwd=tmp_path).stdout.startswith("statwalk 0.")


@needs_assets
def test_a_mesh_is_left_out_of_the_copy(tmp_path):
    knight = GLTF / "KayKit_Knight.glb"
    made = statwalk("new", knight, "knight", "--without", "1H_Sword", "--without", "2H_Sword", cwd=tmp_path)
    assert made.returncode == 0, made.stderr
    nodes = pygltflib.GLTF2().load(str(tmp_path / "knight" / "KayKit_Knight.glb")).nodes
    drawn = {node.name for node in nodes if node.mesh is not None}
    assert "1H_Sword_Offhand" in drawn
    assert not {"1H_Sword", "2H_Sword"} & drawn


def test_without_a_copy_nothing_is_left_out(tmp_path):
    made = statwalk("new", WALKER, "robot", "--no-copy", "--without", "x", cwd=tmp_path)
    assert (made.returncode, "--no-copy" in made.stderr) == (2, True)
    assert not (tmp_path / "robot").exists()
