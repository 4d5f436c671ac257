"""What every operation on a machine's text can do."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping

from statwalk.files.machine_yaml.machine_text import MachineText

Part = tuple[str, ...]
"""the name of a part of a machine, from the general to the special: `("cell", "base", "WALK", "LEFT")`"""
Parts = Mapping[Part, str]
"""what a machine says in each of its parts"""


class EditOperation(ABC):
    """One change; it prints as a few words for people."""

    @abstractmethod
    def apply(self, text: MachineText) -> MachineText:
        """Returns the text after the change.

        :raises MachineError: when the change is not possible.
        """

    @abstractmethod
    def touched(self) -> Iterable[Part]:
        """Returns what the change replaces or stands on: beginnings of the names of parts."""

    def deleted(self) -> str:
        """Returns the name of what goes with all parts that speak of it; empty: nothing."""
        return ""
