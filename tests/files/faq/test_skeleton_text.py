"""The FAQ's skeleton table as text: read, written, refused."""

import contextlib

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from rotations import unit_vectors
from statwalk.errors import TextError
from statwalk.files.faq.key_frame_text import read_keys
from statwalk.files.faq.skeleton_text import read_skeleton, read_text, shipped_skeleton, write_skeleton
from statwalk.rig.bones import Bones
from statwalk.rig.skeleton import Skeleton

TABLE = """\
Bone            Parent            Length        Direction
---------------------------------------------------------

# children may come first
Head            Back              3             0  2  0
Back            Root              5             0  1  0
Root            ---               -             -  -  -
"""


def test_reads_the_table_as_printed():
    bones = read_skeleton(TABLE)
    assert bones.skeleton.names == ("Root", "Back", "Head")
    np.testing.assert_array_equal(bones.length, [0, 5, 3])
    np.testing.assert_array_equal(bones.direction, [[0, 0, 0], [0, 1, 0], [0, 1, 0]])


@given(st.lists(st.tuples(st.floats(0, 100), unit_vectors()), min_size=1, max_size=6))
def test_what_is_written_reads_back_to_the_last_bit(rows):
    names = tuple(f"bone.{i}" for i in range(len(rows)))
    parent = np.arange(len(rows), dtype=np.int32) - 1
    bones = Bones(
        Skeleton(names, parent),
        np.array([length for length, _ in rows]),
        np.array([direction for _, direction in rows]),
    )
    again = read_skeleton(write_skeleton(bones))
    assert again.skeleton.names == names
    np.testing.assert_array_equal(again.length, bones.length)
    np.testing.assert_allclose(again.direction, bones.direction, rtol=0, atol=2e-16)


@pytest.mark.parametrize(
    ("row", "message"),
    [
        ("Tail Root 3 0 1", "line 8: a bone is six words, name parent length x y z, not 5"),
        ("Tail Rot 3 0 1 0", "line 8: no bone is called 'Rot'; did you mean Root?"),
        ("Back Root 3 0 1 0", "line 8: Back is defined twice, first at line 6"),
        ("Tail Tail 3 0 1 0", "line 8: bones form a cycle: Tail -> Tail"),
        ("Tail Root long 0 1 0", "line 8: the length of Tail should be a number within 1e\\+09, not 'long'"),
        ("Tail Root nan 0 1 0", "line 8: the length of Tail should be a number within 1e\\+09, not 'nan'"),
        ("Tail Root -3 0 1 0", "line 8: the length of Tail should not be negative"),
        ("Tail Root 3 0 0 0", "line 8: the direction of Tail is 0 0 0"),
        ("Tail Root 3 - - -", "line 8: the direction of Tail is 0 0 0"),
        ("Tail Root 3 0 up 0", "line 8: the direction of Tail should be numbers"),
    ],
)
def test_a_wrong_row_is_refused_by_its_line(row, message):
    with pytest.raises(TextError, match=message.replace("?", r"\?")):
        read_skeleton(TABLE + row + "\n")


def test_an_empty_table_is_refused():
    with pytest.raises(TextError, match="no bone"):
        read_skeleton("Bone Parent Length Direction\n----\n")


@pytest.mark.parametrize(("name", "count"), [("mammal", 20), ("hand", 16)])
def test_shipped_skeletons(name, count):
    assert len(shipped_skeleton(name).skeleton) == count


def test_a_file_that_is_no_text_is_refused(tmp_path):
    (tmp_path / "bones.txt").write_bytes(b"Root \xff")
    with pytest.raises(TextError, match="byte 5: this is not UTF-8"):
        read_text(tmp_path / "bones.txt")


def test_a_file_that_is_not_there_is_refused(tmp_path):
    with pytest.raises(TextError, match=r"bones\.txt: the file cannot be read: No such file"):
        read_text(tmp_path / "bones.txt")


WORDS = st.sampled_from(
    [
        "Root",
        "Arm",
        "---",
        "-",
        "1",
        "0",
        "-1",
        "nan",
        "1e999",
        "#",
        "#rotate",
        "#time",
        "#matrix",
        "#length",
        "é",
        "\x00",
        "\n",
        "\n",
    ]
)


@given(
    st.lists(WORDS | st.text(max_size=3), max_size=40).map(" ".join),
    st.sampled_from([read_skeleton, read_keys]),
)
def test_any_text_is_read_or_refused_with_a_text_error(text, read):
    with contextlib.suppress(TextError):
        read(text)
