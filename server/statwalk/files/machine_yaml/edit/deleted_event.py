"""Deletes an event: its columns, and on request the cells, keys, senses and properties that name it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from statwalk.errors import RefusedEditError
from statwalk.files.machine_yaml.edit.cell_edits import events_of
from statwalk.files.machine_yaml.edit.operation import EditOperation, Part
from statwalk.files.machine_yaml.edit.raw_table import RawTable
from statwalk.files.machine_yaml.edit.renaming import same, sentence_renamed
from statwalk.files.machine_yaml.edit.table_levels import (
    TableLevel,
    entries_at,
    levels,
    raw_table,
    read,
    table_changes,
)
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.files.yaml.yaml_edit import without
from statwalk.files.yaml.yaml_node import Node
from statwalk.files.yaml.yaml_places import Path, find
from statwalk.machine.definition.machine_definition import BASE
from statwalk.machine.lint.findings import Finding


@dataclass(frozen=True)
class DeleteEvent(EditOperation):
    """Deletes an event, with its columns. `also_cells`: also the cells that answer it, its keys, its sense
    and the other lines about it; without, it is refused if there are any.
    """

    event: str
    also_cells: bool = False

    def __str__(self) -> str:
        return f"without the event {self.event}"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text without the event.

        :raises RefusedEditError: when cells answer the event; its findings say which.
        """
        root, known = read(text), events_of(text)
        if self.event not in known:
            raise root.unknown("event", self.event, known, 1)
        uses = list(_uses(root, self.event))
        if not self.also_cells and (findings := [*self._cells(text, root), *_findings(uses)]):
            listed = ", ".join(finding.message for finding in findings[:20])
            raise RefusedEditError(
                f"{self.event} is still used: {listed}; `also_cells` deletes these too",
                field="event",
                findings=findings,
            )
        for path, _ in reversed(uses):
            text = text._replace(yaml=without(text.yaml, path))
        text = text._replace(yaml=without(text.yaml, ("events", self.event)))
        return table_changes(text, self._leave).applied(text)

    def _leave(self, _: TableLevel, table: RawTable) -> None:
        if self.event in table.columns():
            table.remove_column(self.event)

    def _cells(self, text: MachineText, root: Node) -> Iterator[Finding]:
        for level in levels(root):
            table = raw_table(text, level)
            for row, event, _ in table.cells() if table else ():
                if event == self.event:
                    layer = "" if level.layer == BASE else level.layer
                    state, line = level.full(row), level.node.entries()["table"].line
                    yield Finding("used here", "error", f"{state}/{event}", line, state, event, layer)

    def touched(self) -> Iterable[Part]:
        """The name, the event and its sense."""
        yield "name", "event", self.event
        yield "event", self.event
        yield "sense", self.event

    def deleted(self) -> str:
        """The event."""
        return self.event


def _findings(uses: list[tuple[Path, Node]]) -> Iterator[Finding]:
    for path, node in uses:
        words = node.text() if isinstance(path[-1], int) else str(path[-1])
        yield Finding("used here", "error", f"{path[-2] if len(path) > 1 else path[0]}: {words}", node.line)


def _uses(root: Node, event: str) -> Iterator[tuple[Path, Node]]:
    """The lines outside of tables that are about an event: path and value; items of a list in their order."""
    for level in levels(root):
        cells = level.entry("cells")
        for name, node in cells.entries().items() if cells is not None and cells.is_mapping else ():
            if name.partition("/")[2] == event:
                yield (*level.path, "cells", name), node
    if (sense := find(root, ("senses", event))) is not None:
        yield ("senses", event), sense
    yield from _keys(root, event)
    for name, node in entries_at(root, "parameters").items():
        if (handle := find(node, ("handle", "event"))) is not None and handle.value == event:
            yield ("parameters", name, "handle", "event"), handle
    if (idle := root.entries().get("idle")) is not None and idle.value == event:
        yield ("idle",), idle
    yield from _properties(root, event)


def _keys(root: Node, event: str) -> Iterator[tuple[Path, Node]]:
    """The keys that send an event: the whole key, or what it sends when it comes up."""
    for key, node in entries_at(root, "keys").items():
        named = _sent(node)
        if event in (named.get("press"), named.get("hold")):
            yield ("keys", key), node
        elif named.get("release") == event:
            yield ("keys", key, "release"), node.entries()["release"]


def _properties(root: Node, event: str) -> Iterator[tuple[Path, Node]]:
    properties = root.entries().get("properties")
    for place, sentence in enumerate(properties.items() if properties is not None else ()):
        if sentence_renamed(sentence.text(), same, lambda name: "\n" if name == event else name).count("\n"):
            yield ("properties", place), sentence


def _sent(key: Node) -> dict[str, str]:
    """The events of a key by the moment in which it sends them."""
    if not key.is_mapping:
        return {}
    return {kind: node.text() for kind, node in key.entries().items() if node.is_text}
