"""Columns of fields against the same said value by value."""

import numpy as np
import pytest
from statwalk.files.gltf.columns import BROKEN, LARGEST, Codes, codes, vectors, whole_numbers

DEEP = []
for _ in range(5_000):
    DEEP = [DEEP]


def entries(*values):
    return [{"of": value} for value in values]


@pytest.mark.parametrize(
    "value", [True, False, 1.0, "1", None, [1], {"1": 1}, b"", DEEP], ids=lambda value: type(value).__name__
)
def test_what_is_no_whole_number_is_broken(value):
    assert whole_numbers(entries(3, value, 5), "of").tolist() == [3, BROKEN, 5]


@pytest.mark.parametrize(
    ("value", "kept"),
    [(2**31 - 1, 2**31 - 1), (2**31, 2**31), (2**63, LARGEST), (-(2**31), -(2**31)), (0, 0)],
)
def test_whole_numbers_of_any_size(value, kept):
    assert whole_numbers(entries(7, value), "of").tolist() == [7, kept]


def test_a_missing_field_has_its_default():
    assert whole_numbers([{"of": 2}, {}], "of", 9).tolist() == [2, 9]


@pytest.mark.parametrize("value", ["c", 0, None, True, ["a"], {"a": "a"}])
def test_what_is_not_known_has_no_code(value):
    assert codes(entries("b", value, "a"), "of", Codes(("a", "b"))).tolist() == [1, BROKEN, 0]


@pytest.mark.parametrize("value", [1e25, -1e25, True, "1", None])
def test_vectors_take_usable_numbers_only(value):
    assert vectors(entries([1, 2.5], [0, value]), "of", [0, 0]) is None


def test_vectors_are_rows():
    assert (vectors([{"of": [1, 2.5]}, {}], "of", [7, 8]) == np.array([[1, 2.5], [7, 8]])).all()
