"""Changes one cell of a table in a machine file's text; every other character stays: comments, order,
alignment.
"""

from __future__ import annotations

from typing import NamedTuple

from statwalk.errors import MachineError
from statwalk.files.yaml.yaml_text import Node, parse
from statwalk.machine.definition.machine_definition import ANY, BASE
from statwalk.machine.definition.state_table import bars, is_rule, read_cell

LONGEST_CELL = 200


class CellPlace(NamedTuple):
    """The place of a cell; `state` is the full name (FIGHT.GUARD), or `*`."""

    layer: str
    state: str
    event: str


def with_cell(text: str, place: CellPlace, new: str, file: str) -> str:
    """Returns the machine file's text with `new` in the cell (empty: blank); a row that is missing is added
    at the table's end.

    :raises MachineError: when the column does not exist, the table is in another file, or `cells` sets the
        cell's next state.
    """
    root = parse(text, file, MachineError)
    level, row = _level_of(root, place)
    table = level.entries().get("table")
    if table is None or "\n" not in table.text() or table.style != "|":
        raise level.refuse("this table is in another file, or is no block (`table: |`); edit it in the file")
    _refuse_target_elsewhere(level, f"{row}/{place.event}")
    new = new.strip()
    _check_cell(new, file, table.line)
    lines = text.splitlines(keepends=True)
    line_numbers = [
        line_number
        for line_number in range(table.first_line - 1, len(lines))
        if line_number < table.first_line - 1 + len(table.text().splitlines())
    ]
    line_numbers = [
        line_number
        for line_number in line_numbers
        if lines[line_number].strip() and not is_rule(lines[line_number].strip())
    ]
    header = bars(lines[line_numbers[0]].strip())
    if place.event not in header[1:]:
        raise table.unknown("column", place.event, header[1:], line_numbers[0] + 1)
    line_number = next((number for number in line_numbers[1:] if bars(lines[number].strip())[0] == row), None)
    if line_number is None:
        line_number = line_numbers[-1] + 1
        lines[line_number - 1] = lines[line_number - 1].rstrip("\r\n") + "\n"
        lines.insert(line_number, _blank_row(lines[line_numbers[0]], row))
    lines[line_number] = with_column(lines[line_number], header.index(place.event), new)
    return "".join(lines)


def _level_of(root: Node, place: CellPlace) -> tuple[Node, str]:
    """Returns the part of the file whose table has the row, and the row's name there.

    :raises MachineError: when the layer, the sub-machine or the state does not exist.
    """
    level = root
    if place.layer != BASE:
        layers = root.entries()["layers"].entries() if "layers" in root.entries() else {}
        if place.layer not in layers:
            raise root.unknown("layer", place.layer, (BASE, *layers))
        level = layers[place.layer]
    *composites, row = place.state.split(".")
    for composite in composites:
        states = level.entries()["states"].entries()
        if composite not in states or "machine" not in states[composite].entries():
            inner = [name for name, node in states.items() if node.is_mapping and "machine" in node.entries()]
            raise level.unknown("sub-machine", composite, inner)
        level = states[composite].entries()["machine"]
    if row != ANY and row not in level.entries()["states"].entries():
        raise level.unknown("state", row, level.entries()["states"].entries())
    return level, row


def _refuse_target_elsewhere(level: Node, name: str) -> None:
    """Refuses a cell whose next state is set under `cells`, because the table's cell has no effect."""
    cells = level.entries().get("cells")
    entry = cells.entries().get(name) if cells is not None and cells.is_mapping else None
    if entry is not None and (not entry.is_mapping or "to" in entry.entries()):
        raise entry.refuse(f"the next state of {name} is set under `cells`; change it there")


def _check_cell(content: str, file: str, line: int) -> None:
    if len(content) > LONGEST_CELL or not content.isprintable() or "|" in content:
        raise MachineError(f"{content[:40]!r} is no cell of a table", file=file, place=f"line {line}")
    if content:
        read_cell(content, file, line)


def _blank_row(header: str, state: str) -> str:
    """Returns a row of blank cells, as wide as the header."""
    body = header.rstrip("\r\n")
    first_cell, *other_cells = body.split("|") if not body.lstrip().startswith("|") else body.split("|")[1:]
    indent = body[: len(body) - len(body.lstrip())]
    opening_bar = "| " if body.lstrip().startswith("|") else ""
    width = len(first_cell) - (len(indent) if not opening_bar else 1)
    blanks = "|".join(" " * max(len(part), 1) for part in other_cells)
    return f"{indent}{opening_bar}{state.ljust(max(width, len(state) + 1))}|{blanks}\n"


def with_column(line: str, column: int, content: str) -> str:
    """Returns the line with `content` in a column; the column keeps its width if the content fits."""
    body = line.rstrip("\r\n")
    ending = line[len(body) :]
    parts = body.split("|")
    index = column + body.lstrip().startswith("|")
    is_last = index == len(parts) - 1
    parts[index] = (
        (f" {content}" if content else " ").rstrip() if is_last else f" {content} ".ljust(len(parts[index]))
    )
    return "|".join(parts) + ending
