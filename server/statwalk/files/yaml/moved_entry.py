"""Moves an entry of a YAML text from one mapping to another, with the comments in its lines."""

from __future__ import annotations

from statwalk.files.yaml.yaml_edit import read, with_value, without
from statwalk.files.yaml.yaml_places import IN_BRACKETS, Path, Splice, find, newline_of, span_of, spliced
from statwalk.files.yaml.yaml_value import Spread

PLACEHOLDER = "_"


def entry_moved(text: str, path: Path, parent: Path) -> str:
    """Returns the text with the entry at `path` as the last one of the mapping at `parent`, which is made if
    there is none; a mapping that is empty then goes. Within brackets the entry has one line, and no comments.
    """
    key, source, target = path[-1], find(read(text), path[:-1]), find(read(text), parent)
    node = find(read(text), path)
    if source is None or node is None or not isinstance(key, str):
        return text
    if target is None or not target.value:
        text = with_value(text, parent, Spread({key: PLACEHOLDER}))
    else:
        text = with_value(text, (*parent, key), PLACEHOLDER)
    made = find(read(text), parent)
    if made is None or IN_BRACKETS in (source.style, made.style):
        text = with_value(text, (*parent, key), node.plain())
    else:
        text = _with_lines(text, path, (*parent, key))
    return without(text, path, len(path) - 2)


def _with_lines(text: str, path: Path, target: Path) -> str:
    """Returns the text with the lines of one entry in place of another's, as deep as those."""
    root = read(text)
    source, place = find(root, path[:-1]), find(root, target[:-1])
    assert source is not None
    assert place is not None
    lines, span = text[slice(*span_of(text, source, path[-1]))], span_of(text, place, target[-1])
    deeper = _indent(text[slice(*span)]) - _indent(lines)
    new = "".join(_indented(line, deeper) for line in lines.splitlines(keepends=True))
    end = "" if new.endswith("\n") or not text[slice(*span)].endswith("\n") else newline_of(text)
    return spliced(text, [Splice(*span, new + end)])


def _indent(lines: str) -> int:
    return len(lines) - len(lines.lstrip(" "))


def _indented(line: str, deeper: int) -> str:
    """Returns a line with more spaces before it, or with fewer; a blank line as it is."""
    if not line.strip():
        return line
    return " " * deeper + line if deeper > 0 else line[min(-deeper, _indent(line)) :]
