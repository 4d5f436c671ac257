"""Reads states and tables with sub-machines flattened: the states of a machine within FIGHT become
FIGHT.GUARD, FIGHT.HIT …
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from statwalk.files.machine_yaml import fields, states, tables
from statwalk.files.yaml.yaml_text import Node
from statwalk.machine.definition.machine_definition import (
    ANY,
    CompositeDefinition,
    StateDefinition,
)
from statwalk.machine.definition.parameter_definition import ParameterDefinition

LEVEL_KEYS = ("initial", "states", "table", "cells")
COMPOSITE_KEYS = ("machine", "resume", "final")
MOST_STATES = 10_000


@dataclass(frozen=True)
class Level:
    """The table of one machine, layer or sub-machine, cells not resolved yet; `composite` is the composite
    state around it, empty at the top level.
    """

    composite: str
    table: tables.TableText | None
    cells: Node | None


@dataclass
class FlatStates:
    """All states of a layer by their full names, and the levels of its tables, inner levels first."""

    initial: str = ""
    states: dict[str, StateDefinition] = field(default_factory=dict)
    composites: dict[str, CompositeDefinition] = field(default_factory=dict)
    levels: list[Level] = field(default_factory=list)

    @property
    def top(self) -> tables.TableText:
        """The table of the outermost level; an empty table if the level has only `cells`."""
        return self.levels[-1].table or tables.NONE

    def has(self, name: str) -> bool:
        """Returns whether a full name is the name of a state or a composite state."""
        return name in self.states or name in self.composites

    def resumed(self) -> int:
        """Returns the number of states in the largest composite state that resumes."""
        counts: dict[str, int] = dict.fromkeys(
            (name for name, composite in self.composites.items() if composite.resume), 0
        )
        for state in self.states.values():
            composite = state.composite
            while composite:
                counts[composite] = counts.get(composite, 0) + 1
                composite = self.composites[composite].composite
        return max((count for name, count in counts.items() if self.composites[name].resume), default=0)

    def start(self, name: str) -> str:
        """Returns the innermost state that a state begins with."""
        while name in self.composites:
            name = self.composites[name].initial
        return name


class Scope:
    """The names that a table may use: first the names of its own level, then the names around it; `composite`
    is empty at the top level.
    """

    def __init__(self, flat: FlatStates, composite: str) -> None:
        self.flat, self.composite = flat, composite

    def __contains__(self, name: object) -> bool:
        return isinstance(name, str) and self.flat.has(self.state(name))

    def row(self, node: Node, name: str, line: int | None = None) -> str:
        """Returns the full name of a row (for `*`: OUTER.*).

        :raises MachineError: when the row is no state of this level or of a level within.
        """
        full = f"{self.composite}.{name}" if self.composite else name
        if name != ANY and not self.flat.has(full):
            raise node.unknown("state", name, self.own(), line)
        return full

    def own(self) -> list[str]:
        """Returns the states of this level and the levels within, by the names that are valid here."""
        start = f"{self.composite}." if self.composite else ""
        return [
            full.removeprefix(start)
            for full in (*self.flat.states, *self.flat.composites)
            if full.startswith(start)
        ]

    def state(self, name: str) -> str:
        """Returns the full name that a name means here: the nearest from inside out; the name itself if it
        means no state.
        """
        composite = self.composite
        while composite:
            full = f"{composite}.{name}"
            if self.flat.has(full):
                return full
            composite = self.flat.composites[composite].composite
        return name


def read(node: Node, parameters: Mapping[str, ParameterDefinition], files: tables.TableFiles) -> FlatStates:
    """Reads the states of a machine or layer, with the states of its sub-machines, and their tables.

    :raises MachineError: when a state or a table is wrong.
    """
    flat = FlatStates()
    flat.initial = flat.start(_gather(flat, node, "", parameters, files))
    return flat


def _gather(
    flat: FlatStates,
    node: Node,
    composite: str,
    parameters: Mapping[str, ParameterDefinition],
    files: tables.TableFiles,
) -> str:
    """Adds the states below a node, sub-machines first; returns the full name of the initial state."""
    entries = node.entries()
    local = fields.named(fields.required(node, "states"), "state", MOST_STATES)
    initial = fields.chosen(fields.required(node, "initial"), "state", local)
    table = files.read(entries["table"]) if "table" in entries else None
    for name, entry in local.items():
        full = f"{composite}.{name}" if composite else name
        if entry.is_mapping and "machine" in entry.entries():
            _add_composite(flat, entry, full, composite, parameters, files)
        else:
            add(flat, full, entry, states.state(entry, composite, parameters))
    flat.levels.append(Level(composite, table, entries.get("cells")))
    return f"{composite}.{initial}" if composite else initial


def add(flat: FlatStates, name: str, node: Node, state: StateDefinition | CompositeDefinition) -> None:
    """Adds a state.

    :raises MachineError: when the name is taken, which is possible only for a name with a dot in it.
    """
    if flat.has(name):
        raise node.refuse(
            f"the state {name[:80]} was already given in line {(flat.states | flat.composites)[name].line}"
        )
    if isinstance(state, CompositeDefinition):
        flat.composites[name] = state
    else:
        flat.states[name] = state


def _add_composite(
    flat: FlatStates,
    node: Node,
    name: str,
    composite: str,
    parameters: Mapping[str, ParameterDefinition],
    files: tables.TableFiles,
) -> None:
    """Adds a composite state, `{machine: {initial: …, states: …, table: …}, resume: true}`, and all states in
    it.
    """
    entries = node.entries(*COMPOSITE_KEYS)
    if "final" in entries and not composite:
        raise entries["final"].refuse("`final` is only for states of a sub-machine")
    machine = entries["machine"]
    machine.entries(*LEVEL_KEYS)
    resume, final = fields.truth(entries, "resume"), fields.truth(entries, "final")
    add(flat, name, node, CompositeDefinition("", resume, node.line, composite, final))
    initial = _gather(flat, machine, name, parameters, files)
    flat.composites[name] = replace(flat.composites[name], initial=initial)
