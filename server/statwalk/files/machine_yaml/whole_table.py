"""Joins the tables of all levels: the cells of a layer and its sub-machines by full names, with the fields
that `cells` sets.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from statwalk.errors import MachineError
from statwalk.files.machine_yaml import cells
from statwalk.files.machine_yaml.levels import FlatStates, Scope
from statwalk.files.machine_yaml.tables import TableText
from statwalk.files.yaml.yaml_text import Node
from statwalk.machine.definition.cell_definition import CellDefinition

MOST_UNKNOWN = 100
"""most unknown next states in a table; the verifier reports each of them"""

Cells = dict[tuple[str, str], CellDefinition]


def cells_of(flat: FlatStates, events: Collection[str], variables: tuple[str, ...], file: str) -> Cells:
    """Returns the cells of all tables, with the fields that `cells` sets, inner levels first.

    :raises MachineError: when a row, an event or a cell is wrong.
    """
    joined: Cells = {}
    scopes = [(level, Scope(flat, level.composite)) for level in flat.levels]
    for level, scope in scopes:
        if level.table is not None:
            _add_table(joined, scope, level.table)
    for level, scope in scopes:
        if level.cells is not None:
            _refine(joined, scope, level.cells, cells.CellNames(scope, events, variables))
    _check_targets(joined, flat, file)
    return joined


def _add_table(joined: Cells, scope: Scope, source: TableText) -> None:
    """Adds the cells of one table; refuses a row that is no state, and a cell that another table has."""
    rows = {
        name: scope.row(Node(name, line, source.file, MachineError), name)
        for name, line in source.table.states.items()
    }
    for (name, column), cell in source.table.cells.items():
        place = rows[name], column
        if place in joined:
            message = f"the cell {'/'.join(place)} was already given in line {joined[place].line}"
            raise MachineError(message, file=source.file, place=f"line {cell.line}")
        joined[place] = _with_full_names(cell, scope)


def _refine(joined: Cells, scope: Scope, node: Node, names: cells.CellNames) -> None:
    """Sets the fields that one key `cells` contains."""
    if node.value == "":
        return
    for name, entry in node.entries().items():
        local, column = cells.row_and_column(node, name)
        row = scope.row(node, local, node.key_lines[name])
        cells.check_event(node, name, column, names)
        joined[row, column] = _with_full_names(
            cells.cell(entry, joined.get((row, column)), name, names), scope
        )


def _with_full_names(cell: CellDefinition, scope: Scope) -> CellDefinition:
    """Returns the cell with the full names of its next states."""
    alternatives = tuple(
        replace(alternative, to=scope.state(alternative.to)) for alternative in cell.alternatives
    )
    return replace(cell, to=scope.state(cell.to), alternatives=alternatives) if scope.composite else cell


def _check_targets(joined: Cells, flat: FlatStates, file: str) -> None:
    """Refuses cells with so many unknown next states that they can hardly be this machine's table."""
    unknown: dict[str, int] = {}
    for cell in joined.values():
        for to in (cell.to, *(alternative.to for alternative in cell.alternatives)):
            if to and not flat.has(to):
                unknown.setdefault(to, cell.line)
    if len(unknown) > MOST_UNKNOWN:
        name, line = next(iter(unknown.items()))
        message = f"{len(unknown):,} names in the cells are no states, for example {name[:40]}"
        raise MachineError(message, file=file, place=f"line {line}")
