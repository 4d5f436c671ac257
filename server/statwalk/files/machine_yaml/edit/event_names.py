"""Renames an event, or a marker, wherever a machine file speaks of it."""

from __future__ import annotations

import re
from collections.abc import Iterator

from statwalk.files.machine_yaml.edit.raw_table import RawTable
from statwalk.files.machine_yaml.edit.renaming import (
    Rename,
    keys_renamed,
    same,
    sentence_renamed,
    value_renamed,
)
from statwalk.files.machine_yaml.edit.table_levels import TableLevel, levels, read, table_changes
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.files.yaml.yaml_node import Node
from statwalk.files.yaml.yaml_places import Splice, find
from statwalk.machine.definition.state_table import CELL

RAISED = re.compile(r"\s*raise\s*\(\s*([^,()\s]+)")
MARKER = "marker "


def event_renamed(text: MachineText, old: str, new: str) -> MachineText:
    """Returns the text with another name for an event, and for the markers of this name."""

    def in_table(_: TableLevel, table: RawTable) -> None:
        if old in table.columns():
            table.rename_column(old, new)
        table.change(lambda cell: _cell(cell, old, new))

    return table_changes(text, in_table).applied(text, _splices(text.yaml, read(text), old, new))


def _cell(cell: str, old: str, new: str) -> str:
    """The cell of a table: `WALK at MARKER`."""
    match = CELL.fullmatch(cell)
    return cell[: match.start("timing")] + new if match and match["timing"] == old else cell


def _splices(text: str, root: Node, old: str, new: str) -> Iterator[Splice]:
    """The replacements outside of tables."""

    def name(name: str) -> str:
        return new if name == old else name

    for level in levels(root):
        yield from _in_cells(text, level, old, new)
        for state in level.states().values():
            for markers in _markers(state):
                yield from keys_renamed(text, markers, name)
    for section in ("events", "senses"):
        yield from keys_renamed(text, root.entries().get(section), name)
    for key in _nodes(root.entries().get("keys")):
        for kind in ("press", "hold", "release"):
            yield from _text(find(key, (kind,)), name)
    for parameter in _nodes(root.entries().get("parameters")):
        yield from _text(find(parameter, ("handle", "event")), name)
    yield from _text(root.entries().get("idle"), name)
    properties = root.entries().get("properties")
    for sentence in properties.items() if properties is not None else ():
        changed = sentence_renamed(sentence.text(), same, name)
        yield from value_renamed(sentence, changed, bool(properties and properties.style))


def _in_cells(text: str, level: TableLevel, old: str, new: str) -> Iterator[Splice]:
    """The replacements under `cells`: the names of cells, moments at a marker, raised events."""
    cells = level.entry("cells")

    def name(key: str) -> str:
        row, _, event = key.partition("/")
        return f"{row}/{new}" if event == old else key

    yield from keys_renamed(text, cells, name)
    for entry in _nodes(cells):
        for node in (entry, *_alternatives(entry)):
            when, to, action = (find(node, (key,)) for key in ("when", "to", "action"))
            yield from _text(when, lambda when: f"{MARKER}{new}" if when == f"{MARKER}{old}" else when)
            yield from _text(to, lambda cell: _cell(cell, old, new))
            yield from _text(action, lambda action: _action(action, old, new), True)


def _alternatives(entry: Node) -> list[Node]:
    """The alternatives of an entry that are written as a list."""
    target = find(entry, ("to",)) or entry
    return target.items() if isinstance(target.value, list) else []


def _action(action: str, old: str, new: str) -> str:
    """`raise(EVENT, WHOM)` with the other event."""
    match = RAISED.match(action)
    if match is None or match[1] != old:
        return action
    return action[: match.start(1)] + new + action[match.end(1) :]


def _text(node: Node | None, new: Rename, in_brackets: bool = False) -> Iterator[Splice]:
    if node is not None and node.is_text:
        yield from value_renamed(node, new(node.text()), in_brackets)


def _nodes(node: Node | None) -> list[Node]:
    return list(node.entries().values()) if node is not None and node.is_mapping else []


def _markers(state: Node) -> Iterator[Node]:
    """The mappings from markers to phases of a state: its own, and those of the clips of its blend."""
    if own := find(state, ("markers",)):
        yield own
    yield from _nodes(find(state, ("motion", "markers")))


def markers_of(root: Node) -> dict[str, None]:
    """Returns the names of all markers that states name."""
    names: dict[str, None] = {}
    for level in levels(root):
        for state in level.states().values():
            for markers in _markers(state):
                names |= dict.fromkeys(markers.entries() if markers.is_mapping else ())
    return names
