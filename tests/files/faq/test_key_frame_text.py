"""The FAQ's key frames as text: read, written, refused."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from statwalk.errors import TextError
from statwalk.files.faq.key_frame_text import BoneKey, KeyFrame, read_keys, write_keys

TRIPLES = st.tuples(*[st.floats(-1e6, 1e6, allow_subnormal=False)] * 3)


@st.composite
def bone_keys(draw):
    parts = {
        "rotate_deg": draw(st.none() | TRIPLES),
        "translate": draw(st.none() | TRIPLES),
        "length": draw(st.none() | st.floats(0, 1e6)),
    }
    return BoneKey(**parts) if any(part is not None for part in parts.values()) else BoneKey(length=1.0)


CLIPS = st.lists(
    st.dictionaries(st.sampled_from(["Root", "Left.hand", "Head"]), bone_keys(), min_size=1),
    min_size=1,
    max_size=4,
)


@given(CLIPS)
def test_what_is_written_reads_back_the_same(poses):
    frames = [KeyFrame(0.25 * i, bones) for i, bones in enumerate(poses)]
    again = read_keys(write_keys(frames))
    assert [frame.time for frame in again] == [frame.time for frame in frames]
    for before, after in zip(frames, again, strict=True):
        assert {n: (k.rotate_deg, k.translate, k.length) for n, k in before.bones.items()} == {
            n: (k.rotate_deg, k.translate, k.length) for n, k in after.bones.items()
        }


def test_a_matrix_is_written_and_read_back():
    matrix = np.array([[0, -1, 0, 1.5], [1, 0, 0, 0.1], [0, 0, 1, 0]])
    again = read_keys(write_keys([KeyFrame(0.0, {"Head": BoneKey(matrix=matrix)})]))
    np.testing.assert_array_equal(again[0].bones["Head"].matrix, matrix)


def test_time_begins_the_next_pose():
    frames = read_keys(
        "# a comment\n#time 0\n#rotate Head 1 2 3\n#time 0.5\n#rotate Head 4 5 6\n#length Head 7\n"
    )
    assert [frame.time for frame in frames] == [0.0, 0.5]
    assert frames[1].bones["Head"].rotate_deg == (4, 5, 6)
    assert frames[1].bones["Head"].length == 7


MATRIX = "#matrix Head\n{}\n0 1 0 0\n0 0 1 0\n{}\n"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("#turn Head 1 2 3", "line 1: a line should begin with one of #time, #rotate"),
        ("#rotate Head 1 2", "line 1: this key should read #rotate BONE x y z, not 3 words"),
        ("#rotate Head 1 2 inf", "line 1: #rotate Head should be numbers within 1e\\+09, not '1 2 inf'"),
        ("#length Head -1", "line 1: the length of Head should not be negative"),
        (
            "#rotate Head 0 0 0\n#rotate Head 1 1 1",
            "line 2: Head already has this key in this pose, at line 1",
        ),
        ("#time 1\n#time 1", "line 2: times begin at 0 or later and rise"),
        ("#time -1", "line 1: times begin at 0"),
        (
            "#matrix Head\n1 0 0 0\n0 1 0",
            "line 3: the matrix of Head needs four rows of four numbers, not '0 1 0'",
        ),
        (
            "#matrix Head\n1 0 0 0",
            "line 1: the matrix of Head needs four rows of four numbers, not 'the end of the file'",
        ),
        (MATRIX.format("1 0 0 0", "0 0 0 2"), "line 1: the last row of the matrix of Head should be 0 0 0 1"),
        (MATRIX.format("-1 0 0 0", "0 0 0 1"), "line 1: the matrix of Head shears or mirrors"),
        (MATRIX.format("1 1 0 0", "0 0 0 1"), "line 1: the matrix of Head shears or mirrors"),
        (MATRIX.format("0 1 0 0", "0 0 0 1"), "line 1: the matrix of Head is singular"),
        (MATRIX.format("1 0 0 0", "0 0 0 1") + "#rotate Head 0 0 0", "line 6: Head already has this key"),
        ("", "this file has no key"),
    ],
)
def test_a_wrong_key_is_refused_by_line_and_bone(text, message):
    with pytest.raises(TextError, match=message):
        read_keys(text)
