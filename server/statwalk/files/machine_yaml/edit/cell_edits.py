"""Changes cells: the text in the table, and what `cells` says of it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from statwalk.errors import MachineError
from statwalk.files.machine_yaml.cells import CELL_KEYS
from statwalk.files.machine_yaml.edit.operation import EditOperation, Part
from statwalk.files.machine_yaml.edit.table_levels import (
    TableLevel,
    existing_state,
    levels,
    raw_table,
    read,
    with_table,
)
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.files.yaml.yaml_edit import with_value, without
from statwalk.files.yaml.yaml_node import Node
from statwalk.files.yaml.yaml_places import find
from statwalk.files.yaml.yaml_value import Value
from statwalk.machine.definition.machine_definition import ANY, BASE, END
from statwalk.machine.definition.state_table import read_cell

LONGEST_CELL = 200
ALTERNATIVES = "alternatives"


@dataclass(frozen=True)
class SetCell(EditOperation):
    """Changes a cell. `text` is the cell of the table (empty: blank; None: as it is); `fields` has what
    stands under `cells`: `when`, `blend`, `enter`, `action`, `off`, and `alternatives` (a list, or weights
    by state); None removes a field. `state` is a full name, or `*`; so is `event`.
    """

    state: str
    event: str
    text: str | None = None
    fields: Mapping[str, Value | None] = field(default_factory=dict)
    layer: str = BASE

    def __str__(self) -> str:
        changes = [] if self.text is None else [self.text or "blank"]
        return f"{self.state}/{self.event}: {', '.join([*changes, *self.fields])}"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the cell."""
        for name, value in self.fields.items():
            if name != ALTERNATIVES:
                text = self._with_field(text, name, value)
        if ALTERNATIVES in self.fields:
            text = self._with_target(text, self.fields[ALTERNATIVES])
        return text if self.text is None else self._with_text(text, self.text.strip())

    def touched(self) -> Iterable[Part]:
        """The cell, and the names of its state and its event."""
        yield "name", "state", self.layer, self.state
        yield "name", "event", self.event
        cell = "cell", self.layer, self.state, self.event
        if self.text == "":
            yield cell
        elif self.text is not None or ALTERNATIVES in self.fields:
            yield *cell, "to"
        for name in self.fields.keys() - {ALTERNATIVES}:
            yield *cell, name

    # --- under `cells`

    def _place(self, text: MachineText) -> tuple[TableLevel, str, Node | None]:
        """The level, the name under `cells`, and what stands there."""
        level, row = existing_state(read(text), self.layer, self.state)
        name = f"{row}/{self.event}"
        cells = level.entry("cells")
        return level, name, find(cells, (name,)) if cells is not None else None

    def _with_field(self, text: MachineText, name: str, value: Value | None) -> MachineText:
        if name not in CELL_KEYS:
            raise MachineError(f"a cell has no {name!r}; it has {', '.join(CELL_KEYS)}")
        level, cell, node = self._place(text)
        path = (*level.path, "cells", cell)
        if node is not None and not has_fields(node):
            if value is None:
                return text
            new = {"to": node.plain(), name: value}  # what was the whole cell becomes a field of it
            return text._replace(yaml=with_value(text.yaml, path, new))
        if value is None:
            return text._replace(yaml=without(text.yaml, (*path, name), len(level.path)))
        return text._replace(yaml=with_value(text.yaml, (*path, name), value))

    def _with_target(self, text: MachineText, target: Value | None) -> MachineText:
        """Sets or removes the next states under `cells`."""
        level, cell, node = self._place(text)
        path = (*level.path, "cells", cell)
        alone = node is None or not has_fields(node) or set(node.entries()) == {"to"}
        if target is None and alone:
            return text._replace(yaml=without(text.yaml, path, len(level.path)))
        if target is None:
            return text._replace(yaml=without(text.yaml, (*path, "to"), len(level.path)))
        if alone and not isinstance(target, str):
            return text._replace(yaml=with_value(text.yaml, path, target))
        return text._replace(yaml=with_value(text.yaml, (*path, "to"), target))

    # --- in the table

    def _with_text(self, text: MachineText, cell: str) -> MachineText:
        level, name, node = self._place(text)
        table = raw_table(text, level)
        check_cell(cell)
        target = target_of(node)
        if target is not None and not target.is_text:
            raise target.refuse(
                f"{name} has alternatives under `cells`; remove them with the same operation (`alternatives`)"
            )
        in_table = table is not None and self.event in table.columns()
        if not in_table:
            self._check_event(text, level)
        if not cell and node is not None:
            # fields of a blank cell would be about nothing
            yaml = without(text.yaml, (*level.path, "cells", name), len(level.path))
            text = text._replace(yaml=yaml)
            level, name, _ = self._place(text)
        elif target is not None or (not in_table and cell):
            return self._with_target(text, cell or None)
        if table is None or not in_table:
            return text
        if name.rpartition("/")[0] not in table.names():
            if not cell:
                return text
            table.add_row(name.rpartition("/")[0])
        table.set_cell(name.rpartition("/")[0], self.event, cell)
        return with_table(text, level, table)

    def _check_event(self, text: MachineText, level: TableLevel) -> None:
        """Checks that the machine has the event, if the level's own table has no column for it."""
        known = events_of(text)
        if self.event not in (ANY, END, *known):
            raise level.node.unknown("column", self.event, known)


def events_of(text: MachineText) -> dict[str, None]:
    """Returns the names of the events: columns of all tables, `events`, senses."""
    root = read(text)
    tables = (raw_table(text, level) for level in levels(root))
    names = dict.fromkeys(column for table in tables if table for column in table.columns())
    for key in ("events", "senses"):
        node = root.entries().get(key)
        names |= dict.fromkeys(node.entries() if node is not None and node.is_mapping else ())
    return {name: None for name in names if name not in (ANY, END)}


def check_cell(text: str) -> None:
    """Checks that a text can stand in a table. :raises MachineError: when it cannot."""
    if len(text) > LONGEST_CELL or not text.isprintable() or "|" in text:
        raise MachineError(f"{text[:40]!r} is no cell of a table")
    if text:
        read_cell(text, "", 0)


def has_fields(node: Node) -> bool:
    """Whether an entry under `cells` has fields, and not only next states."""
    return node.is_mapping and (any(key in CELL_KEYS for key in node.entries()) or not node.value)


def target_of(node: Node | None) -> Node | None:
    """What an entry under `cells` says of the next state; None if that is in the table."""
    if node is None:
        return None
    return node.entries().get("to") if has_fields(node) else node
