"""EX1 expressions (FAQ Q24): the corrected gearbox, dependency order, what is refused, and what replays.

The channels of an actor are compared with formulas in plain Python, and with SciPy's Euler angles.
"""

import math

import numpy as np
import pytest
import statwalk
from scipy.spatial.transform import Rotation
from statwalk.character.role import Role
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.machine_file import read_machine
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


@pytest.mark.parametrize("actors", [1, 18])
def test_the_report_has_what_the_tick_set_though_limits_change_what_was_read(actors):
    text = machine(
        ["gear_a.rotate_z = 80", "rack_c.trans_y = 0.5 * gear_b.trans_x", "half = gear_a.rotate_z"]
    )
    text += "joints:\n  gear_a: {type: revolute, axis: [0, 0, 1], angle_deg: [-45, 45]}\n"
    text += "limits: {gear_b: {translation: [[-3, 0, 0], [-2, 0, 0]]}}\n"
    stage, role = statwalk.Stage(), Role.build("box", GEARBOX.character, read_machine(text))
    everyone = [stage.add(role) for _ in range(actors)]
    stage.step(3)
    actor = everyone[-1]
    assert (angles(actor, "gear_a")[2], shift(actor, "gear_b")[0]) == pytest.approx((45, 18 - 2), abs=1e-4)
    assert shift(actor, "rack_c")[1] == pytest.approx(9)
    assert actor.channels == {"gear_a.rotate_z": 80, "rack_c.trans_y": 9}
    assert actor.variables == {"half": 80}


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


def test_in_an_additive_layer_it_adds_what_it_makes_of_the_pose_at_rest():
    motion = "{expressions: [gear_b.rotate_z = pace + 10]}"
    layer = (
        f"layers:\n  over:\n    mask: [gear_b]\n    mode: additive\n    initial: LEAN\n"
        f"    states: {{LEAN: {{motion: {motion}}}}}\n    table: |\n      state | END\n      LEAN  |\n"
    )
    head = HEAD.replace("table: |", layer + "table: |", 1)
    role = Role.build("box", GEARBOX.character, read_machine(head))
    stage, actor = played(role)
    stage.set(actor, "pace", 7.0)
    stage.step(2)
    assert angles(actor, "gear_b")[2] == pytest.approx(17, abs=1e-3)


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
