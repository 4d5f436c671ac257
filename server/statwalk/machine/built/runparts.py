"""What the machine as run is made of: outcomes of cells, layers, senses, colliders, and the numbers that stand for what is no state."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, NamedTuple

from statwalk.machine.conditions.program import Program

BLANK, OFF, UNDEFINED, MIXED = -1, -2, -3, -4
"""targets that are no state: nothing stands there, a `-`, a name that is no state, several outcomes (see `alternatives`)"""
NOW, AT_END, AT_MARKER, IN_WINDOW = range(4)
CURVES = ("cubic", "quintic")
"""the curves by their numbers"""
MATCH = -2.0
"""in place of the phase at which a motion is entered: at that of the old one"""
MEASURED = ("speed", "turning", "height", "phase", "time")
"""what conditions may ask of an actor beside its parameters, where none of them has that name"""


class Outcome(NamedTuple):
    """One thing that a cell can lead to."""

    target: int
    """row of the table, or UNDEFINED"""
    restart: bool
    blend: float
    """seconds"""
    curve: int
    enter: float
    """phase 0…1 at which the new motion begins, or MATCH"""
    action: int
    """row of `actions`, -1 none"""
    to: str
    """the target as written"""
    resume: int = -1
    """row of `histories`: the inner state left last is meant, once one was left; -1 none"""
    condition: Program | None = None
    said: str = ""
    """the condition as written"""
    weight: float | None = None
    """its share, where the outcomes are drawn"""


@dataclass(frozen=True)
class Parameter:
    """A named number that the outside sets, its bounds, and the seconds in which a new value is reached."""

    name: str
    default: float
    minimum: float
    maximum: float
    smooth: float = 0.0


@dataclass(frozen=True)
class Key:
    """What a key sends: `press` when it goes down (kept down where `hold`), `release` when it comes up."""

    press: str | None
    release: str | None
    hold: bool


@dataclass(frozen=True)
class Layer:
    """A table of its own on the same character: the joints that it moves (each with all below it; none: all), and how much."""

    name: str
    mode: Literal["override", "additive"] = "override"
    mask: tuple[str, ...] = ()
    weight: float = 1.0
    weight_parameter: int = -1
    """row of `parameters` that gives the weight, -1 none"""


class Sense(NamedTuple):
    """A condition that raises an event when it becomes true, and again only after `release` was (None: after it was false)."""

    event: int
    when: Program
    release: Program | None
    said: str
    """the condition as written"""


class Touch(NamedTuple):
    """A pair of colliders that raises an event."""

    event: int
    own: str
    other: str
    on: Literal["enter", "stay", "leave"]


class Collider(NamedTuple):
    """What can be touched, as in `ColliderDefinition`. Metres."""

    name: str
    kind: Literal["sphere", "plane"]
    joint: str
    """empty: the root"""
    center: tuple[float, float, float]
    radius: float
    normal: tuple[float, float, float]
    line: int
