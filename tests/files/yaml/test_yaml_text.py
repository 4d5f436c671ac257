"""Strict YAML: text stays text, every value knows its line, and hostile documents are refused with theirs."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from statwalk.errors import MachineError, StatwalkError, TextError
from statwalk.files.yaml.yaml_text import parse, read_text
from statwalk.files.yaml.yaml_tree import Parser, PureParser

LATE = "a: {b: c}\n"
"""what a text may begin with: the fault comes later"""

TOO_MUCH = {
    "huge": ("# a\n" * (1 << 15) + "a", "larger than 128 KiB"),
    "huge in bytes": ("# é\n" * 25_000 + "# 🙂🙂\n" * 4_000, "larger than 128 KiB"),
    "brackets": ("[" * 100_000, "line 1: the line is longer than 4,096 characters"),
    "a long line": (LATE + "b: " + "a" * 5_000, "line 2: the line is longer than 4,096 characters"),
    "many lines": (LATE + "- a\n" * 20_000, "line 5999: more than 6,000 values"),
    "many in brackets": (LATE + ("[" + "a," * 2_000 + "]\n") * 6, "line 4: more than 6,000 values"),
    "many keys": ("".join(f"k{number}: v\n" for number in range(9_000)), "line 3001: more than 6,000 values"),
    "zero byte": (LATE + "a\x00", "line 2: there is an unprintable character here"),
    "half a character": ("a: \ud800", "line 1: there is an unprintable character here"),
}
"""refused before anything is parsed"""

HOSTILE = {
    "brackets": ("[" * 4_000, "more than 32 deep"),
    "brackets below": (LATE + "[" * 4_000, "more than 32 deep|expected"),
    "braces": ("{" * 4_000, "more than 32 deep|one value is needed"),
    "pairs": ("{a: " * 1_000, "more than 32 deep"),
    "dashes": ("- " * 2_000, "more than 32 deep"),
    "steps": ("\n".join(" " * depth + "a:" for depth in range(1, 300)), "more than 32 deep"),
    "anchor": (LATE + "b: &x b", "line 2: anchors"),
    "alias": ("a: *x", "aliases"),
    "tag": ("a: !!python/object/apply:os.system [ls]", "tags"),
    "bare tag": ("a: ! b", "tags"),
    "list as key": ("? [a]\n: b", "one value is needed"),
    "two documents": ("a: b\n---\nc: d", "second document"),
    "surrogate": ('"\\uD800"', "a lone surrogate|invalid Unicode"),
    "code point": ('"\\UFFFFFFFF"', "too large|invalid Unicode"),
    "version": (f"%YAML {'9' * 4000}.1\n--- a", "too large|too long|not YAML"),
    "unclosed": ("a: [b", "line 1|line 2"),
    "unclosed quotes": ('a: "b', "not YAML"),
}


def read(text, known=(), parser=Parser):
    return parse(text, "machine.yaml", MachineError, known, parser)


class Unasked:
    """A parser that is not to be asked for anything."""

    def __init__(self, text):
        raise AssertionError(f"{len(text)} characters were handed to the parser")


@pytest.mark.parametrize(("text", "message"), TOO_MUCH.values(), ids=TOO_MUCH)
def test_what_would_take_long_is_refused_before_it_is_parsed(text, message):
    with pytest.raises(MachineError, match=message):
        read(text, parser=Unasked)


@pytest.mark.parametrize("parser", [Parser, PureParser])
@pytest.mark.parametrize(("text", "message"), HOSTILE.values(), ids=HOSTILE)
def test_hostile_text_is_refused(text, message, parser):
    with pytest.raises(MachineError, match=message) as caught:
        read(text, parser=parser)
    assert caught.value.file == "machine.yaml"


def test_an_unknown_key_at_the_top_ends_the_reading_where_it_stands():
    with pytest.raises(MachineError, match="line 2: no key is called 'stats'; did you mean states"):
        read('a: 1\nstats: 2\nb: "unclosed', ("a", "b", "states"))
    with pytest.raises(MachineError, match="line 1: a mapping is needed here"):
        read('- 1\n- "unclosed', ("a", "b", "states"))


@pytest.mark.parametrize(
    "word", ["no", "on", "off", "~", "null", "12:30:00", "1e3", "017", ".nan", "2026-01-01", "0x10"]
)
def test_scalars_stay_text(word):
    assert read(f"a: {word}").plain() == {"a": word}


def test_values_know_their_lines():
    root = read("a: 1\nb:\n  - x\n  - y\nt: |\n  one\n  two\n")
    entries = root.entries("a", "b", "t")
    assert [node.line for node in entries["b"].items()] == [3, 4]
    assert entries["t"].first_line == 6
    assert root.key_lines == {"a": 1, "b": 2, "t": 5}


def test_repeated_key_names_both_lines():
    with pytest.raises(MachineError, match=r"line 3: the key 'a' was already given in line 1"):
        read("a: 1\nb: 2\na: 3")


def test_unknown_key_names_the_nearest():
    with pytest.raises(MachineError, match=r"line 2: no key is called 'inital'; did you mean initial\?"):
        read("states: x\ninital: y").entries("states", "initial")


def test_the_caller_chooses_the_error():
    with pytest.raises(TextError):
        parse("a: *b", "character.yaml", TextError)


@pytest.mark.parametrize("word", ["x", "nan", "1e999", "1_0", "-1", "11"])
def test_numbers_are_finite_and_in_range(word):
    with pytest.raises(MachineError, match="number"):
        read(word).number(0, 10)


def test_numbers_and_truths():
    assert read("2.5").number(0, 10) == 2.5
    assert read("true").truth() is True
    with pytest.raises(MachineError, match="neither"):
        read("yes").truth()


def test_wrong_shapes_are_refused():
    for ask in (lambda node: node.text(), lambda node: node.entries()):
        with pytest.raises(MachineError, match="line 1"):
            ask(read("[a]"))
    with pytest.raises(MachineError, match="a list"):
        read("a").items()


def test_files_are_checked_before_they_are_read(tmp_path):
    path = tmp_path / "machine.yaml"
    with pytest.raises(MachineError, match="no such file"):
        read_text(path, MachineError)
    path.write_bytes(b"a: \xff")
    with pytest.raises(MachineError, match=r"byte 3: this is not UTF-8"):
        read_text(path, MachineError)
    path.write_bytes(b"a" * ((1 << 20) + 1))
    with pytest.raises(MachineError, match="larger than 1 MiB"):
        read_text(path, MachineError)


@given(st.text(alphabet="ab:-[]{}#&*!|>'\"%@`,? \n\t\\u0\ud800", max_size=60))
def test_any_text_is_read_or_refused(text):
    found = []
    for parser in (Parser, PureParser):
        try:
            found.append(read(text, parser=parser).plain())
        except StatwalkError:
            found.append(None)
    assert found[0] == found[1] or None in found  # each refuses a few things that the other reads
