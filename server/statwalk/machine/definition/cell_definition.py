"""A cell as written: its timing, target, blend and action."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True)
class CellTiming:
    """When an event takes effect: `now`, at the `end` of the motion (or of its loop), at a `marker` of the
    motion, or in a `window` of its phase.
    """

    kind: Literal["now", "end", "marker", "window"] = "now"
    marker: str = ""
    first: float = 0.0
    """phase 0…1 at which the window opens"""
    last: float = 1.0
    """phase 0…1 at which the window closes; less than `first`: the window spans the end of a loop"""

    def __str__(self) -> str:
        match self.kind:
            case "marker":
                return f"marker {self.marker}"
            case "window":
                return f"window {self.first:g}..{self.last:g}"
        return self.kind


NOW, AT_END = CellTiming("now"), CellTiming("end")

Enter = float | Literal["match"]
"""phase 0…1 at which the new motion begins; `match`: at the phase of the old motion (by common markers, if
both have them)
"""

Curve = Literal["cubic", "quintic"]
"""the curve along which the offset from the old motion fades out"""


@dataclass(frozen=True)
class ActionDefinition:
    """`drop(coins, 3)`: a name and its arguments. `raise(EVENT, WHOM)` raises an event on another actor."""

    name: str
    arguments: tuple[str | float, ...] = ()

    def __str__(self) -> str:
        arguments = ", ".join(
            argument if isinstance(argument, str) else f"{argument:g}" for argument in self.arguments
        )
        return f"{self.name}({arguments})" if arguments else self.name


@dataclass(frozen=True)
class AlternativeDefinition:
    """One of several alternatives of a cell; None takes the value of the cell.

    The first true alternative counts, or one is drawn by weight.
    """

    to: str
    line: int
    restart: bool = False
    condition: str = ""
    """what must be true for this alternative, as text for `conditions.parse`; empty: always"""
    weight: float | None = None
    """its share, if the alternatives are drawn"""
    blend: float | None = None
    curve: Curve | None = None
    enter: Enter | None = None
    action: ActionDefinition | None = None


@dataclass(frozen=True)
class CellDefinition:
    """One cell as written; `to` is empty for a cell that is `off` (a `-`) or has `alternatives`.

    None takes the machine's default.
    """

    to: str
    line: int
    restart: bool = False
    off: bool = False
    when: CellTiming | None = None
    blend: float | None = None
    """seconds"""
    curve: Curve | None = None
    enter: Enter | None = None
    action: ActionDefinition | None = None
    alternatives: tuple[AlternativeDefinition, ...] = ()


@dataclass(frozen=True)
class Defaults:
    """The values that cells take if they define none; `blend` and `buffer` in seconds."""

    when: CellTiming = NOW
    blend: float = 0.2
    curve: Curve = "cubic"
    buffer: float = 0.3
