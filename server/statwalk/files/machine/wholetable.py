"""One table of all levels: the cells of a layer and of its sub-machines under full names, and what `cells` says of them."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from statwalk.errors import MachineError
from statwalk.files.machine import cells
from statwalk.files.machine.levels import Flat, Scope
from statwalk.files.machine.tables import TableText
from statwalk.files.yamltext import Node
from statwalk.machine.authored.celldefinition import CellDefinition

MOST_UNKNOWN = 100
"""names in a table that are no states; the verifier says what is wrong with each of them"""

Cells = dict[tuple[str, str], CellDefinition]


def cells_of(flat: Flat, events: Collection[str], variables: tuple[str, ...], file: str) -> Cells:
    """The cells that the tables say, and then what `cells` says of them, from inside out; raises MachineError."""
    found: Cells = {}
    scopes = [(level, Scope(flat, level.outer)) for level in flat.levels]
    for level, scope in scopes:
        if level.table is not None:
            add_table(found, scope, level.table)
    for level, scope in scopes:
        if level.cells is not None:
            refine(found, scope, level.cells, cells.Known(scope, events, variables))
    check_targets(found, flat, file)
    return found


def add_table(found: Cells, scope: Scope, given: TableText) -> None:
    """The cells of one table; raises MachineError for a row that is no state, or a cell that another table says."""
    rows = {name: scope.row(Node(name, line, given.file, MachineError), name) for name, line in given.table.states.items()}
    for (name, column), cell in given.table.cells.items():
        place = rows[name], column
        if place in found:
            message = f"the cell {'/'.join(place)} was already given in line {found[place].line}"
            raise MachineError(message, file=given.file, place=f"line {cell.line}")
        found[place] = in_full(cell, scope)


def refine(found: Cells, scope: Scope, node: Node, known: cells.Known) -> None:
    """What stands under one key `cells`."""
    if node.value == "":
        return
    for name, one in node.entries().items():
        local, column = cells.place(node, name)
        row = scope.row(node, local, node.key_lines[name])
        cells.check_event(node, name, column, known)
        found[row, column] = in_full(cells.cell(one, found.get((row, column)), name, known), scope)


def in_full(cell: CellDefinition, scope: Scope) -> CellDefinition:
    """The cell with the full names of the states that it leads to."""
    alternatives = tuple(replace(one, to=scope.state(one.to)) for one in cell.alternatives)
    return replace(cell, to=scope.state(cell.to), alternatives=alternatives) if scope.outer else cell


def check_targets(found: Cells, flat: Flat, file: str) -> None:
    """Raises MachineError where so many cells name no state that this can hardly be their table."""
    unknown: dict[str, int] = {}
    for cell in found.values():
        for to in (cell.to, *(one.to for one in cell.alternatives)):
            if to and not flat.has(to):
                unknown.setdefault(to, cell.line)
    if len(unknown) > MOST_UNKNOWN:
        name, line = next(iter(unknown.items()))
        message = f"{len(unknown):,} names in the cells are no states; the first is {name[:40]}"
        raise MachineError(message, file=file, place=f"line {line}")
