"""Reads machine folders: `machine.yaml`, its table (inline or .csv), and the name of the character that it
moves.

Every error names file, line and name.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from statwalk.errors import MachineError
from statwalk.files import clip_changes, model_formats
from statwalk.files.expressions import expressions as read_expressions
from statwalk.files.joint_limits import joint_limits
from statwalk.files.machine_yaml import (
    budgets,
    chains_part,
    feet,
    fields,
    flock_part,
    inputs,
    layers,
    levels,
    senses,
    solvers_part,
    springs_part,
    view_part,
    whole_table,
)
from statwalk.files.machine_yaml.all_events import all_events
from statwalk.files.machine_yaml.capture_lines import CaptureLine, read_captures
from statwalk.files.machine_yaml.ground import foot_lock as read_foot_lock
from statwalk.files.machine_yaml.ground import ground as read_ground
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.files.machine_yaml.parameters import parameters as read_parameters
from statwalk.files.machine_yaml.tables import TableFiles
from statwalk.files.yaml.yaml_text import Node, parse, read_text
from statwalk.machine.conditions.variables import variables_of
from statwalk.machine.definition.machine_definition import (
    EventDefinition,
    LayerDefinition,
    MachineDefinition,
    nearest,
)
from statwalk.machine.definition.state_table import MOST_CELLS

FILE_NAME = "machine.yaml"
MOST_RESUMED = 2_000_000
"""most next states of all cells, if each cell may lead to any state of a resumed composite state"""
SCHEMA_PATH = Path(__file__).with_name("machine.schema.json")
"""JSON Schema (draft 7) of a machine file, for editors"""
SEMANTICS = "1"
SHIPPED = re.compile(r"[a-z0-9]+(-[a-z0-9]+)*")
KEYS = (
    *("semantics", "title", "description", "character", "clips", "root", "initial", "idle", "fallback"),
    *("defaults", "states", "events", "table", "cells", "layers", "keys", "parameters", "senses"),
    *("colliders", "flock", "springs", "captures", "expressions", "joints", "limits", "properties"),
    *("feet", "contacts", "budgets", "foot_lock", "ground", "solvers", "chains", "view"),
)


@dataclass(frozen=True, eq=False)
class MachineFile:
    """A machine folder as read; the motion of `root_joint` moves the character through the world."""

    definition: MachineDefinition
    character_path: Path
    root_joint: str | None
    root_line: int
    text: str
    """with its .csv tables: see `machine_text`"""
    table_text: str
    captures: tuple[CaptureLine, ...] = ()
    """the captured motions that the character gets as clips"""

    def check_root(self, joints: Sequence[str]) -> None:
        """Checks that the root joint is one of the character's `joints`.

        :raises MachineError: when the joint does not exist; with the line and the most similar joint.
        """
        if self.root_joint is None or self.root_joint in joints:
            return
        message = f"root: the character has no joint {self.root_joint!r}{nearest(self.root_joint, joints)}"
        raise self.definition.refuse(message, self.root_line)


def load_machine(folder: Path) -> MachineFile:
    """Reads the machine of a folder.

    :raises MachineError: when the machine file or its table is missing or wrong, with file, line and name.
    """
    return _machine_of(MachineText(read_text(folder / FILE_NAME, MachineError), {}), folder)


def machine_of(text: str, folder: Path, file: str = "") -> MachineFile:
    """Reads a machine from a whole text that stands in for the files of its folder (`machine_text`); a table
    that it names and does not have is read from the folder.

    :raises MachineError: when the text or a table is wrong, with file, line and name.
    """
    return _machine_of(MachineText.of(text), folder, file)


def _machine_of(text: MachineText, folder: Path, file: str = "") -> MachineFile:
    root = parse(text.yaml, file or str(folder / FILE_NAME), MachineError, KEYS)
    character, files = _character_name(root), TableFiles(folder, text.tables)
    definition, table_text = _define(root, folder.resolve().name, files)
    entries = root.entries()
    return MachineFile(
        definition=definition,
        character_path=folder / character,
        root_joint=entries["root"].text() if "root" in entries else None,
        root_line=root.key_lines.get("root", 0),
        text=MachineText(text.yaml, files.used).whole(),
        table_text=table_text,
        captures=read_captures(entries.get("captures")),
    )


def read_machine(text: str, name: str = "machine", file: str = FILE_NAME) -> MachineDefinition:
    """Reads a machine from its whole text (`machine_text`); it has no folder.

    :raises MachineError: when the text is wrong.
    """
    parts = MachineText.of(text)
    return _define(parse(parts.yaml, file, MachineError, KEYS), name, TableFiles(texts=parts.tables))[0]


def _define(root: Node, name: str, files: TableFiles) -> tuple[MachineDefinition, str]:
    """Returns the machine's definition, all of its names checked, and the text of its table."""
    entries = _checked_keys(root)
    parameters = read_parameters(entries.get("parameters"))
    colliders, variables = senses.colliders(entries.get("colliders")), variables_of(parameters)
    base = levels.read(root, parameters, files)
    layer_parts = layers.layers(entries.get("layers"), parameters, files)
    layers.check_base(base, root)
    sense_events = senses.senses(entries.get("senses"), variables, colliders)
    events = all_events(entries, [base, *(part.flat for part in layer_parts.values())], sense_events)
    _check_size(root, [base, *(part.flat for part in layer_parts.values())], events)
    definition = MachineDefinition(
        name=name,
        states=base.states,
        initial=base.initial,
        events=events,
        cells=whole_table.cells_of(base, events, variables, root.file),
        composites=base.composites,
        layers={layer: _layer_of(part, events, variables, root.file) for layer, part in layer_parts.items()},
        defaults=inputs.defaults(entries.get("defaults")),
        idle=fields.chosen(entries["idle"], "event", events) if "idle" in entries else None,
        fallback=base.start(fields.chosen(entries["fallback"], "state", (*base.states, *base.composites)))
        if "fallback" in entries
        else "",
        keys=inputs.keys(
            entries.get("keys"),
            events,
            parameters,
            _states_of(base, *(part.flat for part in layer_parts.values())),
        ),
        parameters=parameters,
        senses=sense_events,
        colliders=colliders,
        limits=joint_limits(entries.get("joints"), entries.get("limits")),
        foot_lock=read_foot_lock(entries.get("foot_lock"), parameters),
        ground=read_ground(entries.get("ground")),
        flock=flock_part.flock(entries.get("flock"), parameters),
        clips=clip_changes.clips(entries.get("clips")),
        springs=springs_part.springs(entries.get("springs")),
        solvers=solvers_part.solvers(entries.get("solvers"), parameters, (*base.states, *base.composites)),
        chains=chains_part.chains(entries.get("chains")),
        expressions=read_expressions(entries.get("expressions"), parameters),
        properties=tuple(inputs.properties(entries.get("properties"))),
        feet=feet.feet(entries.get("feet")),
        contacts=feet.contacts(entries.get("contacts")),
        budgets=budgets.budgets(entries.get("budgets")),
        rows=base.top.table.rows,
        view=view_part.view(entries.get("view")),
        title=entries["title"].text() if "title" in entries else "",
        description=entries["description"].text() if "description" in entries else "",
        file=root.file,
    )
    return definition, base.top.text


def _states_of(*tables: levels.FlatStates) -> tuple[str, ...]:
    """The names of all states, and of composites."""
    return tuple(name for table in tables for name in (*table.states, *table.composites))


def _layer_of(
    layer: layers.LayerPart, events: Mapping[str, EventDefinition], variables: tuple[str, ...], file: str
) -> LayerDefinition:
    flat = layer.flat
    return LayerDefinition(
        states=flat.states,
        initial=flat.initial,
        line=layer.line,
        mask=layer.mask,
        mode=layer.mode,
        weight=layer.weight,
        composites=flat.composites,
        cells=whole_table.cells_of(flat, events, variables, file),
        rows=flat.top.table.rows,
    )


def _check_size(
    root: Node, flats: Sequence[levels.FlatStates], events: Mapping[str, EventDefinition]
) -> None:
    """Refuses a machine whose full tables would have too many cells: states and events multiply."""
    states, columns = sum(len(flat.states) for flat in flats), len(events) + 1
    if states * columns > MOST_CELLS:
        message = f"{states:,} states and {columns:,} events make more than {MOST_CELLS:,} cells"
        raise root.refuse(message, root.key_lines["states"])
    resumed = max(flat.resumed() for flat in flats)
    if resumed * states * columns > MOST_RESUMED:
        message = (
            f"{states:,} states and {columns:,} events are too many with a composite state that resumes "
            f"any of {resumed:,} states"
        )
        raise root.refuse(message, root.key_lines["states"])


def _checked_keys(root: Node) -> dict[str, Node]:
    """Returns the top level of the file; refuses unknown or missing keys and other semantics."""
    entries = root.entries(*KEYS)
    if "semantics" in entries and entries["semantics"].text() != SEMANTICS:
        raise entries["semantics"].refuse(
            f"this version of statwalk reads semantics {SEMANTICS}, not {entries['semantics'].text()[:40]!r}"
        )
    for key in ("states", "initial", "table"):
        fields.required(root, key)
    return entries


def _character_name(root: Node) -> str:
    """Returns the path of the character's file, or the name of the shipped machine whose character it is."""
    node = fields.required(root, "character")
    if not SHIPPED.fullmatch(node.text()) and not node.text().lower().endswith(
        (*model_formats.MODEL_SUFFIXES, ".yaml", ".yml")
    ):
        raise node.refuse(
            f"{node.text()[:80]!r} is no {', '.join(model_formats.MODEL_SUFFIXES)} or .yaml file, nor the "
            "name of a shipped machine"
        )
    return node.text()
