"""Puts a state into a sub-machine, or takes the state out of its sub-machine.

The state keeps its row, and whatever names the state names it anew.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from statwalk.errors import MachineError
from statwalk.files.machine_yaml.edit.empty_sub_machine import without_uses
from statwalk.files.machine_yaml.edit.moved_state import StateMove, level_at
from statwalk.files.machine_yaml.edit.operation import EditOperation, Part
from statwalk.files.machine_yaml.edit.renaming import StateRename, check_name
from statwalk.files.machine_yaml.edit.state_edits import MoveState
from statwalk.files.machine_yaml.edit.state_renaming import row_renamed, state_names, state_renamed
from statwalk.files.machine_yaml.edit.table_levels import (
    TableLevel,
    existing_state,
    levels_of,
    raw_table,
    read,
    with_table,
)
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.files.yaml.yaml_edit import with_value, without
from statwalk.files.yaml.yaml_node import Node
from statwalk.files.yaml.yaml_places import IN_BRACKETS
from statwalk.files.yaml.yaml_value import Spread, Value
from statwalk.machine.definition.machine_definition import ANY, BASE


@dataclass(frozen=True)
class NestState(EditOperation):
    """Puts a state into the sub-machine `into` (a full name) of the same table; where there is none of this
    name, it is made, and begins with the state.
    """

    state: str
    into: str
    layer: str = BASE

    def __str__(self) -> str:
        return f"{self.state} in {self.into}"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the state in the sub-machine."""
        root = read(text)
        level, name = existing_state(root, self.layer, self.state)
        own = self.into.removeprefix(f"{level.composite}.") if level.composite else self.into
        self._check(root, level, name, own)
        is_new, is_initial = own not in level.states(), _begins_with(level, name)
        also = (self.into,) if is_new else ()
        rename = StateRename(state_names(root, self.layer), self.state, f"{self.into}.{name}", also)
        row = row_renamed(level, name, rename)
        text = state_renamed(text, root, self.layer, rename)
        if is_initial:
            text = text._replace(yaml=with_value(text.yaml, (*level.path, "initial"), own))
        if is_new:
            text = _with_sub_machine(text, level_at(text, self.layer, level.composite), own, name, row)
        source, target = level.composite, self.into
        return StateMove(self.layer, name, row, source, source, target, rename.after).apply(text)

    def _check(self, root: Node, level: TableLevel, name: str, own: str) -> None:
        """:raises MachineError: when the state cannot be in the sub-machine."""
        there = level.states().get(own)
        if name == ANY or "." in name:
            raise MachineError(f"{name} is no name for a state of a sub-machine; rename {name} first")
        if "." in own or level.full(own) != self.into:
            raise MachineError(
                f"{self.into} would not stand in the table of {self.state}; "
                f"name a sub-machine in that table, as {level.full('FIGHT')}"
            )
        if own == name:
            raise MachineError(f"{self.state} cannot be in {self.into}; name another sub-machine")
        if there is None:
            check_name(own, "sub-machine")
            return
        inner = next((inner for inner in levels_of(root, self.layer) if inner.composite == self.into), None)
        if inner is None:
            raise there.refuse(f"{self.into} is a state and no sub-machine; choose another name")
        if name in inner.states():
            raise there.refuse(f"there is a state {self.into}.{name} already; rename {self.state} first")
        if _begins_with(level, name):
            raise there.refuse(f"{self.state} is the initial state; choose another one first")

    def touched(self) -> Iterable[Part]:
        """The state with its row, and the sub-machine."""
        yield from _touched(self.layer, self.state)
        yield "name", "state", self.layer, self.into
        yield "name", "state", self.layer, f"{self.into}.{self.state.rpartition('.')[2]}"


def _begins_with(level: TableLevel, name: str) -> bool:
    initial = level.entry("initial")
    return initial is not None and initial.value == name


def _touched(layer: str, state: str) -> Iterable[Part]:
    yield "name", "state", layer, state
    yield "state", layer, state
    yield "cell", layer, state


def _with_sub_machine(text: MachineText, level: TableLevel, own: str, name: str, row: str) -> MachineText:
    """Returns the text with a sub-machine without states before a state; its table has the columns of the
    table around it.
    """
    machine: dict[str, Value] = {"initial": name, "states": {}}
    table, states = raw_table(text, level), level.entry("states")
    if table is not None:
        if states is not None and states.style != IN_BRACKETS:
            columns = [column for column in table.columns() if column != ANY]
            machine["table"] = " | ".join(["state", *columns]) + "\n"
        if row in table.names():
            table.add_row(own, row)
            text = with_table(text, level, table)
    path = (*level.path, "states", own)
    return text._replace(yaml=with_value(text.yaml, path, Spread({"machine": Spread(machine)}), name))


@dataclass(frozen=True)
class UnnestState(EditOperation):
    """Takes a state out of its sub-machine, into the table around it. The last state takes the place of the
    sub-machine, which goes.
    """

    state: str
    layer: str = BASE

    def __str__(self) -> str:
        return f"{self.state} taken out"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the state outside."""
        root = read(text)
        level, name = existing_state(root, self.layer, self.state)
        outer, own = self._around(root, level, name)
        after = _next(outer, own)
        is_last = len(level.states()) == 1
        if is_last:
            text = without_uses(text, outer, level)
        rename = _rename(root, self.layer, level, outer.full(name), is_last)
        row, scope = row_renamed(level, name, rename), rename.full(level.composite)
        text = state_renamed(text, read(text), self.layer, rename)
        source, target = level.composite, outer.composite
        text = StateMove(self.layer, name, row, source, scope, target, rename.after).apply(text)
        states = (*outer.path, "states")
        yaml = without(text.yaml, (*states, name, "final"), len(states) + 1)
        yaml = without(yaml, (*states, own)) if is_last else yaml
        return MoveState(rename.new, after, self.layer).apply(text._replace(yaml=yaml))

    def _around(self, root: Node, level: TableLevel, name: str) -> tuple[TableLevel, str]:
        """The table around the sub-machine, and the sub-machine's own name there.

        :raises MachineError: when the state cannot be taken out.
        """
        if not level.composite:
            raise MachineError(f"{self.state} stands in no sub-machine; only a state of one can be taken out")
        outer, own = existing_state(root, self.layer, level.composite)
        if name in outer.states() and name != own:
            raise MachineError(f"there is a state {outer.full(name)} already; rename {self.state} first")
        if name == own:
            raise MachineError(f"{self.state} and its sub-machine have one name; rename {self.state} first")
        if _begins_with(level, name) and len(level.states()) > 1:
            raise MachineError(f"{self.state} is the initial state; choose another one first")
        return outer, own

    def touched(self) -> Iterable[Part]:
        """The state with its row, and the sub-machine."""
        composite = self.state.rpartition(".")[0]
        outer = composite.rpartition(".")[0]
        name = self.state.rpartition(".")[2]
        yield from _touched(self.layer, self.state)
        yield "name", "state", self.layer, composite
        yield "name", "state", self.layer, f"{outer}.{name}" if outer else name


class _LastOut(StateRename):
    """A sub-machine (`old`) is now its only state (`new`)."""

    def full(self, name: str) -> str:
        """Returns the new full name of a state."""
        inner = f"{self.old}.{self.new.rpartition('.')[2]}"
        if name == self.old:
            return self.new
        return self.new + name[len(inner) :] if f"{name}.".startswith(f"{inner}.") else name


def _rename(root: Node, layer: str, level: TableLevel, new: str, is_last: bool) -> StateRename:
    names = state_names(root, layer)
    if is_last:
        return _LastOut(names, level.composite, new)
    return StateRename(names, level.full(new.rpartition(".")[2]), new)


def _next(level: TableLevel, name: str) -> str | None:
    """The full name of the state after another one."""
    states = list(level.states())
    after = states[states.index(name) + 1 :]
    return level.full(after[0]) if after else None
