"""The parts of a compiled machine: alternatives of cells, layers, senses, colliders, and the numbers for
cells that name no state.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, NamedTuple

from statwalk.machine.definition.parameter_definition import Kind
from statwalk.maths.formula.postfix import Formula

BLANK, OFF, UNDEFINED, MIXED = -1, -2, -3, -4
"""targets that are no state: an empty cell, a `-`, an unknown name, a cell with several alternatives (see
`alternatives`)
"""
NOW, AT_END, AT_MARKER, IN_WINDOW = range(4)
CURVES = ("cubic", "quintic")
"""the curves, by their numbers"""
MATCH = -2.0
"""the `enter` of a motion that begins at the phase of the old motion"""


class Alternative(NamedTuple):
    """One alternative of a cell."""

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
    """row of `histories`: the inner state left last replaces `target`, if one was left; -1 none"""
    condition: Formula | None = None
    weight: float | None = None
    """its share, if the cell draws one of its alternatives"""


@dataclass(frozen=True)
class Parameter:
    """A named number that you set from outside: its bounds, and the seconds in which it reaches a
    new value.
    """

    name: str
    default: float
    minimum: float
    maximum: float
    smooth: float = 0.0
    kind: Kind = "number"
    vector: str = ""
    """the parameter that this number is a component of; empty: none"""
    joint: str = ""
    """the joint at which the page has a handle for it; empty: none"""
    freedom: str = ""
    """the degree of freedom of that joint that the handle moves"""
    event: str = ""
    """the event that the page sends when the handle is taken; empty: none"""


@dataclass(frozen=True)
class Key:
    """The inputs of a key: `press` when it goes down (held down if `hold`), `release` when it comes up."""

    press: str | None
    release: str | None
    hold: bool


@dataclass(frozen=True)
class Layer:
    """A second table on the same character: the joints that it moves (each with its descendants; empty: all
    joints), and its weight.
    """

    name: str
    mode: Literal["override", "additive"] = "override"
    mask: tuple[str, ...] = ()
    weight: float = 1.0
    weight_parameter: int = -1
    """row of `parameters` that gives the weight, -1 none"""


class Sense(NamedTuple):
    """A condition that raises an event when it becomes true, and again only after `release` was true (None:
    after the condition was false).
    """

    event: int
    when: Formula
    release: Formula | None


class Touch(NamedTuple):
    """A pair of colliders that raises an event when they touch."""

    event: int
    own: str
    other: str
    on: Literal["enter", "stay", "leave"]


class Collider(NamedTuple):
    """A collider of an actor, as in `ColliderDefinition`. Metres."""

    name: str
    kind: Literal["sphere", "plane"]
    joint: str
    """empty: the root"""
    center: tuple[float, float, float]
    radius: float
    normal: tuple[float, float, float]
    line: int
