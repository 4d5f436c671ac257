"""The tables of a machine as they are written: of the base, of layers, and of the machines within states."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import NamedTuple

from statwalk.errors import MachineError
from statwalk.files.machine_yaml.edit.raw_table import RawTable, table_of_csv, table_with_bars
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.files.yaml.yaml_places import Path, Splice, spliced
from statwalk.files.yaml.yaml_text import Node, parse
from statwalk.machine.definition.machine_definition import ANY, BASE


@dataclass(frozen=True)
class TableLevel:
    """The part of a file that has states and a table: `path` leads to it; `composite` is the state around
    it, empty at the top of a layer.
    """

    layer: str
    composite: str
    path: Path
    node: Node

    def full(self, name: str) -> str:
        """Returns the full name of a state of this level."""
        return f"{self.composite}.{name}" if self.composite else name

    def states(self) -> dict[str, Node]:
        """Returns the states of this level by their own names."""
        return entries_at(self.node, "states")

    def cells(self) -> dict[str, Node]:
        """Returns what stands under `cells` of this level, by STATE/EVENT."""
        return entries_at(self.node, "cells")

    def entry(self, key: str) -> Node | None:
        """Returns what a key of this level holds."""
        return self.node.entries().get(key)


def read(text: MachineText) -> Node:
    """Reads the machine file. :raises MachineError: when the text is not YAML."""
    root = parse(text.yaml, "", MachineError)
    if not root.is_mapping:
        raise MachineError("a machine file is a mapping (key: value)")
    return root


def levels(root: Node) -> list[TableLevel]:
    """Returns all levels: the base and the machines within its states, then each layer."""
    layers = root.entries().get("layers")
    found = list(_levels_in(TableLevel(BASE, "", (), root)))
    if layers is not None and layers.is_mapping:
        for name, node in layers.entries().items():
            if node.is_mapping:
                found += _levels_in(TableLevel(name, "", ("layers", name), node))
    return found


def _levels_in(level: TableLevel) -> Iterator[TableLevel]:
    yield level
    for name, state in level.states().items():
        machine = state.entries().get("machine") if state.is_mapping else None
        if machine is not None and machine.is_mapping:
            path = (*level.path, "states", name, "machine")
            yield from _levels_in(TableLevel(level.layer, level.full(name), path, machine))


def level_of(root: Node, layer: str, state: str) -> tuple[TableLevel, str]:
    """Returns the level that has a state (a full name, or OUTER.*), and the state's own name there; the state
    need not exist.

    :raises MachineError: when there is no layer or no machine within a state of this name.
    """
    found = [level for level in levels(root) if level.layer == layer]
    if not found:
        names = dict.fromkeys(level.layer for level in levels(root))
        raise root.unknown("layer", layer, names, 1)
    composite, _, name = state.rpartition(".")
    at = next((level for level in found if level.composite == composite), None)
    if at is None or (composite and state in at.states()):
        at = next((level for level in found if state in level.states()), at)  # a name with a dot in it
        name = state if at is not None and state in at.states() else name
    if at is None:
        inner = [level.composite for level in found if level.composite]
        raise root.unknown("sub-machine", composite, inner, 1)
    return at, name


def levels_of(root: Node, layer: str) -> list[TableLevel]:
    """Returns the levels of one layer."""
    return [level for level in levels(root) if level.layer == layer]


def entries_at(root: Node, key: str) -> dict[str, Node]:
    """Returns the entries of a section; none if it is missing or empty."""
    node = root.entries().get(key)
    return node.entries() if node is not None and node.is_mapping else {}


def own_name(level: TableLevel, state: str | None) -> str | None:
    """Returns the own name of a state of a level; None for None.

    :raises MachineError: when the level has no state of this full name.
    """
    if state is None:
        return None
    for own in level.states():
        if level.full(own) == state:
            return own
    raise level.node.unknown("state", state, [level.full(own) for own in level.states()])


def existing_state(root: Node, layer: str, state: str) -> tuple[TableLevel, str]:
    """Returns the level that has a state, and the state's own name there; `*` is no state, but a row.

    :raises MachineError: when there is no state of this name.
    """
    level, name = level_of(root, layer, state)
    if name != ANY and name not in level.states():
        raise level.node.unknown("state", state, [level.full(own) for own in level.states()])
    return level, name


def raw_table(text: MachineText, level: TableLevel) -> RawTable | None:
    """Returns the table of a level as it is written; None if it has none.

    :raises MachineError: when it is written in another way than as a block (`table: |`) or a .csv file.
    """
    node = level.entry("table")
    if node is None:
        return None
    if (name := _file_of(text, node)) is not None:
        return table_of_csv(text.tables[name])
    if node.style != "|":
        raise node.refuse("this table is no block (`table: |`) and no .csv file; edit it in the text")
    start, end = _block(text.yaml, node)
    return table_with_bars(text.yaml[start:end])


class TableChanges(NamedTuple):
    """Replacements in the machine file, and the .csv tables as they are then."""

    splices: list[Splice]
    tables: dict[str, str]

    def applied(self, text: MachineText, also: Iterable[Splice] = ()) -> MachineText:
        """Returns the text with the changes, and with other replacements in the machine file."""
        return MachineText(spliced(text.yaml, [*self.splices, *also]), self.tables)


def table_changes(
    text: MachineText, change: Callable[[TableLevel, RawTable], None], layer: str = ""
) -> TableChanges:
    """Returns what changes if `change` is made in the tables of all levels, or of those of one layer."""
    changes = TableChanges([], dict(text.tables))
    for level in levels(read(text)):
        if layer in ("", level.layer) and (table := raw_table(text, level)) is not None:
            before = table.text()
            change(level, table)
            if table.text() != before:
                _note(changes, text, level, table)
    return changes


def with_table(text: MachineText, level: TableLevel, table: RawTable) -> MachineText:
    """Returns the text with another table in a level; the text is the one that the level was read from."""
    changes = TableChanges([], dict(text.tables))
    _note(changes, text, level, table)
    return changes.applied(text)


def _note(changes: TableChanges, text: MachineText, level: TableLevel, table: RawTable) -> None:
    node = level.node.entries()["table"]
    if (name := _file_of(text, node)) is not None:
        changes.tables[name] = table.text()
    else:
        changes.splices.append(Splice(*_block(text.yaml, node), table.text()))


def _file_of(text: MachineText, node: Node) -> str | None:
    """The name of the .csv file that holds the table; None if the key itself does."""
    name = node.text().strip()
    return name if name in text.tables else None


def _block(yaml: str, node: Node) -> tuple[int, int]:
    """The letters of a block: the lines below its `|`, without blank ones at the end."""
    start = yaml.index("\n", node.start) + 1
    end = node.start + len(yaml[node.start : node.end].rstrip())
    line_end = yaml.find("\n", end)
    return start, len(yaml) if line_end < 0 else line_end + 1
