"""Strict YAML: text stays text, every value knows its line, and hostile documents are refused with theirs."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from statwalk.errors import MachineError, StatwalkError, TextError
from statwalk.files.yamltext import parse, read_text

HOSTILE = {
    "brackets": ("[" * 200_000, "more than 32 deep"),
    "braces": ("{" * 200_000, "more than 32 deep"),
    "dashes": ("- " * 100_000, "more than 32 deep"),
    "steps": ("\n".join(" " * depth + "a:" for depth in range(1, 900)), "more than 32 deep"),
    "huge": ("a" * ((1 << 20) + 1), "larger than 1 MiB"),
    "many": ("- a\n" * 60_000, "more than 50,000 values"),
    "anchor": ("a: &x b", "anchors"),
    "alias": ("a: *x", "aliases"),
    "tag": ("a: !!python/object/apply:os.system [ls]", "tags"),
    "bare tag": ("a: ! b", "tags"),
    "list as key": ("? [a]\n: b", "one value is wanted"),
    "two documents": ("a: b\n---\nc: d", "second document"),
    "zero byte": ("a\x00", "no text file"),
    "surrogate": ('"\\uD800"', "half a character"),
    "code point": ('"\\UFFFFFFFF"', "too large"),
    "version": (f"%YAML {'9' * 5000}.1\n--- a", "too large"),
    "unclosed": ("a: [b", "line 1"),
}


def read(text):
    return parse(text, "machine.yaml", MachineError)


@pytest.mark.parametrize(("text", "message"), HOSTILE.values(), ids=HOSTILE)
def test_hostile_text_is_refused(text, message):
    with pytest.raises(MachineError, match=message) as caught:
        read(text)
    assert caught.value.file == "machine.yaml"


@pytest.mark.parametrize("word", ["no", "on", "off", "~", "null", "12:30:00", "1e3", "017", ".nan", "2026-01-01", "0x10"])
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
    try:
        read(text).plain()
    except StatwalkError:
        return
