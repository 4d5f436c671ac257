"""Each of the twelve rules alone, against numbers worked out by hand (FAQ Q26)."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from statwalk.solve import rules

X, Y, Z = np.eye(3)
QUARTER_Z = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
"""a quarter turn about Z: X becomes Y"""
RANDOM = np.random.default_rng(26)


def number(value: float) -> np.ndarray:
    return np.array(float(value))


def test_rule_1_adds_the_translation_in_the_parents_space():
    start = rules.start_from_parent(np.array([1.0, 2, 3]), QUARTER_Z, np.array([0.5, 0, 0]))
    np.testing.assert_allclose(start, [1, 2.5, 3])


def test_rule_2_finds_the_translation_in_the_parents_space():
    found = rules.own_translation(QUARTER_Z, np.array([1.0, 2.5, 3]), np.array([1.0, 2, 3]))
    np.testing.assert_allclose(found, [0.5, 0, 0])


def test_rule_3_subtracts_the_translation():
    end = rules.parent_end_from_start(np.array([1.0, 2.5, 3]), QUARTER_Z, np.array([0.5, 0, 0]))
    np.testing.assert_allclose(end, [1, 2, 3])


def test_rule_4_turns_within_the_parent():
    # the parent turns X to Y; the bone turns about its parent's X, which is the character's Y
    found = rules.matrix_from_angles(QUARTER_Z, np.radians([90.0, 0, 0]))
    np.testing.assert_allclose(found @ X, Y, atol=1e-12)
    np.testing.assert_allclose(found @ Y, Z, atol=1e-12)
    np.testing.assert_allclose(found @ Z, X, atol=1e-12)


def test_rule_4_turns_about_x_first_then_y_then_z():
    angles = RANDOM.uniform(-3, 3, (50, 3))
    parents = Rotation.random(50, random_state=1).as_matrix()
    expected = parents @ Rotation.from_euler("xyz", angles).as_matrix()
    np.testing.assert_allclose(rules.matrix_from_angles(parents, angles), expected, atol=1e-12)


def test_rule_5_finds_the_angles_that_rule_4_takes():
    angles = RANDOM.uniform(-1.5, 1.5, (50, 3))
    parents = Rotation.random(50, random_state=2).as_matrix()
    matrices = parents @ Rotation.from_euler("xyz", angles).as_matrix()
    np.testing.assert_allclose(rules.angles_from_matrix(parents, matrices), angles, atol=1e-9)


def test_rule_5_in_gimbal_lock_gives_angles_of_the_same_matrix():
    matrix = Rotation.from_euler("xyz", [30, 90, 20], degrees=True).as_matrix()
    angles = rules.angles_from_matrix(np.eye(3), matrix)
    np.testing.assert_allclose(Rotation.from_euler("xyz", angles).as_matrix(), matrix, atol=1e-7)


def test_rule_6_finds_the_parents_matrix():
    found = rules.parent_matrix_from_angles(np.eye(3), np.radians([0.0, 0, 90]))
    np.testing.assert_allclose(found, QUARTER_Z.T, atol=1e-12)


def test_rule_7_goes_the_length_along_the_turned_direction():
    end = rules.end_from_start(np.array([1.0, 0, 0]), QUARTER_Z, X, number(3))
    np.testing.assert_allclose(end, [1, 3, 0])


def test_rule_8_turns_the_direction_to_the_end():
    found = rules.find_matrix(np.eye(3), X, np.array([0.0, 5, 0]))
    np.testing.assert_allclose(found, QUARTER_Z, atol=1e-12)


def test_rule_8_turns_about_the_cross_product_by_the_angle_between():
    parents = Rotation.random(100, random_state=3).as_matrix()
    directions, aims = (v / np.linalg.norm(v, axis=1)[:, None] for v in RANDOM.normal(size=(2, 100, 3)))
    old = np.einsum("nij,nj->ni", parents, directions)
    axis = np.cross(old, aims)
    axis /= np.linalg.norm(axis, axis=1)[:, None]
    turns = Rotation.from_rotvec(axis * np.arccos((old * aims).sum(1))[:, None]).as_matrix()
    np.testing.assert_allclose(rules.find_matrix(parents, directions, aims * 7), turns @ parents, atol=1e-9)


@pytest.mark.parametrize("angle", [0, 1e-9, 1e-6, 1e-3])
@pytest.mark.parametrize("sign", [1, -1])
def test_rule_8_works_for_parallel_and_opposite_vectors(sign, angle):
    direction = np.array([0.6, 0, 0.8])
    aim = sign * (direction + angle * Y)
    parent = Rotation.from_euler("x", 0.3).as_matrix()
    found = rules.find_matrix(parent, direction, parent @ aim)
    np.testing.assert_allclose(found @ direction, parent @ aim / np.linalg.norm(aim), atol=1e-9)
    np.testing.assert_allclose(found @ found.T, np.eye(3), atol=1e-12)
    assert np.linalg.det(found) == pytest.approx(1)


def test_rule_8_leaves_a_parallel_bone_as_its_parent_is():
    np.testing.assert_allclose(rules.find_matrix(QUARTER_Z, X, 2 * Y), QUARTER_Z, atol=1e-12)


def test_rule_9_goes_back_the_length():
    start = rules.start_from_end(np.array([1.0, 3, 0]), QUARTER_Z, X, number(3))
    np.testing.assert_allclose(start, [1, 0, 0])


def test_rule_10_goes_the_length_along_the_path():
    end = rules.end_along_path(np.array([1.0, 1, 1]), number(10), np.array([3.0, 0, 4]))
    np.testing.assert_allclose(end, [7, 1, 9])


def test_rule_11_takes_the_root_further_along_the_path():
    # a sphere of radius 5 about the origin and the line y = 3: roots at x = -4 and x = 4
    point, path = np.array([-10.0, 3, 0]), np.array([2.0, 0, 0])
    assert rules.joint_on_path(np.zeros(3), number(5), point, path).point == pytest.approx([4, 3, 0])
    assert rules.joint_on_path(np.zeros(3), number(5), point, -path).point == pytest.approx([-4, 3, 0])


def test_rule_11_touches_and_misses():
    path = np.array([1.0, 0, 0])
    touching = rules.joint_on_path(np.zeros(3), number(5), np.array([0.0, 5, 0]), path)
    missing = rules.joint_on_path(np.zeros(3), number(5), np.array([9.0, 7, 0]), path)
    assert touching.point == pytest.approx([0, 5, 0])
    assert touching.miss == 0
    assert missing.point == pytest.approx([0, 5, 0])
    assert missing.miss == pytest.approx(2)


@pytest.mark.parametrize(("bend", "z"), [(Z, 3), (-Z, -3), (Z + 5 * X, 3)])
def test_rule_12_takes_the_side_of_the_bend(bend, z):
    # two bones of length 5, their ends 8 apart: the joint is 4 along and 3 aside
    found = rules.joint_between(np.zeros(3), number(5), 8 * X, number(5), bend)
    assert found.point == pytest.approx([4, 0, z])
    assert found.miss == 0


def test_rule_12_with_other_lengths():
    # 3, 4, 5: a right angle at the joint
    found = rules.joint_between(np.zeros(3), number(3), 5 * X, number(4), Y)
    assert found.point == pytest.approx([9 / 5, 12 / 5, 0])


def test_rule_12_out_of_reach_and_folded():
    far = rules.joint_between(np.zeros(3), number(2), 10 * X, number(3), Y)
    near = rules.joint_between(np.zeros(3), number(5), 1 * X, number(2), Y)
    assert far.point == pytest.approx([2, 0, 0])
    assert far.miss == pytest.approx(5)
    assert near.point == pytest.approx([5, 0, 0])
    assert near.miss == pytest.approx(2)


def test_rule_12_with_one_centre_goes_along_the_bend():
    found = rules.joint_between(Y, number(2), Y, number(2), 3 * Z)
    assert found.point == pytest.approx([0, 1, 2])
    assert found.miss == 0


def test_rule_12_with_a_bend_along_the_axis_still_keeps_both_lengths():
    found = rules.joint_between(np.zeros(3), number(5), 8 * X, number(5), X)
    assert np.linalg.norm(found.point) == pytest.approx(5)
    assert np.linalg.norm(found.point - 8 * X) == pytest.approx(5)


def test_rules_work_over_frames():
    ends = np.array([[8.0, 0, 0], [0, 6, 0]])
    found = rules.joint_between(np.zeros(3), number(5), ends, number(5), Z)
    np.testing.assert_allclose(found.point, [[4, 0, 3], [0, 3, 4]], atol=1e-12)
