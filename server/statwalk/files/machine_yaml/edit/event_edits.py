"""Changes events: the columns of the tables, and what else speaks of them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from statwalk.errors import MachineError
from statwalk.files.machine_yaml.edit.cell_edits import events_of
from statwalk.files.machine_yaml.edit.event_names import event_renamed, markers_of
from statwalk.files.machine_yaml.edit.operation import EditOperation, Part
from statwalk.files.machine_yaml.edit.raw_table import RawTable
from statwalk.files.machine_yaml.edit.renaming import check_name
from statwalk.files.machine_yaml.edit.table_levels import (
    TableLevel,
    level_of,
    raw_table,
    read,
    with_table,
)
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.files.yaml.yaml_edit import with_value, without
from statwalk.machine.definition.machine_definition import BASE, END


@dataclass(frozen=True)
class AddEvent(EditOperation):
    """Adds an event: a column of blank cells in the table of a layer, before the column `before` or last.
    `composite`: the state whose own table gets the column; `buffer` in seconds.
    """

    event: str
    before: str | None = None
    buffer: float | None = None
    layer: str = BASE
    composite: str = ""

    def __str__(self) -> str:
        return f"new event {self.event}"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the event."""
        check_name(self.event, "event")
        level, table = self._table(text)
        if table is None:
            raise level.node.refuse(f"{self.composite or self.layer} has no table; give it one in the text")
        if self.event in table.columns():
            raise MachineError(f"there is an event {self.event} already")
        if self.before is not None and self.before not in table.columns():
            raise level.node.unknown("column", self.before, table.columns())
        table.add_column(self.event, self.before)
        text = with_table(text, level, table)
        return text if self.buffer is None else SetEvent(self.event, self.buffer).apply(text)

    def _table(self, text: MachineText) -> tuple[TableLevel, RawTable | None]:
        level, _ = level_of(read(text), self.layer, f"{self.composite}.*" if self.composite else "*")
        return level, raw_table(text, level)

    def touched(self) -> Iterable[Part]:
        """The name."""
        yield "column", self.layer, self.composite, self.event


@dataclass(frozen=True)
class SetEvent(EditOperation):
    """Changes the buffer of an event, in seconds; None: as the defaults say."""

    event: str
    buffer: float | None

    def __str__(self) -> str:
        return f"{self.event}: buffer"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the buffer."""
        check_event(text, self.event)
        path = "events", self.event
        if self.buffer is not None:
            return text._replace(yaml=with_value(text.yaml, (*path, "buffer"), self.buffer))
        bare = text._replace(yaml=without(text.yaml, (*path, "buffer")))
        is_known = self.event in events_of(bare)  # by a column, or by a sense
        return bare if is_known else text._replace(yaml=without(text.yaml, (*path, "buffer"), 2))

    def touched(self) -> Iterable[Part]:
        """The name, and the buffer."""
        yield "name", "event", self.event
        yield "event", self.event, "buffer"


@dataclass(frozen=True)
class RenameEvent(EditOperation):
    """Renames an event everywhere in the file, also in keys and properties; a marker of the same name too."""

    event: str
    to: str

    def __str__(self) -> str:
        return f"{self.event} is now {self.to}"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the other name."""
        check_name(self.to, "event")
        known = {**events_of(text), **markers_of(read(text))}
        if self.event not in known:
            raise read(text).unknown("event", self.event, known, 1)
        if self.to == self.event:
            return text
        if self.to in known or self.to == END:
            raise MachineError(f"there is an event {self.to} already")
        return event_renamed(text, self.event, self.to)

    def touched(self) -> Iterable[Part]:
        """Both names."""
        yield "name", "event", self.event
        yield "name", "event", self.to


@dataclass(frozen=True)
class MoveEvent(EditOperation):
    """Moves a column of a layer's table before another, or to the end."""

    event: str
    before: str | None = None
    layer: str = BASE
    composite: str = ""

    def __str__(self) -> str:
        return f"{self.event} moved"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the columns in the other order."""
        level, _ = level_of(read(text), self.layer, f"{self.composite}.*" if self.composite else "*")
        table = raw_table(text, level)
        columns = table.columns() if table else []
        for name in (self.event, *([] if self.before is None else [self.before])):
            if name not in columns:
                raise level.node.unknown("column", name, columns)
        if table is not None and self.event != self.before:
            table.move_column(self.event, self.before)
            text = with_table(text, level, table)
        return text

    def touched(self) -> Iterable[Part]:
        """The column."""
        yield "column", self.layer, self.composite, self.event


def check_event(text: MachineText, event: str) -> None:
    """Checks that there is an event. :raises MachineError: when there is none."""
    known = events_of(text)
    if event not in known:
        raise read(text).unknown("event", event, known, 1)
