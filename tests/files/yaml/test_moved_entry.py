"""An entry in another mapping: its lines and comments go along."""

import pytest
from statwalk.files.yaml.moved_entry import entry_moved

TEXT = """a:
  # before x
  x:               # of x
    deep: [1, 2]   # deeper
    text: |
      one

      two
  y: 1   # of y
b:
  inner: {}
c: {d: 2, e: 3}
"""


def test_lines_are_as_deep_as_their_new_place():
    assert (
        entry_moved(TEXT, ("a", "x"), ("b", "inner"))
        == """a:
  # before x
  y: 1   # of y
b:
  inner:
    x:               # of x
      deep: [1, 2]   # deeper
      text: |
        one

        two
c: {d: 2, e: 3}
"""
    )


def test_lines_move_out_again():
    inside = entry_moved(TEXT, ("a", "x"), ("b", "inner"))
    assert (
        entry_moved(inside, ("b", "inner", "x"), ("a",))
        == """a:
  # before x
  y: 1   # of y
  x:               # of x
    deep: [1, 2]   # deeper
    text: |
      one

      two
b: {}
c: {d: 2, e: 3}
"""
    )


@pytest.mark.parametrize(
    ("path", "parent", "line"),
    [
        (("a", "y"), ("c",), "c: {d: 2, e: 3, y: 1}"),
        (("c", "e"), ("a",), "  e: 3"),
        (("a", "y"), ("new",), "  y: 1   # of y"),
    ],
)
def test_brackets_and_new_mappings(path, parent, line):
    assert line in entry_moved(TEXT, path, parent).splitlines()
