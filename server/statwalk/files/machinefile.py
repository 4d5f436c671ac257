"""Machine folders: `machine.yaml`, its table (inline or .csv), and the character that it moves. Every error names file, line and name."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from statwalk.errors import MachineError
from statwalk.files import machineparts as parts
from statwalk.files.yamltext import Node, parse, read_text
from statwalk.machine.definition import EventDefinition, MachineDefinition, nearest
from statwalk.machine.table import Table, read_csv, read_table

FILE_NAME = "machine.yaml"
SEMANTICS = "1"
KEYS = (
    "semantics",
    "title",
    "description",
    "character",
    "root",
    "initial",
    "idle",
    "defaults",
    "states",
    "events",
    "table",
    "cells",
    "keys",
    "parameters",
    "properties",
)
NOT_YET = ("senses", "layers")


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
    path = folder / FILE_NAME
    text = read_text(path, MachineError)
    root = parse(text, str(path), MachineError)
    table_node = required(root, "table")
    table_path = csv_path(table_node, folder)
    table_text = read_text(table_path, MachineError) if table_path else table_node.text()
    table = read_csv(table_text, str(table_path)) if table_path else read_table(table_text, str(path), table_node.first_line)
    entries = root.entries()
    return MachineFile(
        definition=define(root, table, folder.resolve().name, str(table_path or path)),
        character_path=folder / character_name(root),
        root_joint=entries["root"].text() if "root" in entries else None,
        root_line=root.key_lines.get("root", 0),
        text=text,
        table_text=table_text,
    )


def read_machine(text: str, name: str = "machine", file: str = FILE_NAME) -> MachineDefinition:
    """The machine that a text says, with its table inline; raises MachineError."""
    root = parse(text, file, MachineError)
    node = required(root, "table")
    return define(root, read_table(node.text(), file, node.first_line), name, file)


def define(root: Node, table: Table, name: str, table_file: str) -> MachineDefinition:
    """The authored machine, all its names checked; raises MachineError."""
    entries = checked_keys(root)
    states = {state: parts.state(node) for state, node in required(root, "states").entries().items()}
    parts.refuse_bad_names(required(root, "states"), "state")
    check_rows(table, states, table_file)
    events = {event: EventDefinition(line) for event, line in table.events.items() if event != "END"}
    events |= parts.events(entries.get("events"))
    cells = dict(table.cells)
    if "cells" in entries:
        cells = parts.refine(cells, entries["cells"], states, events)
    return MachineDefinition(
        name=name,
        states=states,
        initial=chosen(required(root, "initial"), "state", states),
        events=events,
        cells=cells,
        defaults=parts.defaults(entries.get("defaults")),
        idle=chosen(entries["idle"], "event", events) if "idle" in entries else None,
        keys={key: parts.key(node, events) for key, node in parts.mapping(entries.get("keys"))},
        parameters={one: parts.parameter(node) for one, node in parts.mapping(entries.get("parameters"))},
        properties=tuple(parts.sentences(entries.get("properties"))),
        rows=table.rows,
        title=entries["title"].text() if "title" in entries else "",
        description=entries["description"].text() if "description" in entries else "",
        file=root.file,
    )


def checked_keys(root: Node) -> dict[str, Node]:
    """The top level of the file; raises MachineError for keys that are unknown or not supported yet, and for another semantics."""
    for key in NOT_YET:
        if key in root.entries():
            raise root.refuse(f"`{key}` is not supported yet", root.key_lines[key])
    entries = root.entries(*KEYS)
    if "semantics" in entries and entries["semantics"].text() != SEMANTICS:
        raise entries["semantics"].refuse(f"this program knows semantics {SEMANTICS}, not {entries['semantics'].text()[:40]!r}")
    return entries


def required(root: Node, key: str) -> Node:
    """The value of a key that must be there."""
    checked_keys(root)
    if key not in root.entries():
        raise root.refuse(f"the key `{key}` is missing")
    return root.entries()[key]


def chosen(node: Node, kind: str, known: Iterable[str]) -> str:
    """A name that must exist; raises MachineError with the nearest that does."""
    if node.text() not in known:
        raise node.unknown(kind, node.text(), known)
    return node.text()


def check_rows(table: Table, states: Iterable[str], file: str) -> None:
    """Rows of the table are states (or `*`); raises MachineError for one that is not."""
    for row, line in table.states.items():
        if row != "*" and row not in states:
            raise Node(row, line, file, MachineError).unknown("state", row, states)


def csv_path(node: Node, folder: Path) -> Path | None:
    """The file that `table` names, beside the machine file; None where the table stands there itself."""
    text = node.text().strip()
    if "\n" in text or not text.lower().endswith(".csv"):
        return None
    if Path(text).name != text:
        raise node.refuse(f"{text[:80]!r}: the table's file lies beside the machine file, so only its name is wanted")
    return folder / text


def character_name(root: Node) -> str:
    """The character's file; raises MachineError for what is no character file."""
    node = required(root, "character")
    if not node.text().lower().endswith((".glb", ".gltf", ".yaml", ".yml")):
        raise node.refuse(f"{node.text()[:80]!r} is no .glb, .gltf or .yaml file")
    return node.text()
