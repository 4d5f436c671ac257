"""Counts are checked against the numbers that follow, before memory is taken; errors name the line."""

import re
import tracemalloc

import pytest
from statwalk.errors import TextError
from statwalk.files.directx.x_numbers import NumberReader
from statwalk.files.directx.x_objects import read_objects


def numbers(text: str) -> NumberReader:
    (part,) = read_objects(f"Mesh m {{\n{text}\n}}").parts
    return NumberReader(part)


def test_numbers_come_in_order() -> None:
    reader = numbers("2; 0.5;,-1e2;;\n3;")
    assert reader.count("pairs") == 2
    assert reader.floats(2, "values").tolist() == [0.5, -100]
    assert reader.indices(1, 4, "an index").tolist() == [3]
    reader.end()


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("1;\nx;", "line 3: 'x' is no number"),
        ("1;\nnan;", "line 3: 'nan' is no number"),
        ("1;\n1e999;", "line 3: '1e999' is no number"),
        ("1;\n1_0;", "line 3: '1_0' is no number"),
        ("1;\n5;", "line 3: an index: 5 should be a whole number from 0 to 3"),
        ("1;\n1.5;", "line 3: an index: 1.5 should be"),
        ("1;\n-1;", "line 3: an index: -1 should be"),
        ("7;\n1;", "line 2: 7 items cannot be: 1 numbers follow"),
        ("-1;\n1;", "line 2: -1 items cannot be"),
        ("0.5;\n1;", "line 2: 0.5 items cannot be"),
        ("", "line 1: 1 numbers should follow for items, but 0 follow"),
        ("1;\n2;\n3;", "line 4: mesh m has 1 numbers more than its counts say"),
    ],
)
def test_wrong_numbers_are_refused_with_their_line(text: str, said: str) -> None:
    with pytest.raises(TextError, match=re.escape(said)):
        _read(text)


def _read(text: str) -> None:
    reader = numbers(text)
    reader.indices(reader.count("items"), 4, "an index")
    reader.end()


def test_a_false_count_takes_no_memory() -> None:
    reader = numbers("1000000000000; 1; 2;")
    tracemalloc.start()
    with pytest.raises(TextError, match="1e\\+12 vertices cannot be: 2 numbers follow"):
        reader.count("vertices", 3)
    assert tracemalloc.get_traced_memory()[1] < 100_000
    tracemalloc.stop()
