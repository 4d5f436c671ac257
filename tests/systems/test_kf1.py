"""KF1 key-frame files: the FAQ's four keys (Q15), its misprinted matrix, and what a bone does with them."""

import numpy as np
import pytest
from statwalk.errors import TextError
from statwalk.files.faq.key_frame_text import read_keys, write_keys
from text_character import from_text

PRINTED = "#rotate    Left.upperleg 0 10  0\n#translate Left.upperleg 0 0.3 0\n#length    Left.upperleg 3\n"
MATRIX = "#matrix Left.upperleg\n\n1 0 0  0\n0 1 0  0.3\n0 0 {third}  0\n0 0 0  1\n"


def thigh_world(tmp_path, keys: str) -> np.ndarray:
    mammal = from_text(tmp_path, "mammal", key=(keys, "interpolation: slerp"))
    return mammal.world(mammal.clip("key").sample(0.0))[mammal.skeleton.index("Left.upperleg")]


def test_the_faqs_own_keys_are_read_and_written():
    (frame,) = read_keys(PRINTED)
    key = frame.bones["Left.upperleg"]
    assert (key.rotate_deg, key.translate, key.length) == ((0, 10, 0), (0, 0.3, 0), 3)
    assert read_keys(write_keys([frame]))[0].bones["Left.upperleg"].rotate_deg == (0, 10, 0)


def test_the_printed_matrix_is_singular_and_named():
    with pytest.raises(TextError, match=r"line 1: the matrix of Left\.upperleg is singular: row 3 is 0 0 0"):
        read_keys(MATRIX.format(third=0))


def test_the_corrected_matrix_is_the_translation_it_means(tmp_path):
    by_matrix = thigh_world(tmp_path, MATRIX.format(third=1))
    np.testing.assert_allclose(
        by_matrix, thigh_world(tmp_path, "#translate Left.upperleg 0 0.3 0"), atol=1e-6
    )
    np.testing.assert_allclose(by_matrix[:3, 3], [3, 0.3, 0], atol=1e-6)


def test_a_matrix_turns_as_the_angles_do(tmp_path):
    c, s = np.cos(np.radians(10)), np.sin(np.radians(10))
    rows = f"#matrix Left.upperleg\n{c} 0 {s} 0\n0 1 0 0\n{-s} 0 {c} 0\n0 0 0 1"
    np.testing.assert_allclose(
        thigh_world(tmp_path, rows), thigh_world(tmp_path, "#rotate Left.upperleg 0 10 0"), atol=1e-6
    )
