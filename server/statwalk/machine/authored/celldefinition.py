"""What a cell says, as written: when its event counts, what it leads to, how it blends, and what comes out."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True)
class Moment:
    """When an event is taken: `now`, at the `end` of the motion (or of its loop), at a `marker` of it, or in a `window` of its phase."""

    kind: Literal["now", "end", "marker", "window"] = "now"
    marker: str = ""
    first: float = 0.0
    """phase 0…1 at which the window opens"""
    last: float = 1.0
    """phase 0…1 at which it closes; less than `first`: it lies across the seam of a loop"""

    def __str__(self) -> str:
        match self.kind:
            case "marker":
                return f"marker {self.marker}"
            case "window":
                return f"window {self.first:g}..{self.last:g}"
        return self.kind


NOW, AT_END = Moment("now"), Moment("end")

Enter = float | Literal["match"]
"""phase 0…1 at which the new motion begins; `match`: at the phase of the old one (by common markers, where both have them)"""

Curve = Literal["cubic", "quintic"]
"""how what is left of the old motion dies out"""


@dataclass(frozen=True)
class ActionDefinition:
    """`drop(coins, 3)`: a name and its arguments. `raise(EVENT, WHOM)` raises an event on another actor."""

    name: str
    arguments: tuple[str | float, ...] = ()

    def __str__(self) -> str:
        said = ", ".join(one if isinstance(one, str) else f"{one:g}" for one in self.arguments)
        return f"{self.name}({said})" if said else self.name


@dataclass(frozen=True)
class Alternative:
    """One of several outcomes of a cell; what is None follows the cell. First true wins, or the weights draw."""

    to: str
    line: int
    restart: bool = False
    condition: str = ""
    """what must be true for it to be chosen, as text for `conditions.parse`; empty: always"""
    weight: float | None = None
    """its share, where the alternatives are drawn"""
    blend: float | None = None
    curve: Curve | None = None
    enter: Enter | None = None
    action: ActionDefinition | None = None


@dataclass(frozen=True)
class CellDefinition:
    """One cell as written; `to` is empty where `off` (a `-`) and where there are `alternatives`. None: as the defaults say."""

    to: str
    line: int
    restart: bool = False
    off: bool = False
    when: Moment | None = None
    blend: float | None = None
    """seconds"""
    curve: Curve | None = None
    enter: Enter | None = None
    action: ActionDefinition | None = None
    alternatives: tuple[Alternative, ...] = ()


@dataclass(frozen=True)
class Defaults:
    """What a cell does not say itself; `blend` and `buffer` in seconds."""

    when: Moment = NOW
    blend: float = 0.2
    curve: Curve = "cubic"
    buffer: float = 0.3
