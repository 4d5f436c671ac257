"""Changes states: adds, changes, renames, deletes and reorders them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from statwalk.errors import MachineError
from statwalk.files.machine_yaml.edit.operation import EditOperation, Part
from statwalk.files.machine_yaml.edit.renaming import (
    StateRename,
    check_name,
)
from statwalk.files.machine_yaml.edit.state_renaming import state_names, state_renamed
from statwalk.files.machine_yaml.edit.table_levels import (
    existing_state,
    level_of,
    own_name,
    raw_table,
    read,
    with_table,
)
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.files.yaml.yaml_edit import moved, renamed_key, with_value, without
from statwalk.files.yaml.yaml_places import Path
from statwalk.files.yaml.yaml_value import Value
from statwalk.machine.definition.machine_definition import BASE

AT_REST: Mapping[str, Value] = {"expressions": ""}
"""the motion that every character has: its pose at rest"""
NO_MOTION = "none"


@dataclass(frozen=True)
class AddState(EditOperation):
    """Adds a state with a row of blank cells; `fields` as in the file, None as if left out.

    Without a `motion` it is at rest (in a layer above the base: `none`). It comes before the state `before`,
    or last.
    """

    state: str
    fields: Mapping[str, Value | None] = field(default_factory=dict)
    before: str | None = None
    layer: str = BASE

    def __str__(self) -> str:
        return f"new state {self.state}"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the state."""
        level, name = level_of(read(text), self.layer, self.state)
        check_name(name, "state")
        if name in level.states():
            raise MachineError(f"there is a state {self.state} already")
        before = own_name(level, self.before)
        fields = given_fields(self.fields)
        if not {"motion", "machine"} & fields.keys():
            fields = {"motion": AT_REST if self.layer == BASE else NO_MOTION, **fields}
        if (table := raw_table(text, level)) is not None and name not in table.names():
            table.add_row(name, before)
            text = with_table(text, level, table)
        return text._replace(yaml=with_value(text.yaml, (*level.path, "states", name), fields, before))

    def touched(self) -> Iterable[Part]:
        """The name."""
        yield "name", "state", self.layer, self.state


@dataclass(frozen=True)
class SetState(EditOperation):
    """Changes `motion`, `loop`, `speed`, `ground_speed`, `framing`, `final`, `resume` or `markers` of a
    state; None removes one.
    """

    state: str
    fields: Mapping[str, Value | None]
    layer: str = BASE

    def __str__(self) -> str:
        return f"{self.state}: {', '.join(self.fields)}"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the fields."""
        level, name = existing_state(read(text), self.layer, self.state)
        return with_fields(text, (*level.path, "states", name), self.fields)

    def touched(self) -> Iterable[Part]:
        """The name, and the fields."""
        yield "name", "state", self.layer, self.state
        for name in self.fields:
            yield "state", self.layer, self.state, name


@dataclass(frozen=True)
class RenameState(EditOperation):
    """Renames a state everywhere in the file; `to` is its new name, without the composite state around it."""

    state: str
    to: str
    layer: str = BASE

    def __str__(self) -> str:
        return f"{self.state} is now {self.to}"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the other name."""
        root = read(text)
        level, name = existing_state(root, self.layer, self.state)
        check_name(self.to, "state")
        if self.to == name:
            return text
        if self.to in level.states():
            raise MachineError(f"there is a state {level.full(self.to)} already")
        rename = StateRename(state_names(root, self.layer), self.state, level.full(self.to))
        key = renamed_key(text.yaml, level.node.entries()["states"], name, self.to)
        return state_renamed(text, root, self.layer, rename, [key])

    def touched(self) -> Iterable[Part]:
        """Both names."""
        outer = self.state.rpartition(".")[0]
        yield "name", "state", self.layer, self.state
        yield "name", "state", self.layer, f"{outer}.{self.to}" if outer else self.to


def given_fields(fields: Mapping[str, Value | None]) -> dict[str, Value]:
    """Returns the fields of a new entry: None takes nothing away there."""
    return {name: value for name, value in fields.items() if value is not None}


def with_fields(text: MachineText, path: Path, fields: Mapping[str, Value | None]) -> MachineText:
    """Returns the text with other fields of the entry at a path; None removes a field."""
    yaml = text.yaml
    for name, value in fields.items():
        yaml = (
            without(yaml, (*path, name), len(path))
            if value is None
            else with_value(yaml, (*path, name), value)
        )
    return text._replace(yaml=yaml)


@dataclass(frozen=True)
class MoveState(EditOperation):
    """Moves a state, and its row, before another state of its machine, or to the end."""

    state: str
    before: str | None = None
    layer: str = BASE

    def __str__(self) -> str:
        return f"{self.state} moved"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text in the other order."""
        level, name = existing_state(read(text), self.layer, self.state)
        before = own_name(level, self.before)
        if (table := raw_table(text, level)) is not None and name in table.names() and before != name:
            table.move_row(name, before if before in table.names() else None)
            text = with_table(text, level, table)
        return text._replace(yaml=moved(text.yaml, (*level.path, "states", name), before))

    def touched(self) -> Iterable[Part]:
        """The name."""
        yield "name", "state", self.layer, self.state
