"""Deletes a state, with its row, and on demand with all that speaks of it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from statwalk.errors import MachineError, RefusedEditError
from statwalk.files.machine_yaml.edit.cell_edits import has_fields, target_of
from statwalk.files.machine_yaml.edit.operation import EditOperation, Part
from statwalk.files.machine_yaml.edit.raw_table import RawTable
from statwalk.files.machine_yaml.edit.renaming import StateNames, same, sentence_renamed
from statwalk.files.machine_yaml.edit.state_renaming import state_names
from statwalk.files.machine_yaml.edit.table_levels import (
    TableLevel,
    entries_at,
    existing_state,
    levels_of,
    raw_table,
    read,
    table_changes,
)
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.files.yaml.yaml_edit import with_value, without
from statwalk.files.yaml.yaml_node import Node
from statwalk.files.yaml.yaml_places import Path, find
from statwalk.files.yaml.yaml_value import Value
from statwalk.machine.definition.machine_definition import BASE
from statwalk.machine.definition.state_table import CELL
from statwalk.machine.lint.findings import Finding


@dataclass(frozen=True)
class DeleteState(EditOperation):
    """Deletes a state, with its row. `also_cells`: makes the cells blank that lead to it, and deletes the
    properties and other lines about it; without, it is refused if there are any.
    """

    state: str
    also_cells: bool = False
    layer: str = BASE

    def __str__(self) -> str:
        return f"without the state {self.state}"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text without the state.

        :raises RefusedEditError: when cells lead to the state; its findings say which.
        """
        root = read(text)
        level, name = existing_state(root, self.layer, self.state)
        _check_initial(level, name)
        gone = _Gone(self.layer, self.state, state_names(root, self.layer))
        if not self.also_cells and (findings := list(_uses(text, root, gone))):
            raise RefusedEditError(_refusal(self.state, findings), field="state", findings=findings)
        for path, value in _changes_elsewhere(text, root, gone):
            text = text._replace(
                yaml=without(text.yaml, path) if value is None else with_value(text.yaml, path, value)
            )
        text = text._replace(yaml=without(text.yaml, (*level.path, "states", name)))
        return table_changes(text, gone.leave_table, self.layer).applied(text)

    def touched(self) -> Iterable[Part]:
        """The name, the state and its row."""
        yield "name", "state", self.layer, self.state
        yield "state", self.layer, self.state
        yield "cell", self.layer, self.state

    def deleted(self) -> str:
        """The state."""
        return self.state


@dataclass(frozen=True)
class _Gone:
    """A state that goes, with all that is in it."""

    layer: str
    state: str
    names: StateNames

    def has(self, full: str) -> bool:
        return full == self.state or full.startswith(f"{self.state}.")

    def is_goal(self, composite: str, cell: str) -> bool:
        """Whether a cell leads there."""
        match = CELL.fullmatch(cell)
        return match is not None and self.has(self.names.meant(composite, match["state"]))

    def leave_table(self, level: TableLevel, table: RawTable) -> None:
        for row in table.names():
            if self.has(level.full(row)):
                table.remove_row(row)
        table.change(lambda cell: "" if self.is_goal(level.composite, cell) else cell)

    def goals(self, level: TableLevel) -> Iterator[tuple[str, Node]]:
        """The entries under `cells` of a level that lead there, from elsewhere."""
        cells = level.entry("cells")
        for name, node in cells.entries().items() if cells is not None and cells.is_mapping else ():
            goals = _goals(target_of(node))
            if any(self.is_goal(level.composite, goal) for goal in goals):
                yield name, node


def _goals(target: Node | None) -> list[str]:
    """The cells that stand in the next states of an entry."""
    if target is None:
        return []
    if target.is_text:
        return [target.text()]
    if target.is_mapping:
        return list(target.entries())
    return [
        item.entries()["to"].text() for item in target.items() if item.is_mapping and "to" in item.entries()
    ]


def _check_initial(level: TableLevel, name: str) -> None:
    """:raises MachineError: when the machine begins with the state, or has no other."""
    initial = level.entry("initial")
    if initial is not None and initial.value == name:
        raise initial.refuse(f"{level.full(name)} is the initial state; choose another one first")
    if len(level.states()) == 1:
        raise MachineError(f"{level.full(name)} is the only state here; a machine needs one")


# --- what speaks of it


def _uses(text: MachineText, root: Node, gone: _Gone) -> Iterator[Finding]:
    """The cells that lead to the state from elsewhere, and the other lines about it."""
    for level in levels_of(root, gone.layer):
        if gone.has(level.composite):
            continue
        table = raw_table(text, level)
        found = {
            (row, event): level.node.entries()["table"].line
            for row, event, cell in (table.cells() if table else ())
            if gone.is_goal(level.composite, cell)
        }
        for name, node in gone.goals(level):
            row, _, event = name.partition("/")
            found[row, event] = node.line
        for (row, event), line in found.items():
            if not gone.has(level.full(row)):
                message = f"{level.full(row)}/{event} leads to {gone.state}"
                yield Finding("leads here", "error", message, line, level.full(row), event, _layer(gone))
    for path, node in _other_uses(root, gone):
        yield Finding("used here", "error", f"{path[0]}: {_words(path, node)}", node.line)


def _layer(gone: _Gone) -> str:
    return "" if gone.layer == BASE else gone.layer


def _words(path: Path, node: Node) -> str:
    return node.text() if node.is_text and isinstance(path[-1], int) else ".".join(map(str, path[1:]))


def _refusal(state: str, findings: list[Finding]) -> str:
    listed = ", ".join(finding.message.removesuffix(f" leads to {state}") for finding in findings[:20])
    more = f" and {len(findings) - 20} more" if len(findings) > 20 else ""
    return f"{state} is still used: {listed}{more}; `also_cells` makes these cells blank"


def _other_uses(root: Node, gone: _Gone) -> Iterator[tuple[Path, Node]]:
    """The lines outside of cells that name the state: path and value."""
    if gone.layer == BASE:
        fallback, properties = root.entries().get("fallback"), root.entries().get("properties")
        if fallback is not None and gone.has(fallback.text()):
            yield ("fallback",), fallback
        for place, sentence in enumerate(properties.items() if properties is not None else ()):
            named: list[str] = []
            sentence_renamed(sentence.text(), lambda name, named=named: named.append(name) or name, same)  # type: ignore[misc]
            if any(map(gone.has, named)):
                yield ("properties", place), sentence
        for solver, node in entries_at(root, "solvers").items():
            yield from _keys(find(node, ("weight",)), ("solvers", solver, "weight"), gone)
    for key, node in entries_at(root, "keys").items():
        yield from _keys(find(node, ("change",)), ("keys", key, "change"), gone)


def _keys(node: Node | None, path: Path, gone: _Gone) -> Iterator[tuple[Path, Node]]:
    for name, value in node.entries().items() if node is not None and node.is_mapping else ():
        if gone.has(name):
            yield (*path, name), value


def _changes_elsewhere(text: MachineText, root: Node, gone: _Gone) -> Iterator[tuple[Path, Value | None]]:
    """What to write, or (None) to remove, so that only tables speak of the state; last lines first."""
    for path, _ in reversed(list(_other_uses(root, gone))):
        yield path, None
    yield from (
        (path, None) for path, _ in _keys(find(root, ("view", gone.layer)), ("view", gone.layer), gone)
    )
    for level in levels_of(root, gone.layer):
        if not gone.has(level.composite):
            yield from _changes_of_cells(text, level, gone)


def _changes_of_cells(
    text: MachineText, level: TableLevel, gone: _Gone
) -> Iterator[tuple[Path, Value | None]]:
    """What changes under `cells` of a level: entries of the state's rows, targets, fields of blank cells."""
    table, cells = raw_table(text, level), level.entry("cells")
    for name, node in cells.entries().items() if cells is not None and cells.is_mapping else ():
        row, _, event = name.partition("/")
        path, target = (*level.path, "cells", name), target_of(node)
        in_table = table.cell(row, event) if table else ""
        if gone.has(level.full(row)) or (target is None and gone.is_goal(level.composite, in_table)):
            yield path, None
        elif any(gone.is_goal(level.composite, goal) for goal in _goals(target)):
            rest = _rest(target, level, gone)
            inner = has_fields(node)
            yield (*path, "to") if inner and rest else path, rest


def _rest(target: Node | None, level: TableLevel, gone: _Gone) -> Value | None:
    """The next states that are left; None if there are none."""
    if target is None or target.is_text:
        return None
    plain = target.plain()
    if target.is_mapping:
        return {name: part for name, part in plain.items() if not gone.is_goal(level.composite, name)} or None
    return [item for item in plain if not gone.is_goal(level.composite, item["to"])] or None
