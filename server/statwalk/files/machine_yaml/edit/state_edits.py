"""Changes states: adds, changes, renames, deletes and reorders them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field

from statwalk.errors import MachineError
from statwalk.files.machine_yaml.edit.operation import EditOperation, Part
from statwalk.files.machine_yaml.edit.raw_table import RawTable
from statwalk.files.machine_yaml.edit.renaming import (
    StateNames,
    StateRename,
    check_name,
    keys_renamed,
    same,
    sentence_renamed,
    targets_renamed,
    value_renamed,
)
from statwalk.files.machine_yaml.edit.table_levels import (
    TableLevel,
    existing_state,
    level_of,
    levels,
    own_name,
    raw_table,
    read,
    table_changes,
    with_table,
)
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.files.yaml.yaml_edit import moved, renamed_key, with_value, without
from statwalk.files.yaml.yaml_node import Node
from statwalk.files.yaml.yaml_places import Path, Splice, find
from statwalk.files.yaml.yaml_value import Value
from statwalk.machine.definition.machine_definition import BASE

AT_REST: Mapping[str, Value] = {"expressions": ""}
"""the motion that every character has: its pose at rest"""
NO_MOTION = "none"


@dataclass(frozen=True)
class AddState(EditOperation):
    """Adds a state with a row of blank cells; `fields` as in the file, None as if left out.

    Without a `motion` it is at rest (in a layer above the base: `none`). It comes before the state `before`,
    or last.
    """

    state: str
    fields: Mapping[str, Value | None] = field(default_factory=dict)
    before: str | None = None
    layer: str = BASE

    def __str__(self) -> str:
        return f"new state {self.state}"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the state."""
        level, name = level_of(read(text), self.layer, self.state)
        check_name(name, "state")
        if name in level.states():
            raise MachineError(f"there is a state {self.state} already")
        before = own_name(level, self.before)
        fields = given_fields(self.fields)
        if not {"motion", "machine"} & fields.keys():
            fields = {"motion": AT_REST if self.layer == BASE else NO_MOTION, **fields}
        if (table := raw_table(text, level)) is not None and name not in table.names():
            table.add_row(name, before)
            text = with_table(text, level, table)
        return text._replace(yaml=with_value(text.yaml, (*level.path, "states", name), fields, before))

    def touched(self) -> Iterable[Part]:
        """The name."""
        yield "name", "state", self.layer, self.state


@dataclass(frozen=True)
class SetState(EditOperation):
    """Changes `motion`, `loop`, `speed`, `framing`, `final`, `resume` or `markers` of a state; None removes
    one.
    """

    state: str
    fields: Mapping[str, Value | None]
    layer: str = BASE

    def __str__(self) -> str:
        return f"{self.state}: {', '.join(self.fields)}"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the fields."""
        level, name = existing_state(read(text), self.layer, self.state)
        return with_fields(text, (*level.path, "states", name), self.fields)

    def touched(self) -> Iterable[Part]:
        """The name, and the fields."""
        yield "name", "state", self.layer, self.state
        for name in self.fields:
            yield "state", self.layer, self.state, name


@dataclass(frozen=True)
class RenameState(EditOperation):
    """Renames a state everywhere in the file; `to` is its new name, without the composite state around it."""

    state: str
    to: str
    layer: str = BASE

    def __str__(self) -> str:
        return f"{self.state} is now {self.to}"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the other name."""
        root = read(text)
        level, name = existing_state(root, self.layer, self.state)
        check_name(self.to, "state")
        if self.to == name:
            return text
        if self.to in level.states():
            raise MachineError(f"there is a state {level.full(self.to)} already")
        rename = StateRename(state_names(root, self.layer), self.state, level.full(self.to))
        splices = [*_renamed_in_file(text.yaml, root, self.layer, rename)]
        splices.append(renamed_key(text.yaml, level.node.entries()["states"], name, self.to))
        changes = table_changes(text, lambda at, table: _rename_in_table(at, table, rename), self.layer)
        return changes.applied(text, splices)

    def touched(self) -> Iterable[Part]:
        """Both names."""
        outer = self.state.rpartition(".")[0]
        yield "name", "state", self.layer, self.state
        yield "name", "state", self.layer, f"{outer}.{self.to}" if outer else self.to


def state_names(root: Node, layer: str) -> StateNames:
    """Returns the full names of the states of a layer."""
    return StateNames(
        {level.full(name) for level in levels(root) if level.layer == layer for name in level.states()}
    )


def _rename_in_table(level: TableLevel, table: RawTable, rename: StateRename) -> None:
    for row in table.names():
        if (new := _row(level, row, rename)) != row:
            table.rename_row(row, new)
    table.change(lambda cell: rename.of_cell(level.composite, cell))


def _row(level: TableLevel, row: str, rename: StateRename) -> str:
    """The new name of a row of a level, by which a state of the level or within is called there."""
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
        yield from value_renamed(initial, _row(level, initial.text(), rename))

    def cell(key: str) -> str:
        row, slash, event = key.partition("/")
        return _row(level, row, rename) + slash + event

    yield from keys_renamed(text, level.entry("cells"), cell)
    yield from targets_renamed(text, level, rename)


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


def entries_at(root: Node, key: str) -> dict[str, Node]:
    """Returns the entries of a section of the file; none if it is missing or empty."""
    node = root.entries().get(key)
    return node.entries() if node is not None and node.is_mapping else {}


def given_fields(fields: Mapping[str, Value | None]) -> dict[str, Value]:
    """Returns the fields of a new entry: None takes nothing away there."""
    return {name: value for name, value in fields.items() if value is not None}


def with_fields(text: MachineText, path: Path, fields: Mapping[str, Value | None]) -> MachineText:
    """Returns the text with other fields of the entry at a path; None removes a field."""
    yaml = text.yaml
    for name, value in fields.items():
        yaml = (
            without(yaml, (*path, name), len(path))
            if value is None
            else with_value(yaml, (*path, name), value)
        )
    return text._replace(yaml=yaml)


@dataclass(frozen=True)
class MoveState(EditOperation):
    """Moves a state, and its row, before another state of its machine, or to the end."""

    state: str
    before: str | None = None
    layer: str = BASE

    def __str__(self) -> str:
        return f"{self.state} moved"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text in the other order."""
        level, name = existing_state(read(text), self.layer, self.state)
        before = own_name(level, self.before)
        if (table := raw_table(text, level)) is not None and name in table.names() and before != name:
            table.move_row(name, before if before in table.names() else None)
            text = with_table(text, level, table)
        return text._replace(yaml=moved(text.yaml, (*level.path, "states", name), before))

    def touched(self) -> Iterable[Part]:
        """The name."""
        yield "name", "state", self.layer, self.state
