"""SK3 moving a skeleton (FAQ Q12): rotation, translation (recoil) and length (growth) of a bone, all of them
keyed.
"""

import numpy as np
import pytest
import statwalk
from text_character import from_text, keyed, place

TREE = "Root --- - - - -\nTrunk Root 4 0 1 0\nBranch Trunk 2 1 0 0\nTwig Branch 1 1 0 0\n"


def test_rotations_are_about_the_parents_x_then_y_then_z(tmp_path):
    tree = from_text(tmp_path, TREE, bend=("#rotate Branch 90 0 90", "interpolation: slerp"))
    twig = place(tree, tree.clip("bend").sample(0.0), "Twig")
    np.testing.assert_allclose(twig, [0, 6, 0], atol=1e-6)  # x stays x under X, and becomes y under Z


@pytest.mark.parametrize(("time", "length"), [(0.0, 0), (1.0, 1), (2.0, 2)])
def test_a_growing_bone_carries_its_children_along_its_direction(tmp_path, time, length):
    tree = from_text(
        tmp_path, TREE, grow=("#time 0\n#length Branch 0\n#time 2\n#length Branch 2", "interpolation: linear")
    )
    pose = tree.clip("grow").sample(time)
    np.testing.assert_allclose(place(tree, pose, "Twig"), [length, 4, 0], atol=1e-6)
    np.testing.assert_allclose(place(tree, pose, "Twig.end"), [length + 1, 4, 0], atol=1e-6)


@pytest.mark.parametrize(("time", "tip"), [(0.0, 0), (1.0, 0.5), (2.0, 1)])
def test_a_limb_at_the_end_grows_too(tmp_path, time, tip):
    tree = from_text(
        tmp_path, TREE, grow=("#time 0\n#length Twig 0\n#time 2\n#length Twig 1", "interpolation: linear")
    )
    np.testing.assert_allclose(
        place(tree, tree.clip("grow").sample(time), "Twig.end"), [2 + tip, 4, 0], atol=1e-6
    )


@pytest.mark.parametrize("time", [0.0, 0.5, 2.0])
def test_the_drawn_bone_grows_with_its_length(tmp_path, time):
    tree = from_text(
        tmp_path, TREE, grow=("#time 0\n#length Branch 0\n#time 2\n#length Branch 2", "interpolation: linear")
    )
    (part,) = [
        part for part in tree.vertices(tree.clip("grow").sample(time)) if part.node >= len(tree.skeleton)
    ]
    assert np.ptp(part.positions[:, 0]) == pytest.approx(time, abs=1e-6)


def test_recoil_moves_a_bone_and_what_hangs_on_it(tmp_path):
    recoil = keyed([0, 1], "#translate", "Branch", np.array([[0, 0, 0], [-0.5, 0, 0]]))
    tree = from_text(tmp_path, TREE, shot=(recoil, "interpolation: linear"))
    pose = tree.clip("shot").sample(1.0)
    np.testing.assert_allclose(place(tree, pose, "Branch"), [-0.5, 4, 0], atol=1e-6)
    np.testing.assert_allclose(place(tree, pose, "Twig"), [1.5, 4, 0], atol=1e-6)


@pytest.mark.parametrize(("time", "height"), [(0.0, 0), (1.0, 2), (2.0, 4)])
def test_length_and_recoil_at_different_times_add_up(tmp_path, time, height):
    keys = "#time 0\n#length Trunk 0\n#time 1\n#translate Branch 0 0 1\n#time 2\n#length Trunk 4"
    tree = from_text(tmp_path, TREE, both=(keys, "interpolation: linear"))
    np.testing.assert_allclose(
        place(tree, tree.clip("both").sample(time), "Branch"), [0, height, 1], atol=1e-6
    )


def test_units_are_scaled_to_metres(tmp_path):
    tree = from_text(tmp_path, TREE, 0.5, shot=("#translate Branch 0 0 1", "interpolation: linear"))
    np.testing.assert_allclose(place(tree, tree.clip("shot").sample(0.0), "Branch"), [0, 2, 0.5], atol=1e-6)


@pytest.mark.parametrize(("time", "length"), [(0.0, 0.0), (0.6, 0.25), (1.2, 0.5)])
def test_the_shipped_tree_grows_from_no_length_to_full(time, length):
    tree = statwalk.load("tree").character
    pose = tree.clip("grow").sample(time)  # half a metre in 1.2 s
    grown = place(tree, pose, "trunk2") - place(tree, pose, "trunk1")
    assert np.linalg.norm(grown) == pytest.approx(length, abs=1e-3)
