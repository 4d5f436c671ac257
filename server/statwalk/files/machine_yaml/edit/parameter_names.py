"""Renames a parameter, or a collider, wherever a machine file speaks of it."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from statwalk.errors import MachineError
from statwalk.files.machine_yaml.edit.entry_edits import check_entry
from statwalk.files.machine_yaml.edit.operation import EditOperation, Part
from statwalk.files.machine_yaml.edit.renaming import check_name, keys_renamed, value_renamed
from statwalk.files.machine_yaml.edit.table_levels import entries_at, levels, read
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.files.yaml.yaml_edit import renamed_key
from statwalk.files.yaml.yaml_node import Node
from statwalk.files.yaml.yaml_places import BLOCKS, Splice, find, spliced
from statwalk.machine.conditions.variables import NAMES
from statwalk.machine.definition.parameter_definition import COMPONENTS


@dataclass(frozen=True)
class RenameParameter(EditOperation):
    """Renames a parameter, also in conditions, expressions, blends, solvers and keys."""

    name: str
    to: str

    def __str__(self) -> str:
        return f"{self.name} is now {self.to}"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the other name."""
        check_entry(text, "parameters", self.name)
        check_name(self.to, "parameter")
        root = read(text)
        parameters = root.entries()["parameters"]
        if self.to in parameters.entries() and self.to != self.name:
            raise MachineError(f"there is a parameter {self.to} already")
        if self.to in NAMES:
            raise MachineError(f"{self.to} is measured; conditions about it would read the parameter instead")
        own = renamed_key(text.yaml, parameters, self.name, self.to)
        return text._replace(yaml=spliced(text.yaml, [own, *_splices(text.yaml, root, self.name, self.to)]))

    def touched(self) -> Iterable[Part]:
        """Both names."""
        yield "name", "parameter", self.name
        yield "name", "parameter", self.to


def _splices(text: str, root: Node, old: str, new: str) -> Iterator[Splice]:
    kind = find(root, ("parameters", old, "kind"))
    is_vector = kind is not None and kind.value in COMPONENTS
    after = r"(?=\.[xyzw]\b)" if is_vector else r"(?![\w.])"
    pattern = re.compile(rf"(?<![\w.]){re.escape(old)}{after}")
    for formula in _formulas(root):
        yield from _in_formula(text, formula, pattern, new)
    for node in _names(root):
        if node.is_text and node.text() == old:
            yield from value_renamed(node, new)

    def part(name: str) -> str:
        return pattern.sub(new, name)

    for key in entries_at(root, "keys").values():
        for state in _nodes(find(key, ("change",))):
            yield from keys_renamed(text, state, part)


def _in_formula(text: str, node: Node, pattern: re.Pattern[str], new: str) -> Iterator[Splice]:
    """The replacements in a formula, or in lines of them; comments of lines stay."""
    for match in pattern.finditer(text, node.start, node.end):
        line = text[text.rfind("\n", 0, match.start()) + 1 : match.start()]
        if node.style not in BLOCKS or "#" not in line:
            yield Splice(match.start(), match.end(), new)


def _formulas(root: Node) -> Iterator[Node]:
    """The conditions of alternatives and senses, and all expressions."""
    for level in levels(root):
        for entry in _nodes(level.entry("cells")):
            target = find(entry, ("to",)) or entry
            for item in target.items() if isinstance(target.value, list) else ():
                if (condition := find(item, ("if",))) is not None:
                    yield condition
        for state in level.states().values():
            yield from _lines(find(state, ("motion", "expressions")))
    for sense in entries_at(root, "senses").values():
        yield from (node for key in ("when", "release") if (node := find(sense, (key,))) is not None)
    yield from _lines(root.entries().get("expressions"))


def _lines(node: Node | None) -> list[Node]:
    if node is None:
        return []
    return [node] if node.is_text else node.items()


def _names(root: Node) -> Iterator[Node]:
    """The values that may be the name of a parameter."""
    for level in levels(root):
        for state in level.states().values():
            yield from _values(find(state, ("speed",)))
            yield from _values(find(state, ("motion", "over")))
        yield from _values(level.entry("weight"))
    for solver in entries_at(root, "solvers").values():
        for key in ("target", "pole", "rotation", "weight"):
            yield from _values(find(solver, (key,)))
    yield from _values(root.entries().get("foot_lock"))
    for key, node in entries_at(root, "flock").items():
        if key.endswith("_parameter"):
            yield node


def _values(node: Node | None) -> list[Node]:
    """A value, or all values of a list or a mapping."""
    if node is None:
        return []
    return [node] if node.is_text else node.items() if isinstance(node.value, list) else _nodes(node)


def _nodes(node: Node | None) -> list[Node]:
    return list(node.entries().values()) if node is not None and node.is_mapping else []


@dataclass(frozen=True)
class RenameCollider(EditOperation):
    """Renames a collider, also in the touches of this machine."""

    name: str
    to: str

    def __str__(self) -> str:
        return f"{self.name} is now {self.to}"

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text with the other name."""
        check_entry(text, "colliders", self.name)
        check_name(self.to, "collider")
        root = read(text)
        colliders = root.entries()["colliders"]
        if self.to in colliders.entries() and self.to != self.name:
            raise MachineError(f"there is a collider {self.to} already")
        splices = [renamed_key(text.yaml, colliders, self.name, self.to)]
        for sense in entries_at(root, "senses").values():
            touch = find(sense, ("touch", 0))
            if touch is not None and touch.value == self.name:
                splices += value_renamed(touch, self.to)
        return text._replace(yaml=spliced(text.yaml, splices))

    def touched(self) -> Iterable[Part]:
        """Both names."""
        yield "name", "collider", self.name
        yield "name", "collider", self.to
