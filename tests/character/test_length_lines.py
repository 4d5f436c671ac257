"""Lengths of joints in expressions, against places computed by hand (SK3, EX1)."""

from dataclasses import replace

import numpy as np
import pytest
import statwalk
from statwalk.character.role import Role
from statwalk.errors import ContentError, MachineError
from statwalk.files.machine_yaml.machine_file import read_machine
from text_character import from_text, place

TREE = "Root --- - - - -\nTrunk Root 4 0 1 0\nBranch Trunk 2 1 0 0\nTwig Branch 1 0.6 0.8 0\n"
TREE += "Leaf Branch 3 0 0 1\n"


@pytest.fixture
def tree(tmp_path):
    return from_text(
        tmp_path, TREE, grow=("#time 0\n#length Branch 0\n#time 2\n#length Branch 2", "interpolation: linear")
    )


def expressed(tree, *lines, pose=None):
    return statwalk.express(tree, lines, pose)


def test_a_set_length_moves_all_children_along_the_bone(tree):
    pose = expressed(tree, "Branch.length = 0.5", "Twig.length = 2").pose
    np.testing.assert_allclose(place(tree, pose, "Twig"), [0.5, 4, 0], atol=1e-6)
    np.testing.assert_allclose(place(tree, pose, "Leaf"), [0.5, 4, 0], atol=1e-6)
    np.testing.assert_allclose(place(tree, pose, "Twig.end"), [0.5 + 1.2, 4 + 1.6, 0], atol=1e-6)


def test_a_read_length_is_that_of_the_motion(tree):
    pose = tree.clip("grow").sample(1.0)
    found = expressed(tree, "seen = Branch.length", "longer = 2 * Trunk.length", pose=pose)
    assert found.variables == pytest.approx({"seen": 1, "longer": 8}, abs=1e-6)


def test_only_the_written_lines_are_reported(tree):
    assert expressed(tree, "Branch.length = 3").channels == {"Branch.length": 3}


def test_a_length_and_a_childs_translation_depend_on_each_other_in_order(tree):
    found = expressed(tree, "seen = Twig.trans_x", "Branch.length = 3 * Trunk.length", "Trunk.length = 1.5")
    assert found.variables == pytest.approx({"seen": 4.5})


@pytest.mark.parametrize(
    ("lines", "says"),
    [
        (["Branch.length = 1", "Twig.trans_x = 2"], "Branch.length sets Twig.trans_x, which line 2 sets too"),
        (["Branch.length = Twig.trans_x"], "circle"),
        (["a = Bramch.length"], "did you mean Branch"),
        (["'Twig.end'.length = 1"], "Twig.end has no length: no joint stands at its end"),
    ],
)
def test_lengths_that_cannot_be_are_refused_with_their_line(tree, lines, says):
    with pytest.raises(ContentError, match=says) as error:
        expressed(tree, *lines)
    assert error.value.place == "line 1"


MACHINE = """semantics: 1
initial: STAND
states:
  STAND: {motion: grow, loop: true}
  REACH: {motion: {expressions: ["Branch.length = 1 + time"]}}
table: |
  state | GO
  STAND | REACH
  REACH |
expressions: |
  Trunk.length = 8 - Leaf.length
"""


def test_the_lines_of_a_machine_and_of_a_motion_have_lengths(tree):
    stage = statwalk.Stage()
    actor = stage.add(Role.build("tree", tree, read_machine(MACHINE)))
    stage.send(actor, "GO")
    stage.step(61)
    assert actor.channels == {"Trunk.length": 5}
    np.testing.assert_allclose(place(tree, actor.pose, "Twig"), [2, 5, 0], atol=0.05)


def test_a_character_with_a_length_keeps_its_line_apart_from_the_machines(tree):
    own = statwalk.express(tree, ["Trunk.length = 6"])
    assert own.channels == {"Trunk.length": 6}
    lines = read_machine(MACHINE).expressions
    character = replace(tree, expressions=tuple(replace(line, line=9) for line in lines))
    with pytest.raises(MachineError, match=r"set by the character's own expressions \(line 9"):
        Role.build("tree", character, read_machine(MACHINE))
