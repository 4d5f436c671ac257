"""Renames a state wherever a machine file speaks of it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from statwalk.files.machine_yaml.edit.raw_table import RawTable
from statwalk.files.machine_yaml.edit.renaming import (
    StateNames,
    StateRename,
    keys_renamed,
    same,
    sentence_renamed,
    targets_renamed,
    value_renamed,
)
from statwalk.files.machine_yaml.edit.table_levels import TableLevel, entries_at, levels, table_changes
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.files.yaml.yaml_node import Node
from statwalk.files.yaml.yaml_places import Splice, find
from statwalk.machine.definition.machine_definition import BASE


def state_renamed(
    text: MachineText, root: Node, layer: str, rename: StateRename, also: Iterable[Splice] = ()
) -> MachineText:
    """Returns the text with another name for a state of a layer, and with other replacements; the key of the
    state itself stays.
    """
    changes = table_changes(text, lambda at, table: _rename_in_table(at, table, rename), layer)
    return changes.applied(text, [*_renamed_in_file(text.yaml, root, layer, rename), *also])


def state_names(root: Node, layer: str) -> StateNames:
    """Returns the full names of the states of a layer."""
    return StateNames(
        {level.full(name) for level in levels(root) if level.layer == layer for name in level.states()}
    )


def _rename_in_table(level: TableLevel, table: RawTable, rename: StateRename) -> None:
    for row in table.names():
        if (new := row_renamed(level, row, rename)) != row:
            table.rename_row(row, new)
    table.change(lambda cell: rename.of_cell(level.composite, cell))


def row_renamed(level: TableLevel, row: str, rename: StateRename) -> str:
    """Returns the new name of a row of a level, by which a state of the level or within is called there."""
    new = rename.full(level.full(row))
    return new.removeprefix(f"{rename.full(level.composite)}.") if level.composite else new


def _renamed_in_file(text: str, root: Node, layer: str, rename: StateRename) -> Iterator[Splice]:
    """The replacements outside of tables and of the key of the state itself."""
    for level in levels(root):
        if level.layer == layer:
            yield from _renamed_in_level(text, level, rename)
    if layer == BASE:
        yield from _renamed_in_base(text, root, rename)
    yield from keys_renamed(text, find(root, ("view", layer)), rename.full)
    elsewhere = {
        name for other in levels(root) if other.layer != layer for name in state_names(root, other.layer).full
    }
    for key in entries_at(root, "keys").values():
        # where another layer has a state of the same name, the key moves parameters in that one
        yield from keys_renamed(
            text, find(key, ("change",)), lambda name: name if name in elsewhere else rename.full(name)
        )


def _renamed_in_level(text: str, level: TableLevel, rename: StateRename) -> Iterator[Splice]:
    initial = level.entry("initial")
    if initial is not None:
        yield from value_renamed(initial, row_renamed(level, initial.text(), rename))

    def cell(key: str) -> str:
        row, slash, event = key.partition("/")
        return row_renamed(level, row, rename) + slash + event

    yield from keys_renamed(text, level.entry("cells"), cell)
    entries = level.cells().values()
    yield from targets_renamed(text, entries, lambda cell: rename.of_cell(level.composite, cell))


def _renamed_in_base(text: str, root: Node, rename: StateRename) -> Iterator[Splice]:
    fallback, properties = root.entries().get("fallback"), root.entries().get("properties")
    if fallback is not None:
        yield from value_renamed(fallback, rename.full(fallback.text()))
    for sentence in properties.items() if properties is not None else ():
        yield from value_renamed(
            sentence,
            sentence_renamed(sentence.text(), rename.full, same),
            bool(properties and properties.style),
        )
    for solver in entries_at(root, "solvers").values():
        yield from keys_renamed(text, find(solver, ("weight",)), rename.full)
