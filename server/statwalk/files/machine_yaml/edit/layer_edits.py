"""Changes layers: adds, changes, renames, deletes and reorders them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from statwalk.errors import MachineError
from statwalk.files.machine_yaml.edit.operation import EditOperation, Part
from statwalk.files.machine_yaml.edit.renaming import check_name
from statwalk.files.machine_yaml.edit.state_edits import NO_MOTION, given_fields, with_fields
from statwalk.files.machine_yaml.edit.table_levels import entries_at, read
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.files.yaml.yaml_edit import moved, with_key, with_value, without
from statwalk.files.yaml.yaml_value import Value
from statwalk.machine.definition.machine_definition import BASE, END


@dataclass(frozen=True)
class AddLayer(EditOperation):
    """Adds a layer with one state, which leaves the pose as it is; `fields`: `mask`, `mode`, `weight`;
    None as if left out.
    """

    layer: str
    fields: Mapping[str, Value | None] = field(default_factory=dict)
    state: str = "OFF"
    before: str | None = None

    def __str__(self) -> str:
        return f"new layer {self.layer}"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the layer."""
        check_name(self.layer, "layer")
        check_name(self.state, "state")
        if self.layer == BASE or self.layer in entries_at(read(text), "layers"):
            raise MachineError(f"there is a layer {self.layer} already")
        if self.before is not None:
            check_layer(text, self.before)
        width = max(len(self.state), len("state"))
        value = {
            **given_fields(self.fields),
            "initial": self.state,
            "states": {self.state: {"motion": NO_MOTION}},
            "table": f"{'state'.ljust(width)} | {END}\n{self.state.ljust(width)} |\n",
        }
        return text._replace(yaml=with_value(text.yaml, ("layers", self.layer), value, self.before))

    def touched(self) -> Iterable[Part]:
        """The name."""
        yield "name", "layer", self.layer


@dataclass(frozen=True)
class SetLayer(EditOperation):
    """Changes `mask`, `mode` or `weight` of a layer; None removes a field."""

    layer: str
    fields: Mapping[str, Value | None]

    def __str__(self) -> str:
        return f"layer {self.layer}: {', '.join(self.fields)}"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the fields."""
        check_layer(text, self.layer)
        return with_fields(text, ("layers", self.layer), self.fields)

    def touched(self) -> Iterable[Part]:
        """The name, and the fields."""
        yield "name", "layer", self.layer
        for name in self.fields:
            yield "layer", self.layer, name


@dataclass(frozen=True)
class RenameLayer(EditOperation):
    """Renames a layer."""

    layer: str
    to: str

    def __str__(self) -> str:
        return f"{self.layer} is now {self.to}"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the other name."""
        check_layer(text, self.layer)
        check_name(self.to, "layer")
        if self.to == BASE or (self.to != self.layer and self.to in entries_at(read(text), "layers")):
            raise MachineError(f"there is a layer {self.to} already")
        yaml = with_key(text.yaml, ("layers", self.layer), self.to)
        if self.layer in entries_at(read(text), "view"):
            yaml = with_key(yaml, ("view", self.layer), self.to)
        return text._replace(yaml=yaml)

    def touched(self) -> Iterable[Part]:
        """Both names."""
        yield "name", "layer", self.layer
        yield "name", "layer", self.to


@dataclass(frozen=True)
class DeleteLayer(EditOperation):
    """Deletes a layer with its table."""

    layer: str

    def __str__(self) -> str:
        return f"without the layer {self.layer}"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text without the layer."""
        check_layer(text, self.layer)
        yaml = without(text.yaml, ("layers", self.layer))
        return text._replace(yaml=without(yaml, ("view", self.layer)))

    def touched(self) -> Iterable[Part]:
        """All of the layer."""
        yield "name", "layer", self.layer
        yield "layer", self.layer
        yield "name", "state", self.layer
        yield "state", self.layer
        yield "cell", self.layer


@dataclass(frozen=True)
class MoveLayer(EditOperation):
    """Moves a layer below the layer `before`, or to the top: the last layer in the file is on top."""

    layer: str
    before: str | None = None

    def __str__(self) -> str:
        return f"layer {self.layer} moved"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text in the other order."""
        for name in (self.layer, *([] if self.before is None else [self.before])):
            check_layer(text, name)
        return text._replace(yaml=moved(text.yaml, ("layers", self.layer), self.before))

    def touched(self) -> Iterable[Part]:
        """The name."""
        yield "name", "layer", self.layer


def check_layer(text: MachineText, layer: str) -> None:
    """Checks that there is a layer above the base. :raises MachineError: when there is none."""
    root = read(text)
    if layer not in entries_at(root, "layers"):
        raise root.unknown("layer", layer, entries_at(root, "layers"), root.key_lines.get("layers", 1))
