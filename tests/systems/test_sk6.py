"""SK6 constraints (FAQ Q13): the FAQ's table, limits in files, the clamp of the tick, the report."""

import numpy as np
import pytest
from chain_bodies import chain_of, role_with
from paths import ASSETS, GLTF, needs_assets
from scipy.spatial.transform import Rotation
from statwalk import load
from statwalk.errors import ContentError, TextError
from statwalk.files.faq.constraint_text import read_constraints, write_constraints
from statwalk.rig.joint_types import joint
from statwalk.stage.stage import Stage

TABLE = """#name          rotation min max        translation min max
------------------------------------------------------------------
Left.upperleg  0 -45 0   0 45 0        0 0 0      0 0 0
"""
SKELETON = "Root --- - - - -\nLeft.upperleg Root 4 0 -1 0\nLeft.lowerleg Left.upperleg 3 0 -1 0\n"
KEYS = "#time 0\n#rotate Left.upperleg 20 0 0\n#time 1\n#rotate Left.upperleg 0 80 0\n"


def character(tmp_path, **more):
    """A character file of a leg whose thigh twists to 80 degrees, with further entries."""
    (tmp_path / "leg.txt").write_text(SKELETON)
    (tmp_path / "kick.txt").write_text(KEYS)
    (tmp_path / "limits.txt").write_text(TABLE)
    entries = {"skeleton": "leg.txt", **more, "clips": "{kick: {keys: kick.txt}}"}
    path = tmp_path / "leg.yaml"
    path.write_text("".join(f"{name}: {value}\n" for name, value in entries.items()))
    return path


def role(tmp_path, more="", **of_character):
    character(tmp_path, **of_character)
    (tmp_path / "machine.yaml").write_text(
        "character: leg.yaml\ninitial: KICK\nstates: {KICK: {motion: kick}}\n"
        f"table: |\n  state | GO | END\n  KICK | |\n{more}"
    )
    return load(tmp_path)


def thigh(actor):
    return Rotation.from_quat(actor.pose.rotation[1]).as_euler("xyz", degrees=True)


def after(kicking, ticks=120):
    stage = Stage()
    actor = stage.add(kicking)
    stage.step(ticks)
    return actor


def test_the_faqs_table_is_read_and_written():
    (row,) = read_constraints(TABLE).values()
    assert np.degrees(row.limit.angles).round(9).tolist() == [[0, 0], [-45, 45], [0, 0]]
    assert (row.limit.slide, row.line) == (((0, 0),) * 3, 3)
    again = read_constraints(write_constraints({"Left.upperleg": row.limit}))
    assert again["Left.upperleg"] == row


@pytest.mark.parametrize(
    ("row", "words"),
    [
        ("Leg 0 45 0 0 -45 0 0 0 0 0 0 0", "rotation of Leg along Y is more than its maximum: 45 > -45"),
        ("Leg 0 0 0 0 0 0 0 0 1 0 0 0", "translation of Leg along Z is more than its maximum: 1 > 0"),
        ("Leg 0 0 0", "a name and twelve numbers"),
        ("Leg 0 0 0 0 0 0 0 0 0 0 0 nan", "should be numbers"),
        ("Leg 0 0 0 0 0 0 0 0 0 0 0 0\nLeg 0 0 0 0 0 0 0 0 0 0 0 0", "twice, first in line 2 of the table"),
    ],
)
def test_a_wrong_row_is_refused_with_its_line(row, words):
    with pytest.raises(TextError, match=words) as error:
        read_constraints(f"# a comment\n{row}")
    assert error.value.place == f"line {2 + row.count(chr(10))}"


@pytest.mark.parametrize(
    "entries",
    [
        {"limits": "limits.txt"},
        {"limits": "{Left.upperleg: {rotation_deg: [[0, -45, 0], [0, 45, 0]]}}"},
        {"joints": "{Left.upperleg: {type: revolute, form: twist, angle_deg: [-45, 45]}}"},
    ],
)
def test_limits_of_a_character_file_hold_in_the_tick(tmp_path, entries):
    actor = after(role(tmp_path, **entries))
    np.testing.assert_allclose(thigh(actor), [0, 45, 0], atol=1e-3)
    (clamped,) = actor.clamped
    assert (clamped.joint, np.degrees(clamped.angle)) == ("Left.upperleg", pytest.approx(35, abs=1e-3))


def test_a_machine_limits_its_character_and_its_first_pose(tmp_path):
    limits = "limits: |\n  Left.upperleg  0 -45 0   0 45 0   0 0 0   0 0 0\n"
    np.testing.assert_allclose(thigh(after(role(tmp_path, limits), 0)), 0, atol=1e-4)
    np.testing.assert_allclose(thigh(after(role(tmp_path, limits))), [0, 45, 0], atol=1e-3)


def test_without_limits_nothing_is_clamped_and_inside_them_no_bit_changes(tmp_path):
    wide = "limits: {Left.upperleg: {rotation_deg: [[-90, -90, -90], [90, 90, 90]]}}\n"
    free, inside = after(role(tmp_path)), after(role(tmp_path, wide))
    assert (free.clamped, inside.clamped) == ((), ())
    assert free.hash == inside.hash


@pytest.mark.parametrize(
    ("more", "words", "line"),
    [
        ("limits: {Leg: {}}\n", "no joint|no such|'Leg'", 7),
        ("joints:\n  Root: {type: revolute, angle_deg: [9, 1]}\n", "minimum of angle_deg is more", 8),
        ("joints:\n  Root: {type: ball}\n", "'ball'", 8),
        ("joints:\n  Root: {type: spherical, swing_x_deg: [-95, 5]}\n", "less than 90 degrees", 8),
        ("limits: |\n  Root 0 0 0\n", "twelve numbers", 8),
        ("limits: {Root: {rotation_deg: [[0, 0, 9], [0, 0, 0]]}}\n", "minimum of Z", 7),
    ],
)
def test_wrong_limits_of_a_machine_are_refused_with_file_and_line(tmp_path, more, words, line):
    with pytest.raises(ContentError, match=words) as error:
        role(tmp_path, more)
    assert (error.value.file or "").endswith("machine.yaml")
    assert error.value.place == f"line {line}"


def test_an_unknown_joint_in_the_table_names_the_tables_file(tmp_path):
    path = character(tmp_path, limits="limits.txt")
    (tmp_path / "limits.txt").write_text(TABLE.replace("Left.upperleg ", "Left.upperlag "))
    with pytest.raises(TextError, match=r"Left\.upperleg") as error:
        load(path)
    assert (error.value.file or "").endswith("limits.txt")
    assert error.value.place == "line 3"


TWO = chain_of((0, 0, 0), (1, 0, 0), (2, 0, 0))
KNEE = {"J1": joint("revolute", {"angle": (np.radians(-30), np.radians(30))}, axis=(0, 0, 1))}
HIP = {"J0": joint("revolute", {"angle": (np.radians(-20), np.radians(20))}, axis=(0, 0, 1))}


def test_a_solver_reports_by_how_much_it_was_clamped():
    """A target at a right angle: the exact knee bends by 90 degrees, its hinge ends at 30."""
    answer = TWO.solve(TWO.bind_pose, ("J0", "J1", "J2"), (1, 1, 0), pole=(0, -1, 0), limits=KNEE)
    assert {name: np.degrees(angle) for name, angle in answer.clamped.items()} == {
        "J1": pytest.approx(60, abs=0.01)
    }
    inside = TWO.solve(TWO.bind_pose, ("J0", "J1", "J2"), (1.95, 0.1, 0), pole=(0, -1, 0), limits=KNEE)
    assert (bool(inside.reached), inside.clamped) == (True, {})


@pytest.mark.parametrize("solver", ["ccd", "fabrik", "look-at"])
def test_iterations_report_their_last_turn(solver):
    """The bone wants to point along Y, 90 degrees away; the hinge ends at 20."""
    sight = {"forward": (1, 0, 0), "chain": ["J0"]} if solver == "look-at" else {"chain": ["J0", "J1"]}
    answer = TWO.solve(TWO.bind_pose, target=(0, 1, 0), solver=solver, limits=HIP, **sight)
    assert np.degrees(answer.clamped["J0"]) == pytest.approx(70, abs=0.05)
    many = TWO.solve(
        TWO.clip("rest").sample(np.zeros(18)), target=[(0, 1, 0)] * 9 + [(1, 0.1, 0)] * 9, solver=solver,
        limits=HIP, **sight,
    )  # fmt: skip
    np.testing.assert_array_equal(many.clamped["J0"][:9], answer.clamped["J0"])
    assert (many.clamped["J0"][9:] < 1e-3).all()


LIMITED = """joints:
  J0: {type: revolute, axis: [0, 0, 1], angle_deg: [-20, 20]}
solvers:
  go: {solver: ccd, chain: [J0, J1], target: grip, weight: held}"""


def test_the_tick_reports_what_solvers_clamped_and_forgets_it():
    stage = Stage()
    actors = stage.add_many(role_with(TWO, LIMITED), [((0, 0, 0), 0.0)] * 18)
    for actor, weight in zip(actors, [1, 0] * 9, strict=True):
        stage.set(actor, "grip", (0.0, 1.0, 0.0))
        stage.set(actor, "held", weight)
    stage.step(3)
    for actor, weight in zip(actors, [1, 0] * 9, strict=True):
        found = [(clamped.joint, clamped.by, np.degrees(clamped.angle)) for clamped in actor.clamped]
        assert found == ([("J0", "solver", pytest.approx(70, abs=0.05))] if weight else [])
    stage.set(actors[0], "held", 0)
    stage.step()
    assert actors[0].clamped == ()


@needs_assets
@pytest.mark.parametrize("model", ["KayKit_Knight.glb", "cmu_12_01_walk.bvh"])
def test_a_character_file_gives_limits_to_a_model(tmp_path, model):
    source = GLTF / model if model.endswith("glb") else ASSETS / "bvh" / model
    bare = load(source)
    head = next(name for name in bare.skeleton.names if name.lower() == "head")
    (tmp_path / model).symlink_to(source)
    file = tmp_path / "limited.yaml"
    hinge = "{type: revolute, axis: [0, 1, 0], angle_deg: [0, 9]}"
    file.write_text(f"name: limited\nmodel: {model}\njoints:\n  {head}: {hinge}\n")
    character = load(file)
    assert (character.name, character.limits[head].type) == ("limited", "revolute")
    assert character.skeleton.names == bare.skeleton.names
    file.write_text(f"model: {model}\nlimits: {{Nose: {{}}}}\n")
    with pytest.raises(ContentError, match="'Nose'") as error:
        load(file)
    assert error.value.place == "line 2"


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("model: other.yaml\n", "must name a .glb, .vrm, .gltf, .* file"),
        ("model: ../knight.glb\n", "in the folder of this file"),
        ("model: knight.glb\nskeleton: mammal\n", "skeleton"),
        ("model: knight.glb\n", "must name a .glb"),
    ],
)
def test_a_wrong_model_of_a_character_file_is_refused(tmp_path, text, words):
    (tmp_path / "limited.yaml").write_text(text)
    with pytest.raises(ContentError, match=words):
        load(tmp_path / "limited.yaml")
