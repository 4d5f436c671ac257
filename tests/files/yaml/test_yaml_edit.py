"""Entries of a YAML text that come, change, move and go; every other letter stays."""

import pytest
from statwalk.errors import ContentError
from statwalk.files.yaml.yaml_edit import moved, with_key, with_value, without
from statwalk.files.yaml.yaml_text import parse
from statwalk.files.yaml.yaml_tree import Parser, PureParser

TEXT = """# ü
a: {x: 1, "q w": [1, 2]}   # c
b:
  c: |     # block
    é
    you

  # foo
  d: 'x'
e:
list:
  - one
  - two # 2
last: end"""


def put(path: tuple[str | int, ...], value: object, text: str = TEXT) -> str:
    changed = with_value(text, path, value)  # type: ignore[arg-type]
    node = parse(changed, "", ContentError)
    for step in path:
        node = node.items()[step] if isinstance(step, int) else node.entries()[step]
    return changed


def test_a_value_in_brackets() -> None:
    assert put(("a", "x"), "p, q") == TEXT.replace("x: 1", 'x: "p, q"')
    assert put(("a", "y"), {"k": 1.5}) == TEXT.replace("2]}", "2], y: {k: 1.5}}")
    assert put(("a", "q w", 1), 3) == TEXT.replace("[1, 2]", "[1, 3]")


def test_a_value_of_a_block() -> None:
    assert put(("b", "d"), True) == TEXT.replace("'x'", "true")
    assert put(("b", "c"), "short") == TEXT.replace("|     # block\n    é\n    you\n", "short\n")
    assert put(("b", "c"), "é\nich\n") == TEXT.replace("|     # block", "|").replace("you", "ich")


def test_a_value_where_none_was() -> None:
    assert put(("e",), "f") == TEXT.replace("e:\n", "e: f\n")
    assert put(("e", "f"), "g") == TEXT.replace("e:\n", "e: {f: g}\n")


def test_a_new_entry_at_the_end_of_a_text_without_a_line_end() -> None:
    assert put(("new",), 1) == f"{TEXT}\nnew: 1"
    assert put(("new", "map", "k"), 1) == f"{TEXT}\n\nnew:\n  map: {{k: 1}}"


def test_items_of_a_list() -> None:
    assert put(("list", 2), "from A, B") == TEXT.replace("# 2\n", "# 2\n  - from A, B\n")
    assert put(("list", 1), "zwei") == TEXT.replace("two", "zwei")
    assert without(TEXT, ("list", 0)) == TEXT.replace("  - one\n", "")
    assert moved(TEXT, ("list", 0), None) == TEXT.replace("  - one\n  - two # 2\n", "  - two # 2\n  - one\n")


def test_an_entry_goes() -> None:
    assert without(TEXT, ("a", "x")) == TEXT.replace('x: 1, "', '"')
    assert without(TEXT, ("a", "q w")) == TEXT.replace(', "q w": [1, 2]', "")
    assert without(TEXT, ("b", "d")) == TEXT.replace("  d: 'x'\n", "")
    assert without(TEXT, ("nothing", "there")) == TEXT


def test_the_last_entry_takes_what_is_empty_along() -> None:
    emptied = without(TEXT, ("b", "d"))
    assert without(emptied, ("b", "c")).startswith('# ü\na: {x: 1, "q w": [1, 2]}   # c\n')
    assert "b:" not in without(emptied, ("b", "c"))
    assert "b: {}" in without(emptied, ("b", "c"), keep=1)


def test_a_key_keeps_the_column_of_the_values() -> None:
    text = "m:\n  long: 1\n  a:    2\n"
    assert with_key(text, ("m", "a"), "abc") == "m:\n  long: 1\n  abc:  2\n"
    assert with_key(text, ("m", "a"), "longer") == "m:\n  long: 1\n  longer: 2\n"
    assert with_value(text, ("m", "b"), 3) == "m:\n  long: 1\n  a:    2\n  b:    3\n"


def test_ends_of_lines_stay() -> None:
    text = TEXT.replace("\n", "\r\n")
    assert put(("list", 2), "three", text) == put(("list", 2), "three").replace("\n", "\r\n")
    assert put(("new", "map", "k"), 1, text) == put(("new", "map", "k"), 1).replace("\n", "\r\n")


@pytest.mark.parametrize(
    "value",
    [
        "a: b",
        "- x",
        "# c",
        "&a",
        "*a",
        "!t",
        "{",
        "x ",
        " x",
        "",
        "a\tb",
        "'",
        '"',
        "%",
        "@",
        "\u2028",
        "?",
        "? x",
        "-",
        "x:",
        "null: 1",
        "a #b",
        ",",
        "[x]",
    ],
)
def test_what_is_written_is_read_back(value: str) -> None:
    for path in (("a", "x"), ("b", "d"), ("list", 0)):
        node = parse(with_value(TEXT, path, value), "", ContentError)
        for step in path:
            node = node.items()[step] if isinstance(step, int) else node.entries()[step]
        assert node.value == value


def test_both_parsers_find_the_same_places() -> None:
    trees = [parse(TEXT, "", ContentError, parser=parser) for parser in (Parser, PureParser)]
    places = [
        [(child.start, child.end, tree.key_spans[key]) for key, child in tree.entries().items()]
        for tree in trees
    ]
    assert places[0] == places[1]
