"""The feet of a character as a machine file corrects them, and their contacts with the ground."""

from __future__ import annotations

from dataclasses import dataclass

Span = tuple[float, float]
"""first and last phase; beyond 1 it goes on after the seam of a loop"""


@dataclass(frozen=True)
class FootDefinition:
    """The joints of a leg by name; an empty name: as the names of the joints tell."""

    line: int
    ankle: str
    hip: str = ""
    knee: str = ""
    toe: str = ""


@dataclass(frozen=True)
class ContactDefinition:
    """The spans in which a foot stands on the ground in a clip."""

    spans: tuple[Span, ...]
    line: int
