"""Changes the expressions in a machine file's text; every other line stays."""

from __future__ import annotations

from statwalk.errors import MachineError
from statwalk.files.yaml.yaml_text import parse

KEY = "expressions:"


def expression_text(text: str) -> str:
    """Returns the lines of the machine's expressions as they are written, with comments; "" for none."""
    lines = text.splitlines(keepends=True)
    first, end = _block(lines)
    if first == end:
        return ""
    node = parse("".join(lines[first:end]), "", MachineError).entries()["expressions"]
    if node.value == "" or node.is_text:
        return node.text().rstrip("\n") if node.value else ""
    return "\n".join(item.text() for item in node.items())


def with_expressions(text: str, new: str, file: str) -> str:
    """Returns the machine file's text with other expressions, the lines `new`; without the key if `new` is
    blank.

    :raises MachineError: when a line cannot stand in a file, or the file has no key at the start of a line.
    """
    written = [line.expandtabs().strip() for line in new.strip().splitlines()]
    for number, line in enumerate(written, 1):
        if not line.isprintable():
            raise MachineError("a line has a character that cannot be written", place=f"line {number}")
    lines = text.splitlines(keepends=True)
    if any(line.startswith(("{", "[")) for line in lines):
        raise MachineError("this file is written in braces; edit its expressions in the file", file=file)
    first, end = _block(lines)
    if lines and not lines[-1].endswith("\n"):
        lines[-1] += "\n"
    block = [f"{KEY} |\n", *(f"  {line}".rstrip() + "\n" for line in written)] if written else []
    return "".join([*lines[:first], *block, *lines[end:]])


def _block(lines: list[str]) -> tuple[int, int]:
    """Returns first and end of the lines that hold the expressions; both are the file's end if none do."""
    first = next((row for row, line in enumerate(lines) if line.startswith(KEY)), len(lines))
    end = first + 1
    while end < len(lines) and (not lines[end].strip() or lines[end][0] in " \t#-"):
        end += 1
    while end > first + 1 and end <= len(lines) and (not lines[end - 1].strip() or lines[end - 1][0] == "#"):
        end -= 1  # blank lines and comments before the next key are the next key's
    return first, min(end, len(lines))
