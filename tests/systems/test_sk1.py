"""SK1 skeleton table (FAQ Q2, Q11): the mammal and the hand ship as data; the printed mammal keeps its
misprints.
"""

import numpy as np
import pytest
import statwalk
from paths import MACHINES
from statwalk.errors import TextError
from statwalk.files.faq.skeleton_text import read_skeleton, shipped_skeleton
from text_character import from_text


def parent_of(bones, name: str) -> str:
    return bones.skeleton.names[bones.skeleton.parent[bones.skeleton.index(name)]]


def test_the_mammal_has_the_20_bones_of_the_faq_corrected():
    mammal = shipped_skeleton("mammal")
    assert len(mammal.skeleton) == 20
    assert [parent_of(mammal, f"Left.{bone}") for bone in ("upperarm", "lowerarm", "hand")] == [
        "Left.shoulder",
        "Left.upperarm",
        "Left.lowerarm",
    ]
    legs = [
        mammal.skeleton.index(f"{side}.{bone}")
        for side in ("Left", "Right")
        for bone in ("upperleg", "lowerleg")
    ]
    np.testing.assert_array_equal(mammal.direction[legs], [[0, -1, 0]] * 4)


def test_the_mammal_is_its_own_mirror_image():
    mammal = shipped_skeleton("mammal")
    ends = dict(zip(mammal.skeleton.names, mammal.evaluate().end, strict=True))
    for name, end in ends.items():
        if name.startswith("Left."):
            np.testing.assert_allclose(ends[name.replace("Left", "Right")], end * [-1, 1, 1])


def test_the_hand_has_16_bones():
    hand = shipped_skeleton("hand")
    assert len(hand.skeleton) == 16
    assert [parent_of(hand, bone) for bone in ("palm", "thumbbase", "ringbase", "littleend")] == [
        "lowerarm",
        "lowerarm",
        "palm",
        "littlemid",
    ]


def test_the_shipped_machine_has_the_bones_of_the_hand():
    hand, machine = shipped_skeleton("hand"), statwalk.load("hand").character.skeleton
    assert set(hand.skeleton.names) <= set(machine.names)
    for name in hand.skeleton.names[1:]:
        assert machine.names[machine.parent[machine.index(name)]] == parent_of(hand, name)


def test_the_printed_mammal_keeps_its_misprints():
    printed = read_skeleton((MACHINES / "faq-printed" / "skeleton.txt").read_text())
    assert len(printed.skeleton) == 20
    assert parent_of(printed, "Left.upperarm") == "Right.shoulder"
    np.testing.assert_array_equal(printed.direction[printed.skeleton.index("Left.upperleg")], [1, 0, 0])


def test_rows_in_any_order_make_the_same_skeleton(tmp_path):
    rows = ["Root --- - - - -", "Back Root 5 0 1 0", "Head Back 3 0 1 0"]
    forwards, backwards = (from_text(tmp_path, "\n".join(order) + "\n") for order in (rows, rows[::-1]))
    assert forwards.skeleton.names == backwards.skeleton.names
    np.testing.assert_array_equal(forwards.world(forwards.bind_pose), backwards.world(backwards.bind_pose))


@pytest.mark.parametrize(
    ("rows", "message"),
    [
        ("Root --- - - - -\nHead Neck 3 0 1 0\n", r"skeleton.txt, line 2: no bone is called 'Neck'"),
        (
            "A B 1 0 1 0\nB A 1 0 1 0\n",
            r"skeleton.txt, line 1: bones form a cycle: A -> B -> A",
        ),
        (
            "Root --- - - - -\nRoot --- - - - -\n",
            r"skeleton.txt, line 2: Root is defined twice, first at line 1",
        ),
    ],
)
def test_a_wrong_table_is_refused_by_file_and_line(tmp_path, rows, message):
    with pytest.raises(TextError, match=message):
        from_text(tmp_path, rows)
