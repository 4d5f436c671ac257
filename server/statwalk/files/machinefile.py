"""Machine folders: `machine.yaml`, its table (inline or .csv), and the character that it moves. Every error names file, line and name."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from statwalk.errors import MachineError
from statwalk.files import flockpart
from statwalk.files.machine import fields, inputs, layers, levels, senses, wholetable
from statwalk.files.yamltext import Node, parse, read_text
from statwalk.machine.authored.definition import (
    END,
    EventDefinition,
    LayerDefinition,
    MachineDefinition,
    SenseDefinition,
    TouchDefinition,
    nearest,
)
from statwalk.machine.authored.table import MOST_CELLS
from statwalk.machine.built.runparts import MEASURED

FILE_NAME = "machine.yaml"
MOST_RESUMED = 2_000_000
"""next states of all cells, where each may be any of those that are resumed"""
SCHEMA_PATH = Path(__file__).with_name("machine.schema.json")
"""JSON Schema (draft 7) of a machine file, for editors"""
SEMANTICS = "1"
SHIPPED = re.compile(r"[a-z0-9]+(-[a-z0-9]+)*")
KEYS = (
    "semantics",
    "title",
    "description",
    "character",
    "root",
    "initial",
    "idle",
    "fallback",
    "defaults",
    "states",
    "events",
    "table",
    "cells",
    "layers",
    "keys",
    "parameters",
    "senses",
    "colliders",
    "flock",
    "properties",
)


@dataclass(frozen=True, eq=False)
class MachineFile:
    """A machine folder as read: `root_joint` is the joint whose horizontal motion and turn move the character through the world."""

    definition: MachineDefinition
    character_path: Path
    root_joint: str | None
    root_line: int
    text: str
    table_text: str

    def check_root(self, joints: Sequence[str]) -> None:
        """Raises MachineError with line and nearest name where the root joint is none of the character's `joints`."""
        if self.root_joint is None or self.root_joint in joints:
            return
        guess = nearest(self.root_joint, tuple(joints))
        file = self.definition.file
        raise MachineError(f"root: the character has no joint {self.root_joint!r}{guess}", file=file, place=f"line {self.root_line}")


def load_machine(folder: Path) -> MachineFile:
    """The machine of a folder. Raises MachineError with file, line and name of what is wrong."""
    return machine_of(read_text(folder / FILE_NAME, MachineError), folder)


def machine_of(text: str, folder: Path, file: str = "") -> MachineFile:
    """The machine that a text says in the place of its folder's machine file. Raises MachineError with file, line and name."""
    root = parse(text, file or str(folder / FILE_NAME), MachineError, KEYS)
    character = character_name(root)
    definition, table_text = define(root, folder.resolve().name, folder)
    entries = root.entries()
    return MachineFile(
        definition=definition,
        character_path=folder / character,
        root_joint=entries["root"].text() if "root" in entries else None,
        root_line=root.key_lines.get("root", 0),
        text=text,
        table_text=table_text,
    )


def read_machine(text: str, name: str = "machine", file: str = FILE_NAME) -> MachineDefinition:
    """The machine that a text says, with its tables inline; raises MachineError."""
    return define(parse(text, file, MachineError, KEYS), name, None)[0]


def define(root: Node, name: str, folder: Path | None) -> tuple[MachineDefinition, str]:
    """The authored machine, all its names checked, and the text of its table; raises MachineError."""
    entries = checked_keys(root)
    parameters = inputs.parameters(entries.get("parameters"))
    colliders, variables = senses.colliders(entries.get("colliders")), (*parameters, *(one for one in MEASURED if one not in parameters))
    base, above = levels.read(root, parameters, folder), layers.layers(entries.get("layers"), parameters, folder)
    layers.check_base(base, root)
    sensed = senses.senses(entries.get("senses"), variables, colliders)
    events = all_events(entries, [base, *(one.flat for one in above.values())], sensed)
    check_size(root, [base, *(one.flat for one in above.values())], events)
    definition = MachineDefinition(
        name=name,
        states=base.states,
        initial=base.initial,
        events=events,
        cells=wholetable.cells_of(base, events, variables, root.file),
        outers=base.outers,
        layers={layer: layer_of(one, events, variables, root.file) for layer, one in above.items()},
        defaults=inputs.defaults(entries.get("defaults")),
        idle=fields.chosen(entries["idle"], "event", events) if "idle" in entries else None,
        fallback=base.start(fields.chosen(entries["fallback"], "state", (*base.states, *base.outers))) if "fallback" in entries else "",
        keys=inputs.keys(entries.get("keys"), events),
        parameters=parameters,
        senses=sensed,
        colliders=colliders,
        flock=flockpart.flock(entries.get("flock"), parameters),
        properties=tuple(inputs.sentences(entries.get("properties"))),
        rows=base.top.table.rows,
        title=entries["title"].text() if "title" in entries else "",
        description=entries["description"].text() if "description" in entries else "",
        file=root.file,
    )
    return definition, base.top.text


def layer_of(layer: layers.Layer, events: Mapping[str, EventDefinition], variables: tuple[str, ...], file: str) -> LayerDefinition:
    """A layer with its cells."""
    flat = layer.flat
    return LayerDefinition(
        states=flat.states,
        initial=flat.initial,
        line=layer.line,
        mask=layer.mask,
        mode=layer.mode,
        weight=layer.weight,
        outers=flat.outers,
        cells=wholetable.cells_of(flat, events, variables, file),
        rows=flat.top.table.rows,
    )


def all_events(
    entries: Mapping[str, Node], flats: Sequence[levels.Flat], sensed: Mapping[str, SenseDefinition | TouchDefinition]
) -> dict[str, EventDefinition]:
    """The columns: those of the first table, what `events` adds, those of the other tables, and what senses raise."""
    tables = [level.table.table.events for flat in flats for level in reversed(flat.levels) if level.table is not None]
    found = {event: EventDefinition(line) for event, line in tables[0].items() if event != END} | inputs.events(entries.get("events"))
    for table in tables[1:]:
        found |= {event: EventDefinition(line) for event, line in table.items() if event != END and event not in found}
    return found | {event: EventDefinition(one.line) for event, one in sensed.items() if event not in found}


def check_size(root: Node, flats: Sequence[levels.Flat], events: Mapping[str, EventDefinition]) -> None:
    """Raises MachineError where the full tables would have too many cells: states and events are cheap to write, and multiply."""
    states, columns = sum(len(flat.states) for flat in flats), len(events) + 1
    if states * columns > MOST_CELLS:
        message = f"{states:,} states and {columns:,} events make more than {MOST_CELLS:,} cells"
        raise root.refuse(message, root.key_lines["states"])
    resumed = max(flat.resumed() for flat in flats)
    if resumed * states * columns > MOST_RESUMED:
        message = f"{states:,} states and {columns:,} events are too many beside an outer state that resumes any of {resumed:,}"
        raise root.refuse(message, root.key_lines["states"])


def checked_keys(root: Node) -> dict[str, Node]:
    """The top level of the file; raises MachineError for keys that are unknown or missing, and for another semantics."""
    entries = root.entries(*KEYS)
    if "semantics" in entries and entries["semantics"].text() != SEMANTICS:
        raise entries["semantics"].refuse(f"this program knows semantics {SEMANTICS}, not {entries['semantics'].text()[:40]!r}")
    for key in ("states", "initial", "table"):
        fields.required(root, key)
    return entries


def character_name(root: Node) -> str:
    """The character's file, or the shipped machine whose character it is; raises MachineError for what is neither."""
    node = fields.required(root, "character")
    if not SHIPPED.fullmatch(node.text()) and not node.text().lower().endswith((".glb", ".gltf", ".yaml", ".yml")):
        raise node.refuse(f"{node.text()[:80]!r} is no .glb, .gltf or .yaml file, nor the name of a shipped machine")
    return node.text()
