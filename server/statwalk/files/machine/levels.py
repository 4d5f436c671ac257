"""States and their tables, with sub-machines flattened: the states of a machine within FIGHT become FIGHT.GUARD, FIGHT.HIT …"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

from statwalk.files.machine import fields, states, tables
from statwalk.files.yamltext import Node
from statwalk.machine.authored.definition import ANY, OuterDefinition, ParameterDefinition, StateDefinition

LEVEL_KEYS = ("initial", "states", "table", "cells")
OUTER_KEYS = ("machine", "resume", "final")
MOST_STATES = 10_000


@dataclass(frozen=True)
class Level:
    """The table of one machine, layer or sub-machine, not yet looked into; `outer` is the state around it, empty at the top."""

    outer: str
    table: tables.TableText | None
    cells: Node | None


@dataclass
class Flat:
    """All states of a layer under their full names, and the levels that speak of them, inner ones first."""

    initial: str = ""
    states: dict[str, StateDefinition] = field(default_factory=dict)
    outers: dict[str, OuterDefinition] = field(default_factory=dict)
    levels: list[Level] = field(default_factory=list)

    @property
    def top(self) -> tables.TableText:
        """The table of the outermost level; an empty one where it has only `cells`."""
        return self.levels[-1].table or tables.NONE

    def has(self, name: str) -> bool:
        """Whether a full name is that of a state, perhaps an outer one."""
        return name in self.states or name in self.outers

    def resumed(self) -> int:
        """How many states the largest of the outer states that resume has."""
        counts: dict[str, int] = dict.fromkeys((name for name, one in self.outers.items() if one.resume), 0)
        for state in self.states.values():
            outer = state.outer
            while outer:
                counts[outer] = counts.get(outer, 0) + 1
                outer = self.outers[outer].outer
        return max((count for name, count in counts.items() if self.outers[name].resume), default=0)

    def start(self, name: str) -> str:
        """The innermost state that a state begins with."""
        while name in self.outers:
            name = self.outers[name].initial
        return name


class Scope:
    """The names that a table may use: those of its own level first, then those around it; `outer` is empty at the top."""

    def __init__(self, flat: Flat, outer: str) -> None:
        self.flat, self.outer = flat, outer

    def __contains__(self, name: object) -> bool:
        """Whether a name is that of a state here."""
        return isinstance(name, str) and self.flat.has(self.state(name))

    def row(self, node: Node, name: str, line: int | None = None) -> str:
        """The full name of a row (for `*`, OUTER.*); raises MachineError where it is no state of this level or of those within."""
        full = f"{self.outer}.{name}" if self.outer else name
        if name != ANY and not self.flat.has(full):
            raise node.unknown("state", name, self.own(), line)
        return full

    def own(self) -> list[str]:
        """The states of this level and those within, as they are called here."""
        start = f"{self.outer}." if self.outer else ""
        return [full.removeprefix(start) for full in (*self.flat.states, *self.flat.outers) if full.startswith(start)]

    def state(self, name: str) -> str:
        """The full name of what a name means here: the nearest from inside out; itself where it is nothing."""
        outer = self.outer
        while outer:
            full = f"{outer}.{name}"
            if self.flat.has(full):
                return full
            outer = self.flat.outers[outer].outer
        return name


def read(node: Node, parameters: Mapping[str, ParameterDefinition], folder: Path | None) -> Flat:
    """The states of a machine or layer, with those of its sub-machines, and their tables; raises MachineError."""
    flat = Flat()
    flat.initial = flat.start(gather(flat, node, "", parameters, folder))
    return flat


def gather(flat: Flat, node: Node, outer: str, parameters: Mapping[str, ParameterDefinition], folder: Path | None) -> str:
    """Adds the states below a node, sub-machines first; returns the full name of the initial one."""
    entries = node.entries()
    local = fields.named(fields.required(node, "states"), "state", MOST_STATES)
    initial = fields.chosen(fields.required(node, "initial"), "state", local)
    table = tables.read(entries["table"], folder) if "table" in entries else None
    for name, one in local.items():
        full = f"{outer}.{name}" if outer else name
        if one.is_mapping and "machine" in one.entries():
            add_outer(flat, one, full, outer, parameters, folder)
        else:
            add(flat, full, one, states.state(one, outer, parameters))
    flat.levels.append(Level(outer, table, entries.get("cells")))
    return f"{outer}.{initial}" if outer else initial


def add(flat: Flat, name: str, node: Node, state: StateDefinition | OuterDefinition) -> None:
    """One more state; raises MachineError where its name is taken, which needs a dot in it."""
    if flat.has(name):
        raise node.refuse(f"the state {name[:80]} was already given in line {(flat.states | flat.outers)[name].line}")
    if isinstance(state, OuterDefinition):
        flat.outers[name] = state
    else:
        flat.states[name] = state


def add_outer(flat: Flat, node: Node, name: str, outer: str, parameters: Mapping[str, ParameterDefinition], folder: Path | None) -> None:
    """A state that is a machine itself, `{machine: {initial: …, states: …, table: …}, resume: true}`, and all that is in it."""
    entries = node.entries(*OUTER_KEYS)
    if "final" in entries and not outer:
        raise entries["final"].refuse("`final` is for the states of a sub-machine")
    machine = entries["machine"]
    machine.entries(*LEVEL_KEYS)
    resume, final = fields.truth(entries, "resume"), fields.truth(entries, "final")
    add(flat, name, node, OuterDefinition("", resume, node.line, outer, final))
    initial = gather(flat, machine, name, parameters, folder)
    flat.outers[name] = replace(flat.outers[name], initial=initial)
