"""The whole text of a machine: its machine file, and after it the .csv tables that the file names.

    initial: STAT
    table: table.csv
    --- table.csv
    state,FORWARD,STOP

So a version, a stage's log and a running server need no file of the machine's folder to read it again. The
text of a machine with all tables inline is its machine file.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import NamedTuple

from statwalk.errors import MachineError

FILE = r"[^/\\\n]{1,100}\.[Cc][Ss][Vv]"
TABLE = re.compile(rf"\n--- ({FILE})\n")
"""begins a table; in one YAML document no line begins with `---` further down"""


class MachineText(NamedTuple):
    """The machine file, and its .csv tables by file name."""

    yaml: str
    tables: Mapping[str, str]

    @classmethod
    def of(cls, whole: str) -> MachineText:
        """Returns the parts of a machine's whole text."""
        yaml, *parts = TABLE.split(whole)
        return cls(yaml, dict(zip(parts[::2], parts[1::2], strict=True)))

    def whole(self) -> str:
        """Returns both in one text.

        :raises MachineError: when a name cannot be that of a .csv file in the folder.
        """
        for name in self.tables:
            if not re.fullmatch(FILE, name):
                raise MachineError(f"{name[:80]!r} is no name of a .csv file; write it without a folder")
        return self.yaml + "".join(f"\n--- {name}\n{table}" for name, table in self.tables.items())
