"""What a machine says, part by part: with this two texts are compared, letter by letter they are not."""

from __future__ import annotations

from collections.abc import Iterator

from statwalk.files.machine_yaml.edit.cell_edits import events_of, has_fields
from statwalk.files.machine_yaml.edit.entry_edits import KINDS
from statwalk.files.machine_yaml.edit.operation import Part, Parts
from statwalk.files.machine_yaml.edit.setting_edits import SETTINGS
from statwalk.files.machine_yaml.edit.table_levels import TableLevel, entries_at, levels, raw_table, read
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.files.yaml.yaml_node import Node
from statwalk.files.yaml.yaml_value import flow
from statwalk.machine.definition.machine_definition import BASE

BY_NAME = ("states", "table", "cells", "initial", "machine")
IN_PARTS = (*KINDS, *SETTINGS, *BY_NAME, "layers", "events", "properties", "defaults", "view")


def parts_of(text: MachineText) -> Parts:
    """Returns what a machine says in each of its parts.

    :raises MachineError: when the text cannot be read.
    """
    root = read(text)
    found: dict[Part, str] = {}
    for level in levels(root):
        found |= _parts_of_level(text, level)
    for name in events_of(text):
        found["name", "event", name] = ""
    for name, node in entries_at(root, "events").items():
        found |= _flat(node, ("event", name))
    for section, kind in KINDS.items():
        for name, node in entries_at(root, section).items():
            found["name", kind, name] = ""
            found |= _flat(node, (kind, name))
    found |= dict(_parts_of_file(root))
    return found


def _parts_of_level(text: MachineText, level: TableLevel) -> dict[Part, str]:
    found: dict[Part, str] = {}
    if level.layer != BASE and not level.composite:
        found["name", "layer", level.layer] = ""
        for key, node in level.node.entries().items():
            if key not in BY_NAME:
                found |= _flat(node, ("layer", level.layer, key))
    if (initial := level.entry("initial")) is not None:
        found["initial", level.layer, level.composite] = _said(initial)
    for name, node in level.states().items():
        state = level.full(name)
        found["name", "state", level.layer, state] = ""
        for key, value in node.entries().items() if node.is_mapping else ():
            if key != "machine":
                found |= _flat(value, ("state", level.layer, state, key))
    return found | _parts_of_cells(text, level)


def _parts_of_cells(text: MachineText, level: TableLevel) -> dict[Part, str]:
    found: dict[Part, str] = {}
    table, cells = raw_table(text, level), level.entry("cells")
    for column in table.columns() if table else ():
        found["column", level.layer, level.composite, column] = ""
    for row, event, cell in table.cells() if table else ():
        found["cell", level.layer, level.full(row), event, "to"] = cell
    for name, node in cells.entries().items() if cells is not None and cells.is_mapping else ():
        row, _, event = name.partition("/")
        place = "cell", level.layer, level.full(row), event
        for key, value in node.entries().items() if has_fields(node) else {"to": node}.items():
            found[*place, key] = _said(value)
    return found


def _parts_of_file(root: Node) -> Iterator[tuple[Part, str]]:
    """The parts that have one place in the file."""
    for key, node in root.entries().items():
        if key in SETTINGS:
            yield ("machine", key), _said(node)
        elif key in ("defaults", "contacts", "view"):
            yield from _flat(node, (key,)).items()
        elif key == "properties":
            for sentence in node.items() if node.value else ():
                yield ("property", _said(sentence)), ""
        elif key not in IN_PARTS:
            yield (key,), _said(node)


def _flat(node: Node, part: Part) -> dict[Part, str]:
    """The parts of a mapping, and of mappings in it."""
    if not node.is_mapping:
        return {part: _said(node)}
    found: dict[Part, str] = {}
    for key, value in node.entries().items():
        found |= _flat(value, (*part, key))
    return found


def _said(node: Node) -> str:
    return node.text() if node.is_text else flow(node.plain())
