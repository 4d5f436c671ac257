"""Changes entries of a section of a machine file: parameters, senses, keys, colliders."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Literal

from statwalk.errors import MachineError
from statwalk.files.machine_yaml.edit.operation import EditOperation, Part
from statwalk.files.machine_yaml.edit.renaming import check_name
from statwalk.files.machine_yaml.edit.state_edits import given_fields, with_fields
from statwalk.files.machine_yaml.edit.table_levels import entries_at, read
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.files.yaml.yaml_edit import moved, with_value, without
from statwalk.files.yaml.yaml_value import Value

Section = Literal["parameters", "senses", "keys", "colliders"]
KINDS: Mapping[Section, str] = {
    "parameters": "parameter",
    "senses": "sense",
    "keys": "key",
    "colliders": "collider",
}


@dataclass(frozen=True)
class AddEntry(EditOperation):
    """Adds an entry with its fields as in the file, before another or last; None as if left out."""

    section: Section
    name: str
    fields: Mapping[str, Value | None]
    before: str | None = None

    def __str__(self) -> str:
        return f"new {KINDS[self.section]} {self.name}"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the entry."""
        if self.section != "keys":
            check_name(self.name, KINDS[self.section])
        if self.name in entries_at(read(text), self.section):
            raise MachineError(f"there is a {KINDS[self.section]} {self.name} already")
        if self.before is not None:
            check_entry(text, self.section, self.before)
        return text._replace(
            yaml=with_value(text.yaml, (self.section, self.name), given_fields(self.fields), self.before)
        )

    def touched(self) -> Iterable[Part]:
        """The name."""
        yield "name", KINDS[self.section], self.name


@dataclass(frozen=True)
class SetEntry(EditOperation):
    """Changes fields of an entry; None removes a field."""

    section: Section
    name: str
    fields: Mapping[str, Value | None]

    def __str__(self) -> str:
        return f"{KINDS[self.section]} {self.name}: {', '.join(self.fields)}"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the fields."""
        check_entry(text, self.section, self.name)
        return with_fields(text, (self.section, self.name), self.fields)

    def touched(self) -> Iterable[Part]:
        """The name and the fields."""
        yield "name", KINDS[self.section], self.name
        for name in self.fields:
            yield KINDS[self.section], self.name, name


@dataclass(frozen=True)
class DeleteEntry(EditOperation):
    """Deletes an entry; the reader refuses the machine if something still names it."""

    section: Section
    name: str

    def __str__(self) -> str:
        return f"without the {KINDS[self.section]} {self.name}"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text without the entry."""
        check_entry(text, self.section, self.name)
        return text._replace(yaml=without(text.yaml, (self.section, self.name)))

    def touched(self) -> Iterable[Part]:
        """The name and the fields."""
        yield "name", KINDS[self.section], self.name
        yield KINDS[self.section], self.name


@dataclass(frozen=True)
class MoveEntry(EditOperation):
    """Moves an entry before another, or to the end."""

    section: Section
    name: str
    before: str | None = None

    def __str__(self) -> str:
        return f"{KINDS[self.section]} {self.name} moved"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text in the other order."""
        check_entry(text, self.section, self.name)
        if self.before is not None:
            check_entry(text, self.section, self.before)
        return text._replace(yaml=moved(text.yaml, (self.section, self.name), self.before))

    def touched(self) -> Iterable[Part]:
        """The name."""
        yield "name", KINDS[self.section], self.name


def check_entry(text: MachineText, section: Section, name: str) -> None:
    """Checks that a section has an entry. :raises MachineError: when it has none."""
    root = read(text)
    if name not in entries_at(root, section):
        raise root.unknown(KINDS[section], name, entries_at(root, section), root.key_lines.get(section, 1))
