"""IK15: the target of a look-at may be a direction, and the end of a limb may be given a rotation."""

import numpy as np
import pytest
import statwalk
from reaching import ARM, text_of
from scipy.spatial.transform import Rotation
from statwalk.character.role import Role
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.stage.stage import Stage

PLACE, HEADING = (1.0, 0.0, 2.0), 0.6
AHEAD_DOWN = np.array([0.6, -0.48, 0.64])
HAND = Rotation.from_euler("XYZ", (0.4, -0.7, 0.2))
TURNED = Rotation.from_euler("Y", HEADING)
LOOK = "look: {solver: look-at, chain: [Upperback, Head], target: side"
REACH = f"reach: {{solver: two-bone, chain: {ARM}, target: grip, space: model"


def standing(solver, palm="{kind: rotation}"):
    """An actor with this solver, turned by HEADING."""
    text = text_of(solver).replace("  side:", f"  palm: {palm}\n  side:")
    stage = Stage()
    role = Role.build("reacher", statwalk.load("faq-walker").character, read_machine(text), "Root")
    return stage, stage.add(role, PLACE, HEADING)


def rotation_of(actor, name):
    return Rotation.from_matrix(actor.world[actor.role.character.skeleton.index(name), :3, :3])


def degrees_off(sight, direction):
    return np.degrees(np.arccos(np.clip(sight @ direction, -1, 1)))


@pytest.mark.parametrize(("space", "aim"), [("stage", AHEAD_DOWN), ("model", TURNED.apply(AHEAD_DOWN))])
def test_he_looks_along_a_direction(space, aim):
    stage, actor = standing(f"{LOOK}, space: {space}}}")
    stage.set(actor, "side", 7 * AHEAD_DOWN)
    stage.step(2)
    assert degrees_off(rotation_of(actor, "Head").apply((0, 0, 1)), aim) < 0.01
    assert actor.reached["look"].reached
    assert actor.reached["look"].distance < 1e-4


def test_a_direction_is_the_same_from_everywhere():
    stage, actor = standing(f"{LOOK}}}")
    other = stage.add(actor.role, (500.0, 0.0, -300.0), HEADING)
    for who in (actor, other):
        stage.set(who, "side", AHEAD_DOWN)
    stage.step(2)
    np.testing.assert_array_equal(actor.pose.rotation, other.pose.rotation)


def test_the_distance_of_a_direction_is_that_of_a_point_one_metre_away():
    stage, actor = standing(f"{LOOK}, space: model, cone_deg: 30}}")
    stage.set(actor, "side", (np.sin(np.radians(50)), 0, np.cos(np.radians(50))))
    stage.step(2)
    assert actor.reached["look"].distance == pytest.approx(np.sin(np.radians(20)), abs=1e-4)
    assert not actor.reached["look"].reached


@pytest.mark.parametrize(("space", "wanted"), [("stage", HAND), ("model", TURNED * HAND)])
def test_the_end_gets_its_rotation(space, wanted):
    stage, actor = standing(f"{REACH.replace('model', space)}, rotation: palm}}")
    stage.set(actor, "grip", (1.05, 1.2, 2.45) if space == "stage" else (-0.35, 1.2, 0.3))
    stage.set(actor, "palm", HAND.as_quat())
    stage.step(2)
    assert (rotation_of(actor, "Right.hand").inv() * wanted).magnitude() < 1e-3
    assert actor.reached["reach"].reached


def test_a_rotation_may_be_written_in_the_file_in_model_space():
    numbers = ", ".join(map(str, HAND.as_quat()))
    stage, actor = standing(f"{REACH}, rotation: [{numbers}]}}")
    stage.step(2)
    assert (rotation_of(actor, "Right.hand").inv() * (TURNED * HAND)).magnitude() < 1e-3


def test_a_smoothed_rotation_goes_the_short_way_whatever_its_sign():
    stage, actor = standing(f"{REACH}, rotation: palm}}", palm="{kind: rotation, smooth: 0.5}")
    stage.set(actor, "palm", -(Rotation.from_euler("X", 0.2).as_quat()))
    turns = []
    for _ in range(60):
        stage.step()
        turns.append((TURNED.inv() * rotation_of(actor, "Right.hand")).magnitude())
    assert turns[0] < 0.05
    assert max(turns) < 0.2 + 1e-3
    assert turns[-1] == pytest.approx(0.2, abs=1e-3)


def test_alone_in_a_crowd_and_replayed_the_bits_are_the_same():
    solvers = f"{LOOK}}}\n  {REACH}, rotation: palm}}"
    stage, first = standing(solvers)
    for k in range(18):
        stage.add(first.role, (k, 0, 0))
    alone, lone = standing(solvers)
    for where, who in ((stage, first), (alone, lone)):
        where.set(who, "side", AHEAD_DOWN)
        where.set(who, "palm", HAND.as_quat())
        where.step(20)
    assert first.hash == lone.hash
    after = stage.hash
    stage.seek(3)
    stage.seek(20)
    assert stage.hash == after
