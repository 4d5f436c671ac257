"""Strict YAML: plain trees of text with line numbers, for files from any source.

    root = parse(text, "machine.yaml", MachineError)
    root.entries("initial", "states")["initial"].text()

No aliases, anchors or tags; a repeated key is an error; `no`, `on`, `12:30` and `1e3` stay text until a
reader requests a number. A text that would take long to read is refused before PyYAML reads it.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import yaml

from statwalk.errors import ContentError
from statwalk.files.yaml.yaml_node import Node
from statwalk.files.yaml.yaml_tree import MOST_VALUES, Parser, Tree

__all__ = ["Node", "parse", "read_text", "tree_of_json"]

LARGEST_FILE = 1 << 20
LARGEST_BYTES = 1 << 17
LONGEST_LINE = 1 << 12

UNPRINTABLE = yaml.reader.Reader.NON_PRINTABLE


def read_text(path: Path, error: type[ContentError]) -> str:
    """Reads a text file of at most 1 MiB (a table, for example).

    :raises ContentError: when the file is missing, larger or not UTF-8; `error` is the class of the error.
    """
    if not path.is_file():
        raise error("there is no such file", file=str(path))
    if path.stat().st_size > LARGEST_FILE:
        raise error("the file is larger than 1 MiB", file=str(path))
    try:
        return path.read_bytes().decode("utf-8-sig")
    except UnicodeDecodeError as problem:
        raise error("this is not UTF-8", file=str(path), place=f"byte {problem.start}") from None


def parse(
    text: str,
    file: str,
    error: type[ContentError],
    top_level_keys: tuple[str, ...] = (),
    parser: Any = Parser,
) -> Node:
    """Reads the tree of a YAML document.

    With `top_level_keys`, the first key of the document that is not among them ends the reading.

    :raises ContentError: when the document is not strict YAML; `error` is the class, file and line say where.
    """
    _check_size(text, file, error)
    try:
        return Tree(file, error, top_level_keys).build(parser(text))
    except yaml.MarkedYAMLError as problem:
        mark = problem.problem_mark or problem.context_mark
        place = f"line {mark.line + 1}" if mark else ""
        raise error(
            f"this is not YAML: {problem.problem or problem.context}", file=file, place=place
        ) from None


def tree_of_json(value: Any, error: type[ContentError]) -> Node:
    """Returns a JSON value as the tree that the same words in a file would give. JSON is YAML.

    :raises ContentError: when the value is nested too deep, or too large; `error` is the class of the error.
    """
    try:
        text = json.dumps(value, indent=1, ensure_ascii=False)
    except RecursionError:
        raise error("it is nested too deep") from None
    return parse(text, "", error)


def _check_size(text: str, file: str, error: type[ContentError]) -> None:
    """Refuses a text that would take long to read before anything is read; the error has the line, if there
    is one.
    """
    if len(text) > LARGEST_BYTES or len(text.encode("utf-8", "surrogatepass")) > LARGEST_BYTES:
        raise error(
            f"the text is larger than {LARGEST_BYTES >> 10} KiB; move a large table to a .csv file",
            file=file,
        )
    unprintable = UNPRINTABLE.search(text)
    if unprintable:
        raise error(
            "there is an unprintable character here",
            file=file,
            place=f"line {_line_of(text, unprintable.start())}",
        )
    marks = 0
    for number, line in enumerate(text.split("\n"), 1):
        marks += 1 + line.count(",") + line.count(": ")
        if len(line) > LONGEST_LINE or marks > MOST_VALUES:
            message = (
                f"more than {MOST_VALUES:,} values"
                if marks > MOST_VALUES
                else f"the line is longer than {LONGEST_LINE:,} characters"
            )
            raise error(message, file=file, place=f"line {number}")


def _line_of(text: str, position: int) -> int:
    return text.count("\n", 0, position) + 1
