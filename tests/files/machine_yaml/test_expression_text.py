"""The expressions of a machine file as text: read, replaced, removed; every other line stays."""

import pytest
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.expression_text import expression_text, with_expressions
from statwalk.files.machine_yaml.machine_file import read_machine

HEAD = "character: c.glb\ninitial: A   # here\nstates: {A: {motion: m}}\ntable: |\n  state | END\n  A |\n"
TAIL = "\n# keys of the page\nkeys: {}\n"
BLOCK = "expressions: |    # what turns what\n  a = 1  # one\n\n  # two\n  b = a + 1\n"


def test_the_lines_are_read_with_their_comments() -> None:
    assert expression_text(HEAD + BLOCK + TAIL) == "a = 1  # one\n\n# two\nb = a + 1"
    assert expression_text(HEAD + "expressions: [a = 1, b = 2]\n" + TAIL) == "a = 1\nb = 2"
    assert expression_text(HEAD + "expressions:\n  - a = 1\n  - b = 2\n") == "a = 1\nb = 2"
    assert expression_text(HEAD + TAIL) == ""


@pytest.mark.parametrize(
    "block", [BLOCK, "expressions: [a = 1, b = 2]\n", "expressions:\n- a = 1\n- b = 2\n"]
)
def test_only_the_block_changes(block: str) -> None:
    changed = with_expressions(HEAD + block + TAIL, "  c = 3\n\nd = c  # why\n", "machine.yaml")
    assert changed == HEAD + "expressions: |\n  c = 3\n\n  d = c  # why\n" + TAIL
    assert [line.text for line in read_machine(changed).expressions] == ["c = 3", "d = c"]
    assert with_expressions(changed, expression_text(changed), "machine.yaml") == changed


def test_a_file_without_expressions_gets_them_at_its_end() -> None:
    changed = with_expressions((HEAD + TAIL).rstrip("\n"), "c = 3", "machine.yaml")
    assert changed == HEAD + TAIL + "expressions: |\n  c = 3\n"


def test_blank_text_takes_the_key_away() -> None:
    assert with_expressions(HEAD + BLOCK + TAIL, " \n", "machine.yaml") == HEAD + TAIL


def test_what_cannot_be_written_is_refused() -> None:
    with pytest.raises(MachineError, match="line 2: "):
        with_expressions(HEAD, "a = 1\nb = \x07", "machine.yaml")
    with pytest.raises(MachineError, match="written in braces"):
        with_expressions("{character: c.glb}\n", "a = 1", "machine.yaml")
