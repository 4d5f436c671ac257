"""EX1 expressions of characters, whichever machine plays them, and expressions on poses without a stage."""

import math
import re

import numpy as np
import pytest
import statwalk
from scipy.spatial.transform import Rotation
from statwalk.character.role import Role
from statwalk.errors import ContentError, MachineError
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.maths.pose import rest
from statwalk.stage.replay import replay
from systems.test_ex1 import GEARBOX, JOINTS, angles, machine, played, shift

MECHANISM = """\
name: box
model: gearbox.glb
clips: {slow: {of: rest, seconds: 3}}
expressions: |
  # what B and the rack do is the box's own business
  ratio = 10 / 8
  gear_b.rotate_z = -ratio * gear_a.rotate_z
  rack_c.trans_y = gear_b.rotate_z * (pi/180) * 8
"""


def box(folder, text=MECHANISM):
    """A character file beside the shipped model."""
    (folder / "gearbox.glb").write_bytes(GEARBOX.character.model_glb)
    (folder / "character.yaml").write_text(text)
    return statwalk.load(folder / "character.yaml")


def played_box(folder, *lines, text=MECHANISM):
    definition = read_machine(machine(lines))
    return played(Role.build("box", box(folder, text), definition), 7)


def test_a_characters_own_expressions_move_it_whatever_machine_plays_it(tmp_path):
    _, actor = played_box(tmp_path, "gear_a.rotate_z = 10 * frameid")
    assert angles(actor, "gear_b")[2] == pytest.approx(-87.5, abs=1e-4)
    assert shift(actor, "rack_c")[1] == pytest.approx(math.radians(-87.5) * 8, rel=1e-6)
    assert actor.variables == {"ratio": 1.25}
    assert actor.channels == pytest.approx(
        {"gear_a.rotate_z": 70, "gear_b.rotate_z": -87.5, "rack_c.trans_y": math.radians(-87.5) * 8}, rel=1e-6
    )


def test_a_machine_reads_the_channels_that_its_character_sets(tmp_path):
    _, actor = played_box(tmp_path, "half = gear_b.rotate_z / 2", "gear_a.rotate_z = 8", "ratio = 3")
    assert actor.variables == pytest.approx({"half": -5, "ratio": 3})  # the character's ratio is its own


def test_a_clip_turns_the_mechanism_too(tmp_path):
    skeleton, keys = (
        "crank --- - - - -\nwheel crank 1 1 0 0\n",
        "#time 0\n#rotate crank 0 0 0\n#time 1\n#rotate crank 0 0 60",
    )
    (tmp_path / "bones.txt").write_text(skeleton)
    (tmp_path / "turn.txt").write_text(keys)
    (tmp_path / "character.yaml").write_text(
        "skeleton: bones.txt\nclips: {turn: {keys: turn.txt}}\n"
        "expressions: [wheel.rotate_z = -2 * crank.rotate_z]\n"
    )
    wheel = statwalk.load(tmp_path / "character.yaml")
    text = "character: c.yaml\ninitial: T\nstates: {T: {motion: turn}}\ntable: |\n  state | END\n  T |\n"
    _, actor = played(Role.build("wheel", wheel, read_machine(text)), 30)
    turn = Rotation.from_quat(actor.pose.rotation[1]).as_euler("xyz", degrees=True)
    np.testing.assert_allclose(turn, [0, 0, -60], atol=1e-3)


@pytest.mark.parametrize(
    ("lines", "line", "what"),
    [
        (
            ["gear_a.rotate_z = 1", "gear_b.rotate_z = 2"],
            14,
            "the character's own expressions (line 7",
        ),
        (["gear_a.rotate_z = gear_b.rotate_z"], 13, "circle"),
    ],
)
def test_a_machine_against_its_character_is_refused_with_its_line(tmp_path, lines, line, what):
    with pytest.raises(MachineError) as refused:
        played_box(tmp_path, *lines)
    assert refused.value.place == f"line {line}"
    assert what in refused.value.message


@pytest.mark.parametrize(
    ("change", "line", "what"),
    [
        (("gear_b.rotate_z =", "gear_x.rotate_z ="), 7, "did you mean gear"),
        (("10 / 8", "10 / pace"), 6, "no variable is called 'pace'"),
        (("ratio = 10 / 8", "ratio = gear_b.rotate_z"), 6, "circle"),
        (("-ratio *", "-ratio +* "), 7, "the formula"),
        (("of: rest", "of: rust"), 3, "did you mean rest"),
        (("gearbox.glb", "other.glb"), 2, "must name a .glb or .gltf file"),
        (("name: box", "scale: 2"), 1, "a model has its own size"),
        (("name: box", "skeleton: mammal"), 1, "a skeleton (skeleton: mammal.txt) or a model"),
    ],
)
def test_what_is_wrong_in_a_character_file_is_refused_with_its_line(tmp_path, change, line, what):
    with pytest.raises(ContentError) as refused:
        box(tmp_path, MECHANISM.replace(*change))
    assert what in str(refused.value)
    assert f"line {line}:" in str(refused.value)


def test_a_characters_expressions_play_alike_in_a_crowd_and_in_a_replay(tmp_path):
    role = Role.build("box", box(tmp_path), read_machine(machine(["gear_a.rotate_z = 10 * frameid"])))
    alone, _ = played(role, 50)
    stage = statwalk.Stage(seed=1)
    actors = [stage.add(role) for _ in range(37)]
    stage.step(50)
    for part, other in zip(alone.actors[0].pose, actors[-1].pose, strict=True):
        np.testing.assert_array_equal(part, other)
    assert replay(stage.dump(), lambda _: role).hash == stage.hash


def test_express_runs_lines_on_a_pose_as_a_tick_does():
    character, frames = GEARBOX.character, 7
    lines = [line.text for line in GEARBOX.definition.expressions]
    found = statwalk.express(character, lines, frameid=frames)
    _, actor = played(GEARBOX, frames)
    np.testing.assert_allclose(found.pose.rotation, actor.pose.rotation, atol=1e-6)
    np.testing.assert_allclose(found.pose.translation, actor.pose.translation, rtol=1e-6, atol=1e-6)
    assert found.variables == pytest.approx(actor.variables)
    assert found.channels == pytest.approx(actor.channels, rel=1e-6)


def test_express_takes_many_poses_parameters_and_a_rate(tmp_path):
    character = box(tmp_path)
    turns = np.array([0, 20, -40, 100.0])
    poses = character.clip("rest").sample(np.zeros(4))
    poses.rotation[:, JOINTS.index("gear_a")] = Rotation.from_euler(
        "z", turns[:, None], degrees=True
    ).as_quat()
    found = statwalk.express(character, pose=poses)
    np.testing.assert_allclose(found.channels["gear_b.rotate_z"], -1.25 * turns, atol=1e-4)
    assert found.pose.rotation.shape == poses.rotation.shape
    more = statwalk.express(character, "a = pace * time", frameid=60, rate=30, parameters={"pace": 3})
    assert more.variables == {"a": 6}


@pytest.mark.parametrize(
    ("lines", "more", "what"),
    [
        (["a = 1", "a = 2"], {}, "line 2: a is already set in line 1"),
        (["a = b"], {}, "line 1: no variable is called 'b'"),
        (["gear_x.rotate_z = 1"], {}, "line 1: expressions: no joint is called 'gear_x'"),
        (["a = 1"], {"frameid": -1}, "frameid: "),
        (["a = 1"], {"rate": 0}, "rate: "),
        (["a = p"], {"parameters": {"p": math.nan}}, "p is no finite number"),
        (["a = 1"], {"pose": rest(2)}, "pose: "),
    ],
)
def test_express_says_what_is_wrong(lines, more, what):
    with pytest.raises(ContentError, match=re.escape(what)):
        statwalk.express(GEARBOX.character, lines, **more)
