"""What every operation on a machine's text can do."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Protocol

from statwalk.files.machine_yaml.machine_text import MachineText

Part = tuple[str, ...]
"""the name of a part of a machine, from the general to the special: `("cell", "base", "WALK", "LEFT")`"""
Parts = Mapping[Part, str]
"""what a machine says in each of its parts"""


class Operation(Protocol):
    """One change; it prints as a few words for people."""

    def apply(self, text: MachineText) -> MachineText:
        """Returns the text after the change.

        :raises MachineError: when the change is not possible.
        """
        ...

    def touched(self, parts: Parts) -> Iterable[Part]:
        """Returns what the change replaces or stands on, of a machine with these parts: the beginnings of the
        names of parts.
        """
        ...
