"""Where a table stands: in the machine file itself, or as `.csv` beside it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from statwalk.errors import MachineError
from statwalk.files.yamltext import Node, read_text
from statwalk.machine.authored.table import Table, read_csv, read_table


@dataclass(frozen=True)
class TableText:
    """A table as read, its text and the file that the text is in."""

    table: Table
    text: str
    file: str


NONE = TableText(Table({}, {}, {}, ()), "", "")
"""where there is no table"""


def read(node: Node, folder: Path | None) -> TableText:
    """The table that a key `table` says or names; `folder` None: the machine is only text, and has no files beside it."""
    path = csv_path(node, folder)
    if path is None:
        return TableText(read_table(node.text(), node.file, node.first_line), node.text(), node.file)
    text = read_text(path, MachineError)
    return TableText(read_csv(text, str(path)), text, str(path))


def csv_path(node: Node, folder: Path | None) -> Path | None:
    """The file that `table` names, beside the machine file; None where the table stands there itself."""
    text = node.text().strip()
    if "\n" in text or not text.lower().endswith(".csv"):
        return None
    if folder is None:
        raise node.refuse(f"{text[:80]!r}: this machine is a text without files, so its table stands here: `table: |`")
    if Path(text).name != text:
        raise node.refuse(f"{text[:80]!r}: the table's file lies beside the machine file, so only its name is wanted")
    return folder / text
