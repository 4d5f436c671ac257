"""EX1 expressions (FAQ Q24): the corrected gearbox, dependency order, what is refused, and what replays.

The channels of an actor are compared with formulas in plain Python, and with SciPy's Euler angles.
"""

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

GEARBOX = statwalk.load("gearbox")
JOINTS = GEARBOX.character.skeleton.names
HEAD = """\
semantics: 1
character: gearbox.glb
initial: RUN
parameters: {pace: {default: 2, min: 0, max: 9}, aim: {kind: point, default: [1, 2, 3]}}
states:
  RUN: {motion: rest, loop: true}
  GO: {motion: {expressions: [gear_b.rotate_x = 60 * time * pace, w = 4, gear_b.trans_z = w * time]}}
table: |
  state | FLIP | END
  RUN   | GO   |
  GO    | RUN  |
"""


def machine(lines, head=HEAD):
    return head + "expressions: |\n" + "".join(f"  {line}\n" for line in lines)


def role_of(*lines):
    definition = read_machine(machine(lines))
    return Role.build("box", GEARBOX.character, definition)


def played(role, ticks=1, seed=1):
    stage = statwalk.Stage(seed=seed)
    actor = stage.add(role)
    stage.step(ticks)
    return stage, actor


def angles(actor, joint):
    """Degrees about X, then Y, then Z, of a joint's local rotation."""
    turn = Rotation.from_quat(actor.pose.rotation[JOINTS.index(joint)])
    return turn.as_euler("xyz", degrees=True)


def shift(actor, joint):
    return actor.pose.translation[JOINTS.index(joint)]


@pytest.mark.parametrize("frame", [1, 7, 36, 100])
def test_the_gearbox_turns_as_the_corrected_expressions_say(frame):
    _, actor = played(GEARBOX, frame)
    a = 10 * frame
    b = -(10 / 8) * a
    for joint, degrees in (("gear_a", a), ("gear_b", b)):
        expected = Rotation.from_euler("z", degrees, degrees=True)
        turn = Rotation.from_quat(actor.pose.rotation[JOINTS.index(joint)])
        assert (turn * expected.inv()).magnitude() < 1e-6
    assert shift(actor, "rack_c")[1] == pytest.approx(b * math.pi / 180 * 8, rel=1e-6)
    pitch = 2 * math.pi
    assert abs(shift(actor, "rack_c")[1] + shift(actor, "strip")[1]) <= pitch / 2 + 1e-4


def test_lines_run_in_the_order_of_their_dependencies():
    role = role_of("gear_b.rotate_z = twice", "twice = 2 * gear_a.rotate_z", "gear_a.rotate_z = 7")
    _, actor = played(role)
    assert angles(actor, "gear_b")[2] == pytest.approx(14, abs=1e-4)
    assert actor.variables == {"twice": 14}


def test_functions_constants_parameters_and_clocks():
    role = role_of(
        "a = sin(pi/6) + cos(0) + tan(0) + sqrt(9) + log(1) + exp(0) + abs(-2) + max(1, 5) + min(1, 5)",
        "b = pace * aim.y + frameid + time",
        "gear_a.trans_x = a",
        "gear_a.scale_y = b",
    )
    stage, actor = played(role, 30)
    stage.set(actor, "pace", 3)
    stage.step(1)
    assert actor.variables == pytest.approx({"a": 13.5, "b": 3 * 2 + 31 + 31 / 60})
    assert shift(actor, "gear_a")[0] == pytest.approx(13.5)
    assert actor.pose.scale[JOINTS.index("gear_a")][1] == pytest.approx(37 + 31 / 60, rel=1e-6)


def test_angles_that_no_line_sets_stay():
    role = role_of("gear_a.rotate_x = 20", "strip.rotate_y = 30", "strip.rotate_z = gear_a.rotate_x + 5")
    _, actor = played(role)
    np.testing.assert_allclose(angles(actor, "gear_a"), [20, 0, 0], atol=1e-4)
    np.testing.assert_allclose(angles(actor, "strip"), [0, 30, 25], atol=1e-4)


def test_a_channel_that_is_read_is_the_channel_of_the_motion():
    role = role_of("gear_a.trans_y = 2 * gear_b.trans_x + rack_c.scale_z")
    _, actor = played(role)
    assert shift(actor, "gear_a")[1] == pytest.approx(2 * 18 + 1)


def test_a_new_actor_shows_its_expressions_at_once():
    stage = statwalk.Stage(seed=1)
    stage.step(5)
    actor = stage.add(GEARBOX)
    stage.step(1)
    other = stage.actor(actor.id)
    assert angles(other, "gear_a")[2] == pytest.approx(60, abs=1e-4)


def test_a_motion_may_be_a_pose_driven_by_expressions():
    stage, actor = played(role_of())
    stage.send(actor, "FLIP")
    stage.step(40)
    seconds = actor.time
    assert actor.state == "GO"
    assert seconds > 0.6
    assert angles(actor, "gear_b")[0] == pytest.approx(60 * seconds * 2, abs=1e-3)
    assert shift(actor, "gear_b") == pytest.approx([18, 0, 4 * seconds], abs=1e-4)


def test_the_way_into_such_a_motion_has_no_jump():
    stage, actor = played(role_of(), 5)
    before = actor.pose.translation.copy()
    stage.send(actor, "FLIP")
    ways = []
    for _ in range(60):
        stage.step(1)
        ways.append(np.abs(actor.pose.translation - before).max())
        before = actor.pose.translation.copy()
    stage.send(actor, "FLIP")
    for _ in range(60):
        stage.step(1)
        ways.append(np.abs(actor.pose.translation - before).max())
        before = actor.pose.translation.copy()
    assert max(ways) < 0.7  # four units come back within a fifth of a second, not in one tick


def test_a_crowd_gets_the_bits_of_one_actor():
    alone, _ = played(GEARBOX, 50)
    stage = statwalk.Stage(seed=1)
    actors = [stage.add(GEARBOX) for _ in range(37)]
    stage.step(50)
    for part, other in zip(alone.actors[0].pose, actors[-1].pose, strict=True):
        np.testing.assert_array_equal(part, other)


def test_seek_and_replay_give_the_same_hash():
    stage, actor = played(role_of("gear_a.rotate_z = 10 * frameid", "gear_b.rotate_y = sin(time) * 80"), 20)
    stage.send(actor, "FLIP")
    stage.step(100)
    expected, pose = stage.hash, actor.pose
    stage.seek(40)
    stage.seek(120)
    assert stage.hash == expected
    np.testing.assert_array_equal(actor.pose.rotation, pose.rotation)
    assert replay(stage.dump(), lambda _: actor.role).hash == expected


@pytest.mark.parametrize(
    ("lines", "line", "what"),
    [
        (["a = b", "b = c", "c = a"], 13, "circle, each reads the next: "),
        (["gear_a.rotate_z = gear_b.rotate_z", "gear_b.rotate_z = gear_a.rotate_z"], 13, "gear_b.rotate_z"),
        (["gear_a.rotate_z = gear_a.rotate_z + 1"], 13, "circle"),
        (["a = 1", "# comment", "a = 2"], 15, "a is already set in line 13"),
        (["gear_a.rotate_z = frame"], 13, "no variable is called 'frame'; did you mean frameid?"),
        (["gear_x.rotate_z = 1"], 13, "no joint is called 'gear_x'; did you mean gear"),
        (["a = 1", "gear_a.rotate_z = gear_x.rotate_z"], 14, "no joint is called 'gear_x'"),
        (["gear_a.rotate_w = 1"], 13, "no channel 'rotate_w'"),
        (["gear_a.turn = 1"], 13, "no channel 'turn'"),
        (["pace = 1"], 13, "pace is a parameter"),
        (["aim.x = 1"], 13, "aim.x is a parameter"),
        (["frameid = 1"], 13, "built in"),
        (["pi = 3"], 13, "built in"),
        (["sin = 3"], 13, "built in"),
        (["a = 1 +"], 13, "not the end"),
        (["a = __import__('os')"], 13, "no function is called '__import__'"),
        (["a = frameid.__class__"], 13, "no channel '__class__'"),
        (["a = [1]"], 13, "has no meaning"),
        (["a"], 13, "write NAME = FORMULA"),
        (["a + 1 = 2"], 13, "one name"),
        (["a = " + "(" * 40 + "1" + ")" * 40], 13, "deep"),
        (["a = " + "1 + " * 200 + "1"], 13, "longer than"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_refused_with_its_line(lines, line, what):
    with pytest.raises(MachineError) as refused:
        role_of(*lines)
    assert refused.value.place == f"line {line}"
    assert what in refused.value.message


def test_the_clock_of_a_motion_is_its_time():
    head = HEAD.replace("60 * time * pace", "60 * frameid")
    with pytest.raises(MachineError, match="the clock of a state's motion is time"):
        read_machine(head)


def test_undefined_results_are_finite():
    role = role_of(
        "gear_a.trans_x = 1 / (pace - pace)", "gear_a.scale_x = exp(900)", "gear_a.rotate_z = 1e300"
    )
    _, actor = played(role, 3)
    assert all(np.isfinite(part).all() for part in actor.pose)
    assert shift(actor, "gear_a")[0] == 0


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
