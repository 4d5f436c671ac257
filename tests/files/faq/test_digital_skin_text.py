"""The FAQ's digital skin as text: read, written, refused."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from statwalk.errors import TextError
from statwalk.files.faq.digital_skin_text import SkinText, read_digital_skin, write_digital_skin

NUMBERS = st.floats(-1e6, 1e6, allow_subnormal=False)
VERTEX = st.tuples(st.integers(0, 1), st.sampled_from(["#d2b49a", "#00ff7f"]), st.tuples(*[NUMBERS] * 3))


@given(st.lists(VERTEX, min_size=3, max_size=12), st.permutations(range(3)))
def test_what_is_written_reads_back_the_same(vertices, corners):
    bones = ("Upper.arm", "Lower.arm") if vertices[0][0] == 0 else ("Lower.arm", "Upper.arm")
    rows = np.array([(bone != vertices[0][0]) for bone, _, _ in vertices], np.int64)
    positions = np.array([position for _, _, position in vertices])
    colours = tuple(colour for _, colour, _ in vertices)
    skin = SkinText(bones if rows.any() else bones[:1], rows, positions, colours, (tuple(corners),))
    again = read_digital_skin(write_digital_skin(skin))
    assert (again.bones, again.colours, again.polygons) == (skin.bones, skin.colours, skin.polygons)
    np.testing.assert_array_equal(again.bone, rows)
    np.testing.assert_array_equal(again.positions, positions)


def test_a_bone_may_have_several_blocks():
    text = "#vertices A\n0 0 0\n#vertices B\n1 0 0\n#vertices A #ff0000\n0 1 0\n#polygons\n0 1 2\n"
    skin = read_digital_skin(text)
    assert skin.bones == ("A", "B")
    assert skin.bone.tolist() == [0, 1, 0]
    assert skin.colours[2] == "#ff0000"


TRIANGLE = "#vertices A\n0 0 0\n1 0 0\n0 1 0\n#polygons\n"


@pytest.mark.parametrize(
    ("text", "place", "message"),
    [
        ("0 0 0\n", "line 1", "begins with #vertices BONE"),
        ("#vertex A\n", "line 1", "#vertices BONE #rrggbb"),
        ("#vertices A red\n", "line 1", "a colour is #rrggbb, not 'red'"),
        ("#vertices A\n0 0\n", "line 2", "a vertex is x y z, not '0 0'"),
        ("#vertices A\n0 nan 0\n", "line 2", "a vertex should be numbers"),
        (TRIANGLE + "0 1 3\n", "line 6", "there is no vertex 3; the last is 2"),
        (TRIANGLE + "0 1\n", "line 6", "3 to 64 corners"),
        (TRIANGLE + "0 1 1\n", "line 6", "each once"),
        (TRIANGLE + "0 1 -1\n", "line 6", "numbers of vertices"),
        (TRIANGLE, "", "needs vertices and polygons"),
    ],
)
def test_wrong_text_is_refused_with_its_line(text, place, message):
    with pytest.raises(TextError) as caught:
        read_digital_skin(text)
    assert caught.value.place == place
    assert message in caught.value.message
