"""Reads a table from the machine file itself, or from a `.csv` file beside it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
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


@dataclass
class TableFiles:
    """The .csv files of a machine: texts by name, or files in a folder (None: the machine has none)."""

    folder: Path | None = None
    texts: Mapping[str, str] = field(default_factory=dict)
    used: dict[str, str] = field(default_factory=dict)
    """the text of each file that was read, by its name"""

    def read(self, node: Node) -> TableText:
        """Reads the table that the key `table` contains or names.

        :raises MachineError: when the table is missing or wrong.
        """
        name = _csv_name(node)
        if name is None:
            return TableText(read_table(node.text(), node.file, node.first_line), node.text(), node.file)
        if name in self.texts:
            text, file = self.texts[name], name
        elif self.folder is None:
            raise node.refuse(
                f"{name[:80]!r}: this machine has no files beside it; write its table here: `table: |`"
            )
        else:
            text, file = read_text(self.folder / name, MachineError), str(self.folder / name)
        self.used[name] = text
        return TableText(read_csv(text, file), text, file)


def _csv_name(node: Node) -> str | None:
    """Returns the name of the file that `table` names; None if the key contains the table itself."""
    text = node.text().strip()
    if "\n" in text or not text.lower().endswith(".csv"):
        return None
    if Path(text).name != text:
        raise node.refuse(
            f"{text[:80]!r}: the table's file is in the folder of the machine file; write only its name"
        )
    return text
