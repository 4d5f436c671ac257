"""Renames states and events wherever a machine file speaks of them; comments stay."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property

from statwalk.errors import MachineError
from statwalk.files.machine_yaml.cells import CELL_KEYS
from statwalk.files.yaml.yaml_edit import renamed_key
from statwalk.files.yaml.yaml_node import Node
from statwalk.files.yaml.yaml_places import Splice
from statwalk.files.yaml.yaml_value import text_of
from statwalk.machine.definition.name_rule import NAME, refused_name
from statwalk.machine.definition.state_table import CELL
from statwalk.machine.model_checker.properties import LEADS, NEVER, ONLY_AFTER, REACHES

Rename = Callable[[str], str]
FORMS = (ONLY_AFTER, NEVER, LEADS, REACHES)


def check_name(name: str, kind: str) -> None:
    """Checks the name of something new. :raises MachineError: when the reader would not take it."""
    if not NAME.fullmatch(name):
        raise MachineError(refused_name(name, kind))


@dataclass(frozen=True)
class StateNames:
    """The states of a layer by their full names, and what a name means within a composite state."""

    full: Collection[str]

    def meant(self, composite: str, name: str) -> str:
        """Returns the full name that a name means: the nearest from inside out; itself if it means none."""
        while composite:
            if f"{composite}.{name}" in self.full:
                return f"{composite}.{name}"
            composite = composite.rpartition(".")[0]
        return name

    def shortest(self, composite: str, full: str) -> str:
        """Returns the shortest name that means a state within a composite state.

        :raises MachineError: when every name of the state means another state there.
        """
        parts = full.split(".")
        for count in range(1, len(parts) + 1):
            if self.meant(composite, name := ".".join(parts[-count:])) == full:
                return name
        raise _ambiguous(full, composite)


@dataclass(frozen=True)
class StateRename:
    """Another name for a state of a layer, and for what is in it. `old` and `new` are full names; `also`:
    the states that come with the rename.
    """

    names: StateNames
    old: str
    new: str
    also: Collection[str] = ()

    @cached_property
    def after(self) -> StateNames:
        """Returns the states with their new names."""
        return StateNames({self.full(state) for state in self.names.full} | {*self.also})

    def full(self, name: str) -> str:
        """Returns the new full name of a state."""
        inside = name == self.old or name.startswith(f"{self.old}.")
        return self.new + name[len(self.old) :] if inside else name

    def written(self, composite: str, name: str) -> str:
        """Returns what to write within a composite state (old name) in place of a name.

        :raises MachineError: when the new name would mean another state there.
        """
        meant = self.names.meant(composite, name)
        prefix = meant[: len(meant) - len(name)].removesuffix(".")
        new = self.full(meant).removeprefix(f"{self.full(prefix)}." if prefix else "")
        if self.after.meant(self.full(composite), new) != self.full(meant):
            raise _ambiguous(new, composite)
        return new

    def of_cell(self, composite: str, cell: str) -> str:
        """Returns a cell, `STATE!` or `STATE at MARKER`, with the new name."""
        match = CELL.fullmatch(cell)
        if match is None:
            return cell
        return self.written(composite, match["state"]) + cell[match.end("state") :]


def _ambiguous(name: str, composite: str) -> MachineError:
    return MachineError(
        f"{name!r} would be taken for another state in {composite or 'the table'}; choose another name"
    )


def sentence_renamed(sentence: str, state: Rename, event: Rename) -> str:
    """Returns a property with other names: `A only after B`, `from A, EVENT reaches B within 2 s`."""
    match = next((match for form in FORMS if (match := form.fullmatch(sentence.strip()))), None)
    if match is None:
        return sentence
    changed = match.string
    for group in sorted(match.groupdict(), key=match.start, reverse=True):
        if group in ("first", "second", "event"):
            new = (event if group == "event" else state)(match[group])
            changed = changed[: match.start(group)] + new + changed[match.end(group) :]
    return changed


def same(name: str) -> str:
    """Returns a name as it is."""
    return name


def value_renamed(node: Node, new: str, in_brackets: bool = False) -> list[Splice]:
    """Returns the replacement of a text, if it is another one."""
    return [] if node.text() == new else [Splice(node.start, node.end, text_of(new, in_brackets))]


def keys_renamed(text: str, node: Node | None, new: Rename) -> Iterator[Splice]:
    """Yields the replacements of the keys of a mapping."""
    if node is not None and node.is_mapping:
        for key in node.entries():
            if (changed := new(key)) != key:
                yield renamed_key(text, node, key, changed)


def targets_renamed(text: str, entries: Iterable[Node], cell: Rename) -> Iterator[Splice]:
    """Yields the replacements of next states in entries of `cells`: what `cell` makes of each."""
    for node in entries:
        if node.is_mapping and any(key in CELL_KEYS for key in node.entries()):
            if "to" in node.entries():
                yield from _target_renamed(text, node.entries()["to"], cell)
        elif not node.is_text:
            yield from _target_renamed(text, node, cell)


def _target_renamed(text: str, node: Node, cell: Rename) -> Iterator[Splice]:
    """The replacements in a cell, in weights by state, or in a list of alternatives."""
    if node.is_text:
        yield from value_renamed(node, cell(node.text()))
    elif node.is_mapping:
        yield from keys_renamed(text, node, cell)
    else:
        for item in node.items():
            if item.is_mapping and "to" in item.entries() and item.entries()["to"].is_text:
                to = item.entries()["to"]
                yield from value_renamed(to, cell(to.text()))
