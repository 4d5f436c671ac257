"""Changes a YAML text entry by entry; every other letter stays: comments, order, layout.

A path leads from the top of the document to a value: `("states", "WALK", "loop")`; a number is a place in a
list. Each function reads the text, and returns another one.
"""

from __future__ import annotations

from statwalk.errors import ContentError
from statwalk.files.yaml.yaml_node import Node
from statwalk.files.yaml.yaml_places import (
    BLOCKS,
    IN_BRACKETS,
    Path,
    Splice,
    child,
    content_end,
    find,
    line_end,
    line_start,
    newline_of,
    span_of,
    spliced,
    steps_of,
    value_column,
)
from statwalk.files.yaml.yaml_text import parse
from statwalk.files.yaml.yaml_value import Value, after_key, flow, text_of


def read(text: str) -> Node:
    """Reads the text. :raises ContentError: when the text is not YAML."""
    return parse(text, "", ContentError)


def with_value(text: str, path: Path, value: Value, before: str | None = None) -> str:
    """Returns the text with a value at a path; mappings on the way are made. A new entry comes before the
    entry `before`, or last.
    """
    root = read(text)
    *outer, last = path
    parent = find(root, tuple(outer))
    if parent is None or not parent.value:
        return with_value(text, tuple(outer), [value] if isinstance(last, int) else {last: value})
    node = child(parent, last)
    if node is not None:
        return spliced(text, [_replacement(text, parent, last, node, value)])
    if isinstance(last, int):
        return spliced(text, [_new_item(text, parent, last, value)])
    return spliced(text, [_new_entry(text, parent, last, value, before)])


def without(text: str, path: Path, keep: int = 0) -> str:
    """Returns the text without an entry of a mapping or an item of a list, and without what is empty then;
    the first `keep` steps of the path stay.
    """
    parent = find(read(text), path[:-1])
    if parent is None or child(parent, path[-1]) is None:
        return text
    if len(parent.value) == 1 and len(path) - 1 > keep:
        return without(text, path[:-1], keep)
    if len(parent.value) == 1 and path[:-1]:
        return with_value(text, path[:-1], {} if parent.is_mapping else [])
    return spliced(text, [_removal(text, parent, path[-1])])


def with_key(text: str, path: Path, key: str) -> str:
    """Returns the text with another key for the entry at a path."""
    parent = find(read(text), path[:-1])
    if parent is None or not isinstance(path[-1], str):
        return text
    return spliced(text, [renamed_key(text, parent, path[-1], key)])


def renamed_key(text: str, parent: Node, old: str, key: str) -> Splice:
    """Returns the replacement of a key; where values stand in a column, the value stays in it."""
    start, end = parent.key_spans[old]
    in_brackets = parent.style == IN_BRACKETS
    new, column = text_of(key, in_brackets), None if in_brackets else value_column(text, parent)
    value = parent.entries()[old]
    if column is None or value.start < end or "\n" in text[end : value.start]:
        return Splice(start, end, new)
    colon = text[end : value.start].rstrip(" ")
    used = start - line_start(text, start) + len(new) + len(colon)
    return Splice(start, value.start, new + colon + " " * max(1, column - used))


def moved(text: str, path: Path, before: str | int | None) -> str:
    """Returns the text with the entry at a path before another entry of its mapping, or at its end."""
    parent = find(read(text), path[:-1])
    steps = steps_of(parent) if parent else []
    if parent is None or path[-1] not in steps or before == path[-1]:
        return text
    others = [step for step in steps if step != path[-1]]
    place = others.index(before) if before is not None else len(others)
    others.insert(place, path[-1])
    spans = [span_of(text, parent, step) for step in steps]
    return spliced(
        text,
        [
            Splice(*span, _ended(text[slice(*span_of(text, parent, step))], text[slice(*span)]))
            for span, step in zip(spans, others, strict=True)
        ],
    )


def _ended(new: str, old: str) -> str:
    """Returns an entry with the end of the line, or without, as the entry had it in whose place it comes."""
    body = new.rstrip("\r\n")
    return body + old[len(old.rstrip("\r\n")) :]


def _replacement(text: str, parent: Node, step: str | int, node: Node, value: Value) -> Splice:
    if parent.style == IN_BRACKETS:
        return Splice(node.start, node.end, " " * (node.start == node.end) + flow(value, True))
    if isinstance(step, int):
        return Splice(node.start, content_end(text, node), flow(value))
    start, end = parent.key_spans[step]
    colon = text.index(":", end) + 1
    if "\n" not in text[colon : node.start] and node.style not in BLOCKS:
        written, gap = _below(text, start, colon, value), text[colon : node.start] or " "
        end = max(colon, content_end(text, node))
        return Splice(colon, end, written if written.startswith(("\r", "\n")) else gap + written)
    stop = len(text[: line_end(text, colon)].rstrip("\r\n"))
    comment = text[colon:stop] if node.style not in BLOCKS else ""
    written = after_key(value, start - line_start(text, start), colon - start, newline_of(text))
    head, *rest = written.split(newline_of(text), 1)
    comment = comment if comment.strip() else ""
    return Splice(colon, content_end(text, node), head + comment + newline_of(text).join(["", *rest]))


def _below(text: str, start: int, colon: int, value: Value) -> str:
    indent = start - line_start(text, start)
    return after_key(value, indent, colon - line_start(text, start), newline_of(text)).removeprefix(" ")


def _new_entry(text: str, parent: Node, key: str, value: Value, before: str | None) -> Splice:
    steps = list(parent.entries())
    place = steps.index(before) if before in steps else len(steps)
    if parent.style == IN_BRACKETS:
        entry = f"{text_of(key, True)}: {flow(value, True)}"
        if place:
            end = span_of(text, parent, steps[place - 1])[1]
            return Splice(end, end, f", {entry}")
        start = parent.key_spans[steps[0]][0]
        return Splice(start, start, f"{entry}, ")
    first = parent.key_spans[steps[0]][0]
    indent = first - line_start(text, first)
    entry = " " * indent + text_of(key) + ":"
    column = value_column(text, parent)
    gap = " " * (column - len(entry) - 1) if column else ""
    after = after_key(value, indent, len(entry) + len(gap), newline_of(text))
    entry += after if after.startswith(("\r", "\n")) else gap + after
    if not place:
        return _new_line(text, line_start(text, first), entry)
    blank = newline_of(text) * (not indent and newline_of(text) in entry)
    return _new_line(text, span_of(text, parent, steps[place - 1])[1], blank + entry)


def _new_item(text: str, parent: Node, place: int, value: Value) -> Splice:
    """An item after the item `place - 1` of a list that has items."""
    count = len(parent.value)
    place = min(place, count)
    end = span_of(text, parent, place - 1)[1] if place else 0
    if parent.style == IN_BRACKETS:
        return Splice(end, end, f", {flow(value, True)}")
    line = text[line_start(text, parent.start) :]
    dash = line[: len(line) - len(line.lstrip(" "))] + "- "
    return _new_line(text, end, dash + flow(value))


def _new_line(text: str, place: int, line: str) -> Splice:
    newline = newline_of(text)
    if place == len(text) and text and not text.endswith("\n"):
        return Splice(place, place, newline + line)
    return Splice(place, place, line + newline)


def _removal(text: str, parent: Node, step: str | int) -> Splice:
    steps = steps_of(parent)
    place = steps.index(step)
    start, end = span_of(text, parent, step)
    if parent.style != IN_BRACKETS:
        return Splice(_without_blank_line(text, start, end), end, "")
    if place:
        return Splice(span_of(text, parent, steps[place - 1])[1], end, "")
    if len(steps) > 1:
        return Splice(start, span_of(text, parent, steps[1])[0], "")
    return Splice(start, end, "")


def _without_blank_line(text: str, start: int, end: int) -> int:
    """Returns where lines begin, with the blank line before them if a blank line, or nothing, comes after."""
    before = line_start(text, start - 1) if start else 0
    is_alone = not text[before:start].strip() and not text[end : line_end(text, end)].strip()
    return before if is_alone else start
