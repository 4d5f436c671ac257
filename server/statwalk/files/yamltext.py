"""Strict YAML: plain trees of text with line numbers, for files that come from anywhere.

    root = parse(text, "machine.yaml", MachineError)
    root.entries("initial", "states")["initial"].text()

No aliases, anchors or tags; a repeated key is an error; `no`, `on`, `12:30` and `1e3` stay text until somebody asks for a number.
What would take long to read is refused before PyYAML sees it.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import yaml

from statwalk.errors import ContentError
from statwalk.files.yamlnode import Node
from statwalk.files.yamltree import MOST_VALUES, Parser, Tree

__all__ = ["Node", "parse", "read_text"]

LARGEST_FILE = 1 << 20
LARGEST_BYTES = 1 << 17
LONGEST_LINE = 1 << 12

UNPRINTABLE = yaml.reader.Reader.NON_PRINTABLE


def read_text(path: Path, error: type[ContentError]) -> str:
    """A text file of at most 1 MiB (a table, say); raises `error` where it is missing, larger or not UTF-8."""
    if not path.is_file():
        raise error("there is no such file", file=str(path))
    if path.stat().st_size > LARGEST_FILE:
        raise error("the file is larger than 1 MiB", file=str(path))
    try:
        return path.read_bytes().decode("utf-8-sig")
    except UnicodeDecodeError as problem:
        raise error("this is not UTF-8", file=str(path), place=f"byte {problem.start}") from None


def parse(text: str, file: str, error: type[ContentError], known: tuple[str, ...] = (), parser: Any = Parser) -> Node:
    """The tree of a YAML document; raises `error` with file and line for whatever is not strict.

    With `known` the first key of the document that is not among them ends the reading.
    """
    check_size(text, file, error)
    try:
        return Tree(file, error, known).built(parser(text))
    except yaml.MarkedYAMLError as problem:
        mark = problem.problem_mark or problem.context_mark
        place = f"line {mark.line + 1}" if mark else ""
        raise error(f"this is not YAML: {problem.problem or problem.context}", file=file, place=place) from None


def check_size(text: str, file: str, error: type[ContentError]) -> None:
    """What would take long to read is refused before anything is read; raises `error`, with the line where there is one to name."""
    if len(text) > LARGEST_BYTES or len(text.encode("utf-8", "surrogatepass")) > LARGEST_BYTES:
        raise error(f"the text is larger than {LARGEST_BYTES >> 10} KiB; a table can stand in a .csv file of its own", file=file)
    strange = UNPRINTABLE.search(text)
    if strange:
        raise error("there is a character that no text file has", file=file, place=f"line {line_of(text, strange.start())}")
    marks = 0
    for number, line in enumerate(text.split("\n"), 1):
        marks += 1 + line.count(",") + line.count(": ")
        if len(line) > LONGEST_LINE or marks > MOST_VALUES:
            what = f"more than {MOST_VALUES:,} values" if marks > MOST_VALUES else f"the line is longer than {LONGEST_LINE:,} characters"
            raise error(what, file=file, place=f"line {number}")


def line_of(text: str, position: int) -> int:
    """The line, from 1, of a character."""
    return text.count("\n", 0, position) + 1
