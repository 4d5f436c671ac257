"""Reads the state table from text: states down, events across, `|` between cells (or CSV); each cell names
the next state (FAQ Q19).
"""

from __future__ import annotations

import csv
import re
from collections.abc import Iterable
from dataclasses import dataclass

from statwalk.errors import MachineError
from statwalk.machine.definition.cell_definition import AT_END, CellDefinition, CellTiming
from statwalk.machine.definition.machine_definition import ANY
from statwalk.machine.definition.name_rule import NAME, refused_name

CELL = re.compile(r"(?P<state>\w[\w.-]{0,99})(?P<restart>!?)(?:\s+at\s+(?P<timing>\w[\w.-]{0,99}))?")
MOST_CELLS = 100_000
MOST_ROWS, MOST_COLUMNS = 10_000, 4_000


@dataclass(frozen=True)
class Table:
    """The table as written: `rows` with the header first, and the cell of each (state, event)."""

    events: dict[str, int]
    """column names in their order, without `*`, with the line of the header"""
    states: dict[str, int]
    """row names and their lines"""
    cells: dict[tuple[str, str], CellDefinition]
    rows: tuple[tuple[str, ...], ...]


def read_cell(text: str, file: str, line: int) -> CellDefinition:
    """Reads a cell: `STATE`, `STATE!` or `-`, a state optionally with `at end` or `at MARKER`.

    :raises MachineError: when the text is anything else.
    """
    place = f"line {line}"
    if text == "-":
        return CellDefinition("", line, off=True)
    match = CELL.fullmatch(text)
    if match is None:
        raise MachineError(
            f"{text[:40]!r} is no cell; a cell is STATE, STATE! or -, then perhaps `at end` or `at MARKER`",
            file=file,
            place=place,
        )
    timing = (
        AT_END
        if match["timing"] == "end"
        else CellTiming("marker", marker=match["timing"])
        if match["timing"]
        else None
    )
    return CellDefinition(match["state"], line, restart=bool(match["restart"]), when=timing)


def read_table(text: str, file: str, first_line: int = 1) -> Table:
    """Reads a table with `|` between cells; `first_line` is the line of the text in its file.

    :raises MachineError: when the table is empty, too large or malformed; with the line.
    """
    _check_length(text, file, first_line)
    lines = [(number, line.strip()) for number, line in enumerate(text.splitlines(), first_line)]
    return _assemble([(number, bars(line)) for number, line in lines if line and not is_rule(line)], file)


def read_csv(text: str, file: str) -> Table:
    """Reads a table of comma-separated values.

    :raises MachineError: when the text is no CSV, or the table is empty, too large or malformed; with the
        line.
    """
    _check_length(text, file, 1)
    reader = csv.reader(text.splitlines())
    try:
        rows = [
            (reader.line_num, [cell.strip() for cell in row])
            for row in reader
            if any(cell.strip() for cell in row)
        ]
    except csv.Error as error:
        raise MachineError(f"this is not CSV: {error}", file=file, place=f"line {reader.line_num}") from None
    return _assemble(rows, file)


def bars(line: str) -> list[str]:
    """Returns the cells of a line; bars around the whole line are ignored."""
    inner = line[1:].removesuffix("|") if line.startswith("|") else line
    return [cell.strip() for cell in inner.split("|")]


def is_rule(line: str) -> bool:
    """Returns whether this is the line of dashes below a header."""
    return len(line) > 2 and "-" in line and not line.strip("|-+: ")  # a lone dash is a cell


def _check_length(text: str, file: str, first_line: int) -> None:
    """Limits the number of lines and separators before any cell is made."""
    if text.count("\n") > MOST_ROWS:
        raise MachineError(
            f"the table has more than {MOST_ROWS:,} rows", file=file, place=f"line {first_line + MOST_ROWS}"
        )
    if max(text.count("|"), text.count(",")) > MOST_CELLS + MOST_ROWS:
        raise MachineError(
            f"the table has more than {MOST_CELLS:,} cells", file=file, place=f"line {first_line}"
        )


def _assemble(lines: list[tuple[int, list[str]]], file: str) -> Table:
    header_line, header = lines[0] if lines else (0, [""])
    if not lines:
        raise MachineError("the table is empty; its first line is `state | EVENT | EVENT | …`", file=file)
    if len(header) - 1 > MOST_COLUMNS or len(header) * len(lines) > MOST_CELLS:
        most = f"{MOST_COLUMNS:,} columns" if len(header) > MOST_COLUMNS else f"{MOST_CELLS:,} cells"
        raise MachineError(f"the table has more than {most}", file=file, place=f"line {header_line}")
    events = _distinct(header[1:], "event", file, header_line)
    states = check_rows(lines, file)
    cells = {
        (row[0], event): read_cell(text, file, line)
        for line, row in lines[1:]
        for event, text in zip(header[1:], row[1:], strict=True)
        if text
    }
    return Table(
        {event: header_line for event in events if event != ANY},
        states,
        cells,
        tuple(tuple(row) for _, row in lines),
    )


def check_rows(lines: list[tuple[int, list[str]]], file: str) -> dict[str, int]:
    """Returns the states of the rows with their lines, checking every row before any cell is made.

    :raises MachineError: when a row has the wrong number of cells, repeats a state, or has a malformed cell.
    """
    count = len(lines[0][1])
    states: dict[str, int] = {}
    seen = {"", "-"}
    for line, row in lines[1:]:
        state = row[0]
        if len(row) != count:
            raise MachineError(
                f"the row {state[:40]} has {len(row)} cells, the header {count}",
                file=file,
                place=f"line {line}",
            )
        if state in states:
            raise MachineError(
                f"the row {state[:40]} was already given in line {states[state]}",
                file=file,
                place=f"line {line}",
            )
        states |= _distinct([state], "state", file, line)
        for text in seen.symmetric_difference(row[1:]) - seen:
            read_cell(text, file, line)
        seen.update(row[1:])
    return states


def _distinct(names: Iterable[str], kind: str, file: str, line: int) -> dict[str, int]:
    lines: dict[str, int] = {}
    for name in names:
        if name != ANY and not NAME.fullmatch(name):
            raise MachineError(refused_name(name, kind), file=file, place=f"line {line}")
        if name in lines:
            raise MachineError(f"the {kind} {name[:40]} is defined twice", file=file, place=f"line {line}")
        lines[name] = line
    return lines
