"""One cell of a machine file's table changed in its text; every other character stays: comments, order, alignment."""

from __future__ import annotations

from typing import NamedTuple

from statwalk.errors import MachineError
from statwalk.files.yamltext import Node, parse
from statwalk.machine.authored.definition import ANY, BASE
from statwalk.machine.authored.table import bars, is_rule, read_cell

LONGEST_CELL = 200


class Place(NamedTuple):
    """A cell: `state` in full (FIGHT.GUARD), or `*`."""

    layer: str
    state: str
    event: str


def with_cell(text: str, place: Place, new: str, file: str) -> str:
    """The machine file's text with `new` in that cell (empty: blank); a row that the table has not yet is put at its end.

    Raises MachineError where there is no such column, where the table is in another file, or where `cells` says what the cell leads to.
    """
    root = parse(text, file, MachineError)
    level, row = level_of(root, place)
    table = level.entries().get("table")
    if table is None or "\n" not in table.text() or table.style != "|":
        raise level.refuse("this table stands in another file, or not as a block (`table: |`): change it there")
    refuse_outcome_elsewhere(level, f"{row}/{place.event}")
    new = new.strip()
    check_cell(new, file, table.line)
    lines = text.splitlines(keepends=True)
    numbers = [at for at in range(table.first_line - 1, len(lines)) if at < table.first_line - 1 + len(table.text().splitlines())]
    numbers = [at for at in numbers if lines[at].strip() and not is_rule(lines[at].strip())]
    header = bars(lines[numbers[0]].strip())
    if place.event not in header[1:]:
        raise table.unknown("column", place.event, header[1:], numbers[0] + 1)
    at = next((number for number in numbers[1:] if bars(lines[number].strip())[0] == row), None)
    if at is None:
        at = numbers[-1] + 1
        lines[at - 1] = lines[at - 1].rstrip("\r\n") + "\n"
        lines.insert(at, blank_row(lines[numbers[0]], row))
    lines[at] = put(lines[at], header.index(place.event), new)
    return "".join(lines)


def level_of(root: Node, place: Place) -> tuple[Node, str]:
    """The part of the file whose table has the row, and the row's name there; raises MachineError where there is none."""
    level = root
    if place.layer != BASE:
        layers = root.entries()["layers"].entries() if "layers" in root.entries() else {}
        if place.layer not in layers:
            raise root.unknown("layer", place.layer, (BASE, *layers))
        level = layers[place.layer]
    *outers, row = place.state.split(".")
    for outer in outers:
        states = level.entries()["states"].entries()
        if outer not in states or "machine" not in states[outer].entries():
            inner = [name for name, one in states.items() if one.is_mapping and "machine" in one.entries()]
            raise level.unknown("sub-machine", outer, inner)
        level = states[outer].entries()["machine"]
    if row != ANY and row not in level.entries()["states"].entries():
        raise level.unknown("state", row, level.entries()["states"].entries())
    return level, row


def refuse_outcome_elsewhere(level: Node, name: str) -> None:
    """Raises MachineError where `cells` says what the cell leads to: the table would not count."""
    cells = level.entries().get("cells")
    one = cells.entries().get(name) if cells is not None and cells.is_mapping else None
    if one is not None and (not one.is_mapping or "to" in one.entries()):
        raise one.refuse(f"what {name} leads to stands under `cells`: change it there")


def check_cell(new: str, file: str, line: int) -> None:
    """Raises MachineError for what is no cell of a table."""
    if len(new) > LONGEST_CELL or not new.isprintable() or "|" in new:
        raise MachineError(f"{new[:40]!r} is no cell of a table", file=file, place=f"line {line}")
    if new:
        read_cell(new, file, line)


def blank_row(header: str, state: str) -> str:
    """A row without cells, as wide as the header."""
    body = header.rstrip("\r\n")
    first, *others = body.split("|") if not body.lstrip().startswith("|") else body.split("|")[1:]
    indent = body[: len(body) - len(body.lstrip())]
    begin = "| " if body.lstrip().startswith("|") else ""
    width = len(first) - (len(indent) if not begin else 1)
    return f"{indent}{begin}{state.ljust(max(width, len(state) + 1))}|{'|'.join(' ' * max(len(part), 1) for part in others)}\n"


def put(line: str, column: int, new: str) -> str:
    """The line with `new` in a column, as wide as what was there where it fits."""
    body = line.rstrip("\r\n")
    ending = line[len(body) :]
    parts = body.split("|")
    at = column + body.lstrip().startswith("|")
    is_last = at == len(parts) - 1
    parts[at] = (f" {new}" if new else " ").rstrip() if is_last else f" {new} ".ljust(len(parts[at]))
    return "|".join(parts) + ending
