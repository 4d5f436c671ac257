"""Reads a table from the machine file itself, or from a `.csv` file beside it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from statwalk.errors import MachineError
from statwalk.files.yaml.yaml_text import Node, read_text
from statwalk.machine.definition.state_table import Table, read_csv, read_table


@dataclass(frozen=True)
class TableText:
    """A table as read, its text, and the file that holds the text."""

    table: Table
    text: str
    file: str


NONE = TableText(Table({}, {}, {}, ()), "", "")
"""an empty table"""


def read(node: Node, folder: Path | None) -> TableText:
    """Reads the table that the key `table` contains or names; with `folder` None the machine has no files
    beside it.

    :raises MachineError: when the table is missing or wrong.
    """
    path = _csv_path(node, folder)
    if path is None:
        return TableText(read_table(node.text(), node.file, node.first_line), node.text(), node.file)
    text = read_text(path, MachineError)
    return TableText(read_csv(text, str(path)), text, str(path))


def _csv_path(node: Node, folder: Path | None) -> Path | None:
    """Returns the path of the file that `table` names; None if the key contains the table itself."""
    text = node.text().strip()
    if "\n" in text or not text.lower().endswith(".csv"):
        return None
    if folder is None:
        raise node.refuse(
            f"{text[:80]!r}: this machine has no files beside it; write its table here: `table: |`"
        )
    if Path(text).name != text:
        raise node.refuse(
            f"{text[:80]!r}: the table's file is in the folder of the machine file; write only its name"
        )
    return folder / text
