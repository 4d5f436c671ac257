"""Changes what a machine says of itself: title, initial state, defaults, properties, expressions, view."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from statwalk.errors import MachineError
from statwalk.files.machine_yaml.edit.operation import EditOperation, Part
from statwalk.files.machine_yaml.edit.table_levels import entries_at, existing_state, level_of, read
from statwalk.files.machine_yaml.expression_text import with_expressions
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.files.yaml.yaml_edit import moved, with_value, without
from statwalk.files.yaml.yaml_edit import read as parse_yaml
from statwalk.files.yaml.yaml_value import Spread, Value
from statwalk.machine.definition.machine_definition import BASE

SETTINGS = ("title", "description", "root", "idle", "fallback", "foot_lock")


@dataclass(frozen=True)
class SetMachine(EditOperation):
    """Changes settings of the machine: `title`, `description`, `root`, `idle`, `fallback`, `foot_lock`; None
    removes one.
    """

    fields: Mapping[str, Value | None]

    def __str__(self) -> str:
        return ", ".join(self.fields)

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the settings."""
        yaml = text.yaml
        for name, value in self.fields.items():
            if name not in SETTINGS:
                raise MachineError(f"{name!r} is no setting of a machine; there are {', '.join(SETTINGS)}")
            before = "initial" if name in ("title", "description", "root") else None
            yaml = without(yaml, (name,)) if value is None else with_value(yaml, (name,), value, before)
        return text._replace(yaml=yaml)

    def touched(self) -> Iterable[Part]:
        """The settings."""
        for name in self.fields:
            yield "machine", name


@dataclass(frozen=True)
class SetDefaults(EditOperation):
    """Changes what cells take that say nothing: `when`, `blend`, `buffer`; None removes one."""

    fields: Mapping[str, Value | None]

    def __str__(self) -> str:
        return f"defaults: {', '.join(self.fields)}"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the defaults."""
        yaml = text.yaml
        for name, value in self.fields.items():
            path = "defaults", name
            yaml = without(yaml, path) if value is None else with_value(yaml, path, value)
        return text._replace(yaml=yaml)

    def touched(self) -> Iterable[Part]:
        """The defaults."""
        for name in self.fields:
            yield "defaults", name


@dataclass(frozen=True)
class SetInitial(EditOperation):
    """Makes a state the one with which its layer, or the machine around it, begins."""

    state: str
    layer: str = BASE

    def __str__(self) -> str:
        return f"{self.state} is the initial state"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the initial state."""
        level, name = existing_state(read(text), self.layer, self.state)
        return text._replace(yaml=with_value(text.yaml, (*level.path, "initial"), name))

    def touched(self) -> Iterable[Part]:
        """The initial state, and the name of the new one."""
        yield "initial", self.layer, self.state.rpartition(".")[0]
        yield "name", "state", self.layer, self.state


# --- properties


@dataclass(frozen=True)
class AddProperty(EditOperation):
    """Adds a property, a sentence that must be true: `JUMP only after WALK`."""

    text: str

    def __str__(self) -> str:
        return f"new property: {self.text}"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the property."""
        sentences = _properties(text)
        if self.text in sentences:
            raise MachineError(f"the machine has this property already: {self.text}")
        return text._replace(yaml=with_value(text.yaml, ("properties", len(sentences)), self.text))

    def touched(self) -> Iterable[Part]:
        """The sentence."""
        yield "property", self.text


@dataclass(frozen=True)
class SetProperty(EditOperation):
    """Replaces a property, or deletes it (`text` None)."""

    property: str
    text: str | None

    def __str__(self) -> str:
        return f"property: {self.text or f'without {self.property}'}"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the other property."""
        path = "properties", _place(text, self.property)
        if self.text is None:
            return text._replace(yaml=without(text.yaml, path))
        return text._replace(yaml=with_value(text.yaml, path, self.text))

    def touched(self) -> Iterable[Part]:
        """The sentence."""
        yield "property", self.property


@dataclass(frozen=True)
class MoveProperty(EditOperation):
    """Moves a property before another, or to the end."""

    property: str
    before: str | None = None

    def __str__(self) -> str:
        return "properties in another order"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text in the other order."""
        before = None if self.before is None else _place(text, self.before)
        return text._replace(yaml=moved(text.yaml, ("properties", _place(text, self.property)), before))

    def touched(self) -> Iterable[Part]:
        """The sentence."""
        yield "property", self.property


def _properties(text: MachineText) -> list[str]:
    node = read(text).entries().get("properties")
    return [sentence.text() for sentence in node.items()] if node is not None and node.value else []


def _place(text: MachineText, sentence: str) -> int:
    """The place of a property. :raises MachineError: when the machine has no such property."""
    if sentence not in _properties(text):
        raise read(text).unknown("property", sentence, _properties(text), 1)
    return _properties(text).index(sentence)


# --- expressions and view


@dataclass(frozen=True)
class SetExpressions(EditOperation):
    """Replaces the machine's expressions, a line each; blank: none."""

    text: str

    def __str__(self) -> str:
        return "expressions"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the expressions."""
        return text._replace(yaml=with_expressions(text.yaml, self.text, ""))

    def touched(self) -> Iterable[Part]:
        """The expressions."""
        yield ("expressions",)


@dataclass(frozen=True)
class SetView(EditOperation):
    """Keeps where states stand in the graph of a layer, by full names; None: where the page puts them."""

    positions: Mapping[str, tuple[float, float] | None]
    layer: str = BASE

    def __str__(self) -> str:
        return "places in the graph"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the places."""
        level_of(read(text), self.layer, "*")
        yaml = text.yaml
        for state, place in self.positions.items():
            existing_state(read(text), self.layer, state)
            path = "view", self.layer, state
            if place is None:
                yaml = without(yaml, path)
            elif self.layer in entries_at(parse_yaml(yaml), "view"):
                yaml = with_value(yaml, path, list(place))
            else:
                yaml = with_value(yaml, path[:2], Spread({state: list(place)}))
        return text._replace(yaml=yaml)

    def touched(self) -> Iterable[Part]:
        """Nothing: the newest places count."""
        return ()
