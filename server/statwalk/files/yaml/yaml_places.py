"""Where the values of a YAML text stand in it, and the replacement of letters there."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from statwalk.files.yaml.yaml_node import Node

Path = tuple[str | int, ...]
IN_BRACKETS = "{"
BLOCKS = ("|", ">")


class Splice(NamedTuple):
    """Replaces the letters from `start` up to `end`."""

    start: int
    end: int
    new: str


def spliced(text: str, splices: Iterable[Splice]) -> str:
    """Returns the text with all replacements, which must not overlap."""
    for start, end, new in sorted(splices, reverse=True):
        text = text[:start] + new + text[end:]
    return text


def find(root: Node, path: Path) -> Node | None:
    """Returns the value at a path; None if there is none."""
    node: Node | None = root
    for step in path:
        node = child(node, step) if node else None
    return node


def child(node: Node, step: str | int) -> Node | None:
    """Returns the value of a key, or the item at a place; None if there is none."""
    if isinstance(step, int):
        return node.value[step] if isinstance(node.value, list) and step < len(node.value) else None
    return node.value.get(step) if isinstance(node.value, dict) else None


def steps_of(node: Node) -> list[str | int]:
    """Returns the keys of a mapping, or the places of a list."""
    return list(node.value) if isinstance(node.value, dict) else list(range(len(node.value)))


def span_of(text: str, parent: Node, step: str | int) -> tuple[int, int]:
    """Returns the letters of an entry: within brackets from key to value, else whole lines."""
    node = child(parent, step)
    assert node is not None
    start = parent.key_spans[step][0] if isinstance(step, str) else node.start
    end = max(content_end(text, node), parent.key_spans[step][1] if isinstance(step, str) else start)
    if parent.style == IN_BRACKETS:
        return start, end
    return line_start(text, start), line_end(text, end)


def content_end(text: str, node: Node) -> int:
    """Returns where a value ends, without the comment after it."""
    if node.style in BLOCKS:
        return node.start + len(text[node.start : node.end].rstrip())
    if node.style == IN_BRACKETS or node.is_text:
        return node.end
    values = node.value.values() if isinstance(node.value, dict) else node.value
    return max((content_end(text, value) for value in values if isinstance(value, Node)), default=node.start)


def line_start(text: str, place: int) -> int:
    """Returns where the line begins that has a letter."""
    return text.rfind("\n", 0, place) + 1


def line_end(text: str, place: int) -> int:
    """Returns where the line after that of a letter begins."""
    end = text.find("\n", place)
    return len(text) if end < 0 else end + 1


def newline_of(text: str) -> str:
    """Returns the end of a line as the text has it."""
    return "\r\n" if "\r\n" in text else "\n"


def value_column(text: str, parent: Node) -> int | None:
    """Returns the column in which the values of a mapping stand, if keys of different lengths have theirs in
    one; else None.
    """
    columns, lengths = set(), set()
    for key, (start, end) in parent.key_spans.items():
        value = parent.entries()[key]
        if value.start > end and "\n" not in text[end : value.start]:
            columns.add(value.start - line_start(text, start))
            lengths.add(end - start)
    return columns.pop() if len(columns) == 1 and len(lengths) > 1 else None
