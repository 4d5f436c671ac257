"""The lines of a state table as they are written."""

from __future__ import annotations

import re
from dataclasses import dataclass

from statwalk.machine.definition.state_table import bars, is_rule

CSV_CELL = re.compile(r'"(?:[^"]|"")*"|[^,]*')


@dataclass(frozen=True)
class TableLine:
    """A line; `cells` is empty for a line that is no row, `head` and `end` stand around the cells."""

    head: str
    cells: tuple[str, ...]
    end: str
    is_rule: bool = False


def bar_line(line: str) -> TableLine:
    """Returns a line of a table with `|` between cells."""
    body = line.strip()
    if not body:
        return TableLine(line, (), "")
    start = line.index(body)
    head = line[:start] + "|" * body.startswith("|")
    inner = line[len(head) :]
    ending = inner[len(inner.rstrip("\r\n")) :]
    inner = inner.rstrip("\r\n")
    if body.startswith("|") and inner.rstrip().endswith("|"):
        closing = inner.rindex("|")
        inner, ending = inner[:closing], inner[closing:] + ending
    cells = tuple(inner.split("|"))
    assert [cell.strip() for cell in cells] == bars(body)
    return TableLine(head, cells, ending, is_rule(body))


def csv_line(line: str) -> TableLine:
    """Returns a line of a table of comma-separated values."""
    body = line.rstrip("\r\n")
    if not body.strip(", "):
        return TableLine(line, (), "")
    cells = []
    place = 0
    while place <= len(body):
        match = CSV_CELL.match(body, place)
        assert match is not None
        cells.append(match[0])
        place = match.end() + 1
    return TableLine("", tuple(cells), line[len(body) :])
