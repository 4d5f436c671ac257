"""Moves the lines of a state from one table to another: the state, its row, and what `cells` says of it."""

from __future__ import annotations

from dataclasses import dataclass

from statwalk.files.machine_yaml.edit.cell_edits import SetCell, target_of
from statwalk.files.machine_yaml.edit.raw_table import RawTable
from statwalk.files.machine_yaml.edit.renaming import StateNames, targets_renamed
from statwalk.files.machine_yaml.edit.table_levels import (
    TableLevel,
    levels_of,
    raw_table,
    read,
    with_table,
)
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.files.yaml.moved_entry import entry_moved
from statwalk.files.yaml.yaml_edit import with_key
from statwalk.files.yaml.yaml_places import spliced
from statwalk.machine.definition.machine_definition import END
from statwalk.machine.definition.state_table import CELL

Row = dict[str, str]
"""the cells of a row that are not blank, by column"""


@dataclass(frozen=True)
class StateMove:
    """A state that goes into another table of its layer. It has its new name already: `names` are the names
    after the move, and `row` is what the state is called in the table that it leaves.
    """

    layer: str
    name: str
    row: str
    source: str
    """the composite state whose table it leaves; empty: the layer's"""
    scope: str
    """the same composite state as it is called after the move"""
    target: str
    names: StateNames

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the state in the other table."""
        source, target = level_at(text, self.layer, self.source), level_at(text, self.layer, self.target)
        text = self._with_targets(text, source)
        text, row = self._without_row(text)
        state, states = (*source.path, "states", self.name), (*target.path, "states")
        text = text._replace(yaml=entry_moved(text.yaml, state, states))
        for key in self._cells(source):
            cells, (_, _, event) = (*target.path, "cells"), key.partition("/")
            yaml = entry_moved(text.yaml, (*source.path, "cells", key), cells)
            text = text._replace(yaml=with_key(yaml, (*cells, key), f"{self.name}/{event}"))
        return text if row is None else self._with_row(text, row)

    def _cells(self, level: TableLevel) -> list[str]:
        return [key for key in level.cells() if key.partition("/")[0] == self.row]

    def _rescoped(self, cell: str) -> str:
        """What to write in the other table in place of a cell."""
        match = CELL.fullmatch(cell)
        if match is None:
            return cell
        full = self.names.meant(self.scope, match["state"])
        return self.names.shortest(self.target, full) + cell[match.end("state") :]

    def _with_targets(self, text: MachineText, source: TableLevel) -> MachineText:
        entries = [source.cells()[key] for key in self._cells(source)]
        return text._replace(yaml=spliced(text.yaml, targets_renamed(text.yaml, entries, self._rescoped)))

    def _without_row(self, text: MachineText) -> tuple[MachineText, Row | None]:
        level = level_at(text, self.layer, self.source)
        table = raw_table(text, level)
        if table is None or self.row not in table.names():
            return text, None
        row = {column: self._rescoped(cell) for name, column, cell in table.cells() if name == self.row}
        table.remove_row(self.row)
        return with_table(text, level, table), row

    def _with_row(self, text: MachineText, row: Row) -> MachineText:
        level = level_at(text, self.layer, self.target)
        table = raw_table(text, level)
        if table is not None:
            _write_row(table, self.name, row)
            return with_table(text, level, table)
        for column, cell in row.items():
            if target_of(level.cells().get(f"{self.name}/{column}")) is None:
                text = SetCell(level.full(self.name), column, cell, layer=self.layer).apply(text)
        return text


def _write_row(table: RawTable, name: str, row: Row) -> None:
    if name not in table.names():
        table.add_row(name)
    for column, cell in row.items():
        columns = table.columns()
        if column not in columns:
            table.add_column(column, END if END in columns else None)
        table.set_cell(name, column, cell)
        table.fit(column)


def level_at(text: MachineText, layer: str, composite: str) -> TableLevel:
    """Returns the level of a layer, or of a composite state in it, which must be there."""
    return next(level for level in levels_of(read(text), layer) if level.composite == composite)
