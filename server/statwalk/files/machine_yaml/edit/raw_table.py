"""A state table as it is written: its lines, with the letters and the spaces of each cell."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

from statwalk.files.machine_yaml.edit.table_lines import TableLine, bar_line, csv_line


@dataclass
class RawTable:
    """The lines of a table; `bar` stands between cells."""

    lines: list[TableLine]
    bar: str

    def text(self) -> str:
        """Returns the lines as text."""
        return "".join(line.head + self.bar.join(line.cells) + line.end for line in self.lines)

    # --- names

    def content(self, line: TableLine, column: int) -> str:
        """Returns what a cell says."""
        cell = line.cells[column].strip()
        return cell[1:-1].replace('""', '"').strip() if self.bar == "," and cell[:1] == '"' else cell

    def names(self) -> list[str]:
        """Returns the names of the rows."""
        return [self.content(line, 0) for line in self._rows()[1:]]

    def columns(self) -> list[str]:
        """Returns the names of the columns, without the first, which has the states."""
        header = self._rows()[0]
        return [self.content(header, column) for column in range(1, len(header.cells))]

    def cell(self, row: str, column: str) -> str:
        """Returns what the cell of a row and a column says; "" if it is blank or not there."""
        if row not in self.names() or column not in self.columns():
            return ""
        return self.content(self._line(row), self.columns().index(column) + 1)

    def cells(self) -> Iterator[tuple[str, str, str]]:
        """Yields row, column and text of each cell that is not blank."""
        columns = self.columns()
        for line in self._rows()[1:]:
            for place, column in enumerate(columns, 1):
                if text := self.content(line, place):
                    yield self.content(line, 0), column, text

    def _rows(self) -> list[TableLine]:
        return [line for line in self.lines if line.cells and not line.is_rule]

    def _line(self, row: str) -> TableLine:
        return next(line for line in self._rows()[1:] if self.content(line, 0) == row)

    # --- cells

    def set_cell(self, row: str, column: str, text: str) -> None:
        """Changes a cell; the column keeps its width if the text fits."""
        self._put(self._line(row), self.columns().index(column) + 1, text)

    def fit(self, column: str) -> None:
        """Gives all cells of a column the width of the widest."""
        self._widen(self.columns().index(column) + 1)

    def change(self, new: Callable[[str], str]) -> None:
        """Changes every cell below the header and beside the names to what `new` makes of it."""
        wider = set()
        for line in self._rows()[1:]:
            for column in range(1, len(line.cells)):
                text = self.content(line, column)
                if (changed := new(text)) != text:
                    before = len(line.cells[column])
                    line = self._put(line, column, changed)
                    if len(line.cells[column]) > before and self._widths(column, line) <= {before}:
                        wider.add(column)
        for column in wider:
            self._widen(column)

    def _put(self, line: TableLine, column: int, text: str) -> TableLine:
        """Replaces a line by one with another cell."""
        cells = list(line.cells)
        cells[column] = self._padded(line, column, text, len(cells[column]))
        changed = replace(line, cells=tuple(cells))
        self.lines[self.lines.index(line)] = changed
        return changed

    def _padded(self, line: TableLine, column: int, text: str, width: int) -> str:
        if self.bar != "|":
            return text
        if line.is_rule:
            return (line.cells[column] if column < len(line.cells) else "")[:1].ljust(width, "-")
        before = "" if column == 0 and not line.head.endswith("|") else " "
        if column and column >= len(line.cells) - 1 and not line.end.startswith("|"):
            return f"{before}{text}".rstrip()
        return f"{before}{text} ".ljust(width)

    # --- rows

    def add_row(self, name: str, before: str | None = None) -> None:
        """Adds a row of blank cells."""
        header, last = self._rows()[0], self._rows()[-1]
        newline = header.end if header.end.endswith("\n") else header.end + "\n"
        if before in self.names():
            place = self.lines.index(self._line(before))
        else:
            place = self.lines.index(last) + 1
            self.lines[place - 1] = last if last.end.endswith("\n") else replace(last, end=newline)
        cells = tuple(self._padded(header, column, "", len(cell)) for column, cell in enumerate(header.cells))
        self.lines.insert(place, replace(header, cells=cells, end=newline))
        self._rename(0, name, place)

    def remove_row(self, name: str) -> None:
        """Removes a row."""
        self.lines.remove(self._line(name))

    def rename_row(self, name: str, new: str) -> None:
        """Renames a row."""
        self._rename(0, new, self.lines.index(self._line(name)))

    def move_row(self, name: str, before: str | None) -> None:
        """Moves a row before another, or to the end."""
        line = self._line(name)
        last = self.lines.index(self._rows()[-1])
        if before is None and self.lines.index(line) == last:
            return
        ends = [row.end for row in self.lines]
        place = self.lines.index(self._line(before)) if before is not None else last + 1
        self.lines.insert(place, line)
        del self.lines[next(at for at, row in enumerate(self.lines) if row is line and at != place)]
        self.lines = [replace(row, end=end) for row, end in zip(self.lines, ends, strict=True)]

    # --- columns

    def add_column(self, name: str, before: str | None = None) -> None:
        """Adds a column of blank cells."""
        columns = self.columns()
        place = columns.index(before) + 1 if before in columns else len(columns) + 1
        header = self._rows()[0]
        last = max(len(line.cells[-1].rstrip()) for line in self._rows()) + 1
        for at, line in enumerate(self.lines):
            if line.cells:
                text = name if line is header else ""
                self.lines[at] = self._with_cell(line, place, text, len(name) + 2, last)

    def _with_cell(self, line: TableLine, place: int, text: str, width: int, last: int) -> TableLine:
        cells = list(line.cells)
        if place == len(cells) and self.bar == "|" and not line.end.startswith("|"):
            cells[-1] = cells[-1].ljust(last)
        cells.insert(place, "")
        wider = replace(line, cells=tuple(cells))
        cells[place] = self._padded(wider, place, text, width)
        return replace(line, cells=tuple(cells))

    def remove_column(self, name: str) -> None:
        """Removes a column."""
        place = self.columns().index(name) + 1
        for at, line in enumerate(self.lines):
            if line.cells:
                cells = (*line.cells[:place], *line.cells[place + 1 :])
                if place == len(cells) and self.bar == "|" and not line.end.startswith("|"):
                    cells = (*cells[:-1], cells[-1].rstrip())
                self.lines[at] = replace(line, cells=cells)

    def rename_column(self, name: str, new: str) -> None:
        """Renames a column."""
        self._rename(self.columns().index(name) + 1, new, self.lines.index(self._rows()[0]))

    def move_column(self, name: str, before: str | None) -> None:
        """Moves a column before another, or to the end."""
        columns = self.columns()
        texts = [
            self.content(line, columns.index(name) + 1) if not line.is_rule else ""
            for line in self.lines
            if line.cells
        ]
        self.remove_column(name)
        self.add_column(name, before)
        for line, text in zip([line for line in self.lines if line.cells], texts, strict=True):
            if text and not line.is_rule:
                self._put(line, self.columns().index(name) + 1, text)
        self._widen(self.columns().index(name) + 1)

    def _rename(self, column: int, text: str, at: int) -> None:
        """Changes a name in the line `at`; where a column has one width, all of it becomes as wide."""
        is_even = len(self._widths(column, self.lines[at])) < 2
        self._put(self.lines[at], column, text)
        if is_even:
            self._widen(column)

    def _widths(self, column: int, without: TableLine) -> set[int]:
        """The widths of a column in all lines but one."""
        return {len(line.cells[column]) for line in self.lines if line.cells and line is not without}

    def _widen(self, column: int) -> None:
        """Gives all cells of a column the width of the widest; not the last column, which has no end."""
        lines = [line for line in self.lines if line.cells]
        if self.bar != "|" or (column == len(lines[0].cells) - 1 and not lines[0].end.startswith("|")):
            return
        width = max(len(line.cells[column]) for line in lines)
        for line in lines:
            text = "" if line.is_rule else self.content(line, column)
            cells = list(line.cells)
            cells[column] = self._padded(line, column, text, width)
            self.lines[self.lines.index(line)] = replace(line, cells=tuple(cells))


def table_with_bars(text: str) -> RawTable:
    """Returns the table of lines with `|` between cells."""
    return RawTable([bar_line(line) for line in text.splitlines(keepends=True)], "|")


def table_of_csv(text: str) -> RawTable:
    """Returns the table of comma-separated values."""
    return RawTable([csv_line(line) for line in text.splitlines(keepends=True)], ",")
