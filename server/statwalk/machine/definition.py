"""A machine as authored: what its file says, with line numbers; `build` makes of it what runs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from difflib import get_close_matches
from typing import Literal

from statwalk.errors import MachineError

END = "END"
"""the event that a motion raises when it ends; always the last column"""
ANY = "*"
"""the row and column of defaults"""

When = Literal["now", "end"]


@dataclass(frozen=True)
class CellDefinition:
    """One cell as written; `to` is empty where `off` (a `-`). What is None follows the machine's defaults."""

    to: str
    line: int
    restart: bool = False
    off: bool = False
    when: When | None = None
    blend: float | None = None
    """seconds"""
    action: str | None = None


@dataclass(frozen=True)
class StateDefinition:
    """A state and the motion it is tied to (SM1)."""

    motion: str
    line: int
    loop: bool | None = None
    """None: as the motion itself says"""
    speed: float | str = 1.0
    """a factor of time, or the parameter that gives it"""


@dataclass(frozen=True)
class EventDefinition:
    """An input (SM2): a column of the table, or named under `events`."""

    line: int
    buffer: float | None = None
    """seconds that it waits in a blank cell; None: the default"""


@dataclass(frozen=True)
class ParameterDefinition:
    """A named number that the outside sets."""

    default: float
    minimum: float
    maximum: float
    line: int


@dataclass(frozen=True)
class KeyDefinition:
    """What a key of the viewer sends: `press` when it goes down (kept down where `hold`), `release` when it comes up."""

    press: str | None
    release: str | None
    hold: bool
    line: int


@dataclass(frozen=True)
class PropertyDefinition:
    """A sentence that must be true of the table."""

    text: str
    line: int


@dataclass(frozen=True)
class Defaults:
    """What a cell does not say itself; `blend` and `buffer` in seconds."""

    when: When = "now"
    blend: float = 0.2
    buffer: float = 0.3


@dataclass(frozen=True)
class MachineDefinition:
    """All that a machine file says about behaviour. Cells stand under (state, event); either may be `*`."""

    name: str
    states: Mapping[str, StateDefinition]
    initial: str
    events: Mapping[str, EventDefinition] = field(default_factory=dict)
    """the inputs, in the order of the columns; END is not among them"""
    cells: Mapping[tuple[str, str], CellDefinition] = field(default_factory=dict)
    defaults: Defaults = Defaults()
    idle: str | None = None
    keys: Mapping[str, KeyDefinition] = field(default_factory=dict)
    parameters: Mapping[str, ParameterDefinition] = field(default_factory=dict)
    properties: tuple[PropertyDefinition, ...] = ()
    rows: tuple[tuple[str, ...], ...] = ()
    """the table as written, the header first"""
    title: str = ""
    description: str = ""
    file: str = ""

    @property
    def columns(self) -> tuple[str, ...]:
        """The events with END last."""
        return (*self.events, END)

    def refuse(self, message: str, line: int) -> MachineError:
        """The error about a line of this machine's file."""
        return MachineError(message, file=self.file, place=f"line {line}" if line else "")


def nearest(name: str, known: Mapping[str, object] | tuple[str, ...]) -> str:
    """`; did you mean WALK?`, or nothing where no name is near."""
    near = get_close_matches(name, list(known), n=1)
    return f"; did you mean {near[0]}?" if near else ""
