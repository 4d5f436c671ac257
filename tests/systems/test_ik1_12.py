"""IK1 to IK12 the twelve rules over chains of bones (FAQ Q26): what is found by which rule, and what stays
unknown.

Hand-made skeletons whose answers follow from 3-4-5 triangles and quarter turns; the FAQ's mammal against its
own evaluation; a captured walk against another reader of BVH.
"""

import numpy as np
import pytest
from paths import GROUND_TRUTH, needs_assets
from scipy.spatial.transform import Rotation
from statwalk.character.character import Character
from statwalk.character.deduce import deduce
from statwalk.errors import ContentError, UnknownNameError
from statwalk.files.faq.skeleton_text import read_skeleton, shipped_skeleton
from statwalk.maths.pose import Pose
from statwalk.rig.skeleton import Skeleton

ARM = read_skeleton("upper --- 5 1 0 0\nfore upper 5 1 0 0\n")
THREE = read_skeleton("a --- 2 1 0 0\nb a 3 1 0 0\nc b 1 1 0 0\n")
MAMMAL = shipped_skeleton("mammal")


def source(found, bone, quantity):
    return found[bone][quantity].source


def test_forward_rules_1_4_7_through_a_chain():
    found = deduce(
        THREE, {"a": {"RA": [0, 0, np.pi / 2]}, "b": {"RA": [0, 0, -np.pi / 2]}, "c": {"RA": [0, 0, 0]}}
    )
    assert [source(found, "b", name) for name in ("SP", "RM", "EP")] == ["rule 1", "rule 4", "rule 7"]
    assert found["c"]["EP"].value == pytest.approx([4, 2, 0])
    assert found.unknown == ()


def test_the_mammal_forward_is_its_own_evaluation():
    turns = Rotation.from_euler("xyz", np.random.default_rng(26).uniform(-1, 1, (20, 3)))
    frames = MAMMAL.evaluate(turns.as_quat())
    angles = dict(zip(MAMMAL.skeleton.names, turns.as_euler("xyz"), strict=True))
    found = deduce(MAMMAL, {name: {"RA": angle} for name, angle in angles.items()})
    for bone, name in enumerate(MAMMAL.skeleton.names):
        np.testing.assert_allclose(found[name]["EP"].value, frames.end[bone], atol=1e-9)


def test_rules_2_5_9_backward():
    # the forearm's matrix and end are known: its start follows; the given start of its child gives TR
    moved = deduce(
        THREE,
        {"a": {"RA": [0, 0, 0], "EP": [2, 0, 0]}, "b": {"RM": np.eye(3), "EP": [6, 0, 0], "TR": None}},
    )
    assert source(moved, "b", "SP") == "rule 9"
    assert moved["b"]["SP"].value == pytest.approx([3, 0, 0])
    assert source(moved, "b", "TR") == "rule 2"
    assert moved["b"]["TR"].value == pytest.approx([1, 0, 0])
    assert source(moved, "b", "RA") == "rule 5"
    assert source(moved, "a", "SP") == "rule 9"


def test_rule_3_the_start_of_a_child_is_the_end_of_its_parent():
    found = deduce(ARM, {"upper": {"SP": [0, 0, 0]}, "fore": {"SP": [0, 5, 0], "EP": [0, 5, 5]}})
    assert source(found, "upper", "EP") == "rule 3"
    assert source(found, "upper", "RM") == "rule 8"
    assert source(found, "fore", "RM") == "rule 8"
    assert np.degrees(found["upper"]["RA"].value) == pytest.approx([0, 0, 90])
    assert found["fore"]["RM"].value @ [1, 0, 0] == pytest.approx([0, 0, 1])


def test_rule_6_gives_the_parents_matrix():
    found = deduce(THREE, {"b": {"RA": [0, 0, np.pi / 2], "RM": np.eye(3)}, "a": {"RA": None}, "c": {}})
    assert source(found, "a", "RM") == "rule 6"
    assert found["a"]["RM"].value @ [1, 0, 0] == pytest.approx([0, -1, 0])
    assert source(found, "a", "RA") == "rule 5"


def test_rule_10_a_bone_points_along_its_path():
    found = deduce(ARM, {"upper": {"RA": [0, 0, 0]}, "fore": {"path": [[0, 0, 0], [0, 0, 9]]}})
    assert source(found, "fore", "EP") == "rule 10"
    assert found["fore"]["EP"].value == pytest.approx([5, 0, 5])


def test_rules_10_and_11_are_a_slider_crank():
    # a rod of length 5 from (0, 3, 0) to a piston that slides along X, and points along it
    found = deduce(ARM, {"upper": {"SP": [0, 3, 0]}, "fore": {"path": [[-1, 0, 0], [1, 0, 0]]}})
    assert source(found, "upper", "EP") == "rule 11"
    assert found["upper"]["EP"].value == pytest.approx([4, 0, 0])
    assert source(found, "fore", "EP") == "rule 10"
    assert found["fore"]["EP"].value == pytest.approx([9, 0, 0])
    assert found.unknown == ()


def test_rule_12_bends_the_elbow_and_rule_8_turns_both_bones():
    known = {"upper": {"SP": [0, 0, 0]}, "fore": {"EP": [8, 0, 0], "bend": [0, -2, 0]}}
    found = deduce(ARM, known)
    assert source(found, "upper", "EP") == "rule 12"
    assert found["upper"]["EP"].value == pytest.approx([4, -3, 0])
    assert source(found, "fore", "RM") == "rule 8"
    assert found["fore"]["RM"].value @ [1, 0, 0] == pytest.approx([0.8, 0.6, 0])
    assert found.unknown == ()


def test_without_a_bend_the_elbow_stays_unknown():
    found = deduce(ARM, {"upper": {"SP": [0, 0, 0]}, "fore": {"EP": [8, 0, 0]}})
    assert found.unknown == (
        ("upper", "RA"), ("upper", "RM"), ("upper", "EP"), ("fore", "RA"), ("fore", "RM"), ("fore", "SP"),
    )  # fmt: skip


def test_rules_11_and_12_need_a_joint_without_translation():
    found = deduce(
        ARM, {"upper": {"SP": [0, 0, 0]}, "fore": {"EP": [8, 0, 0], "bend": [0, 1, 0], "TR": [0, 1, 0]}}
    )
    assert ("upper", "EP") in found.unknown


def test_frames_are_deduced_together():
    ends = np.array([[8.0, 0, 0], [0, 8, 0]])
    found = deduce(ARM, {"upper": {"SP": [0, 0, 0]}, "fore": {"EP": ends, "bend": [0, 0, 1]}})
    np.testing.assert_allclose(found["upper"]["EP"].value, [[4, 0, 3], [0, 4, 3]], atol=1e-12)
    np.testing.assert_allclose(
        found["fore"]["RM"].value @ [1, 0, 0], [[0.8, 0, -0.6], [0, 0.8, -0.6]], atol=1e-12
    )


def test_expressions_are_rules():
    found = deduce(
        ARM,
        {"upper": {"RA": [0, 0, np.pi / 2]}},
        ["bend = -0.5 * upper.rotate_z", "fore.rotate_z = bend", "fore.rotate_x = 0", "fore.rotate_y = 0"],
    )
    assert np.degrees(found["fore"]["RA"].value) == pytest.approx([0, 0, -45])
    assert found["fore"]["RA"].source == "expression, line 2"
    assert found.variables["bend"].value == pytest.approx(-45)
    assert found["fore"]["EP"].value == pytest.approx([5 / 2**0.5, 5 + 5 / 2**0.5, 0])


def test_a_component_alone_leaves_the_angles_unknown():
    found = deduce(ARM, {"upper": {"RA": [0, 0, 0]}}, ["fore.rotate_z = 10"])
    assert ("fore", "RA") in found.unknown


@needs_assets
@pytest.mark.parametrize("name", ["cmu_12_01_walk", "01_01", "dab", "bvh_test1"])
def test_a_walks_markers_give_back_its_bone_directions(name):
    truth = np.load(GROUND_TRUTH / "bvh" / f"{name}.bvh.gt.npz")
    names = tuple(f"{joint} {k}" for k, joint in enumerate(truth["names"]))
    joints, places = len(names), truth["position_replace"]
    skeleton = Skeleton(names, truth["parent"].astype(np.int32))
    rest = Pose(truth["offset"], np.tile([0.0, 0, 0, 1], (joints, 1)), np.ones((joints, 3)), np.zeros(0))
    walker = Character("walker", skeleton, np.arange(joints, dtype=np.int32), rest)
    found = deduce(walker, {joint: {"SP": places[:, k]} for k, joint in enumerate(names)})
    compared = 0
    for joint, values in found.values.items():
        children = [
            k for k in range(joints) if names[truth["parent"][k]] == joint and truth["parent"][k] >= 0
        ]
        child = next((k for k in children if truth["offset"][k].any()), None)
        if child is None:
            continue
        way = places[:, child] - places[:, names.index(joint)]
        direction = values["RM"].value @ values["DIR"].value
        np.testing.assert_allclose(direction, way / np.linalg.norm(way, axis=1)[:, None], atol=1e-4)
        np.testing.assert_allclose(values["EP"].value, places[:, child], atol=1e-4)
        compared += 1
    assert compared > 15


@needs_assets
def test_a_knee_without_a_marker_is_found_between_hip_and_ankle():
    truth = np.load(GROUND_TRUTH / "bvh" / "cmu_12_01_walk.bvh.gt.npz")
    hip, knee, ankle = (truth["position_replace"][:, k] for k in (2, 3, 4))
    thigh, shin = (np.linalg.norm(truth["offset"][k]) for k in (3, 4))
    leg = read_skeleton(f"thigh --- {thigh} 0 -1 0\nshin thigh {shin} 0 -1 0\n")
    true_bend = knee - (hip + ankle) / 2
    found = deduce(leg, {"thigh": {"SP": hip}, "shin": {"EP": ankle, "bend": true_bend}})
    np.testing.assert_allclose(found["shin"]["SP"].value, knee, atol=1e-3)


@pytest.mark.parametrize(
    ("known", "place", "what"),
    [
        ({"upper": {"SP": [0, 0, 0], "EP": [9, 0, 0]}}, "upper.LEN", "9 apart, but its LEN is 5"),
        ({"upper": {"RA": [0, 0, 0], "EP": [0, 5, 0], "TR": [0, 0, 0]}}, "upper.EP", "contradiction: rule 7"),
        ({"upper": {"RA": [0, 0, 0], "RM": -np.eye(3)[[1, 0, 2]]}}, "upper.RM", "contradiction: rule 4"),
        ({"upper": {"SP": [0, 0, 0]}, "fore": {"EP": [11, 0, 0], "bend": [0, 1, 0]}}, "upper.EP", "by 1;"),
        ({"upper": {"SP": [0, 0, 0]}, "fore": {"path": [[0, 7, 0], [1, 7, 0]]}}, "upper.EP", "by 2;"),
        ({"upper": {"LEN": -1}}, "upper.LEN", "negative"),
        ({"upper": {"SP": [0, 0]}}, "upper.SP", "3 numbers are needed"),
        ({"upper": {"SP": [0, 0, np.nan]}}, "upper.SP", "finite"),
        ({"upper": {"SP": ["x", 0, 0]}}, "upper.SP", "numbers are needed"),
        ({"upper": {"RM": np.ones((3, 3))}}, "upper.RM", "no rotation matrix"),
        ({"upper": {"DIR": [0, 0, 0]}}, "upper.DIR", "direction"),
        ({"fore": {"path": [[1, 1, 1], [1, 1, 1]]}}, "fore.path", "from one point to another"),
        ({"upper": [1, 2]}, "upper", "quantity: value"),
        (
            {"upper": {"SP": np.zeros((4, 3))}, "fore": {"bend": [0, 1, 0], "EP": np.ones((5, 3))}},
            "fore.EP",
            "(5,) frames here, (4,) in",
        ),
    ],
)
def test_contradictions_and_impossible_values_are_errors(known, place, what):
    with pytest.raises(ContentError) as refused:
        deduce(ARM, known)
    assert refused.value.place == place
    assert what in refused.value.message


@pytest.mark.parametrize(
    ("lines", "what"),
    [
        (["fore.rotate_z = other"], "no line sets other"),
        (["fore.rotate_w = 1"], "no channel is called 'rotate_w'"),
        (["far.rotate_z = 1"], "no bone is called 'far'"),
        (["a = b", "b = a"], "circle"),
        (["upper.length = 7"], "contradiction: upper.length = 7 gives 7, but upper.length is 5"),
    ],
)
def test_wrong_expressions_are_errors(lines, what):
    with pytest.raises((ContentError, UnknownNameError), match=what):
        deduce(ARM, {}, lines)


@pytest.mark.parametrize(
    ("asked", "what"),
    [
        ({"tolerance": -1}, "tolerance: -1 is no number from 0 to 1"),
        ({"tolerance": "low"}, "tolerance: 'low' is no number from 0 to 1"),
        ({"known": [{"upper": {}}]}, "known: known values are written {bone: {quantity: value}}"),
        ({"known": None}, "known: known values are written"),
        (
            {"bones": ["upper"]},
            "bones: .*direction}}, the bones of a skeleton table or a character are needed, not list",
        ),
        ({"bones": {}}, "bones: there are no bones"),
        ({"bones": {"a": [5]}}, r"bones.a: a bone has parent, length, direction, not \[5\]"),
        ({"bones": {"a": {"long": 5}}}, "bones.a: a bone has parent, length, direction, not {'long': 5}"),
        ({"bones": {"a": {"length": "5 m"}}}, "bones.a.length: a number is needed, not '5 m'"),
        ({"bones": {"a": {"length": -5}}}, "bones.a: a length is 0 or more, not -5"),
        ({"bones": {"a": {"direction": (0, 1)}}}, r"bones.a.direction: 3 numbers are needed, not \(0, 1\)"),
        ({"bones": {"a": {"parent": "b"}}}, "bones.a: no bone is called 'b'"),
        ({"expressions": 3}, "expressions: a text or a list of lines is needed, not 3"),
        ({"expressions": [3]}, r"expressions: a text or a list of lines is needed, not \[3\]"),
    ],
)
def test_what_is_no_question_is_refused_in_words(asked, what):
    with pytest.raises(ContentError, match=what):
        deduce(**{"bones": ARM, "known": {}} | asked)


def test_bones_of_ones_own_are_rows_in_any_order_and_expressions_a_text():
    fore = {"parent": "upper", "length": 5, "direction": (0, -2, 0)}
    rows = {"fore": fore, "upper": {"length": 5, "direction": [0, -1, 0]}}
    known = {"upper": {"SP": [0, 0, 0]}, "fore": {"EP": [0, -8, 0], "bend": [0, 0, 1]}}
    found = deduce(rows, known, "half = 0.5 * fore.rotate_x\n# a right triangle: 3, 4, 5")
    np.testing.assert_allclose(found["upper"]["EP"].value, [0, -4, 3], atol=1e-12)
    assert float(found.variables["half"].value) == pytest.approx(np.degrees(np.arctan2(3, 4)))


def test_what_was_found_prints_on_one_line():
    assert repr(deduce(ARM, {"upper": {"SP": [0, 0, 0]}})).startswith("Deduction(2 bones, ")


def test_unknown_names_are_errors():
    with pytest.raises(UnknownNameError, match="did you mean fore"):
        deduce(ARM, {"for": {"SP": [0, 0, 0]}})
    with pytest.raises(UnknownNameError, match="no quantity is called 'XP'"):
        deduce(ARM, {"fore": {"XP": [0, 0, 0]}})
