"""The file of a question to the twelve rules, and what is refused with its line."""

import numpy as np
import pytest
from statwalk.errors import TextError
from statwalk.files.deduce_yaml import read_deduce

ARM = """\
bones:
  fore: {parent: upper, length: 5, direction: [0, -2, 0]}
  upper: {length: 5, direction: [0, -1, 0]}
known:
  upper: {SP: [0, 0, 0]}
  fore: {EP: [0, -8, 0], bend: [0, 0, 1]}
"""


def test_a_file_is_answered():
    found = read_deduce(ARM).answer()
    assert found["fore"]["SP"].value == pytest.approx([0, -4, 3])
    assert found["upper"]["EP"].rule == 12
    assert found.unknown == ()


def test_shipped_skeletons_have_a_name_and_angles_are_degrees():
    found = read_deduce("bones: mammal\nknown:\n  Root: {RA_deg: [0, 0, 90]}\n").answer()
    assert found["Root"]["RM"].value @ [1, 0, 0] == pytest.approx([0, 1, 0])
    assert ("Head", "RA") in found.unknown


def test_expressions_stand_in_lines_and_in_lists():
    lines = (
        "expressions: |\n  # a comment\n  upper.rotate_z = 90\n  upper.rotate_x = 0\n  upper.rotate_y = 0\n"
    )
    found = read_deduce(ARM.split("known")[0] + lines).answer()
    assert found["upper"]["EP"].value == pytest.approx([5, 0, 0])
    listed = "expressions: [upper.rotate_z = 90, upper.rotate_x = 0, upper.rotate_y = 0]\n"
    again = read_deduce(ARM.split("known")[0] + listed).answer()
    np.testing.assert_array_equal(found["upper"]["EP"].value, again["upper"]["EP"].value)


def test_unknown_takes_a_value_away():
    found = read_deduce(ARM.replace("bend: [0, 0, 1]", "LEN: unknown")).answer()
    assert ("fore", "LEN") in found.unknown


@pytest.mark.parametrize(
    ("text", "line", "what"),
    [
        ("known: {}\n", 1, "bones are needed"),
        ("bones: elephant\n", 1, "no skeleton is called"),
        (ARM.replace("parent: upper", "parent: uper"), 2, "did you mean upper"),
        (ARM.replace("upper: {length", "upper: {parent: fore, length"), 2, "cycle"),
        (ARM.replace("EP: [0, -8, 0]", "EP: [0, -8]"), 6, "3 numbers are needed"),
        (ARM.replace("EP: [0, -8, 0]", "EP: [0, -8, x]"), 6, "is no number"),
        (ARM.replace("EP: ", "XP: "), 6, "no key is called 'XP'"),
        (ARM.replace("  fore: {EP", "  far: {EP"), 6, "no bone is called 'far'"),
        (ARM.replace("length: 5, direction: [0, -1, 0]", "length: -5"), 3, "not a finite number"),
        (ARM.replace("-8", "-11"), 0, "misses the sphere"),
        (ARM.replace("upper: {SP: [0, 0, 0]}", "upper: {SP: [0, 0, 0], EP: [0, 1, 0]}"), 0, "its LEN is 5"),
        (ARM + "expressions: |\n  fore.rotate_z = sin(\n", 8, "the end"),
        (ARM + "expressions: |\n  a = b\n  b = a\n", 8, "circle"),
        (ARM + "expressions: |\n  fore.turn = 2\n", 0, "no channel is called 'turn'"),
    ],
)  # fmt: skip
def test_a_fault_is_refused_with_its_line(text, line, what):
    with pytest.raises(TextError, match=what) as refused:
        read_deduce(text, "arm.yaml").answer()
    assert refused.value.file == "arm.yaml"
    assert not line or f"line {line}" in refused.value.place
