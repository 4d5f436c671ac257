"""The machine as run: full integer tables, one below the other for all layers, and all that cells, states and senses say beside them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Literal, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.celldefinition import ActionDefinition, Moment
from statwalk.machine.definition import BlendDefinition
from statwalk.maths.arrays import Floats

BLANK, OFF, UNDEFINED, MIXED = -1, -2, -3, -4
"""targets that are no state: nothing stands there, a `-`, a name that is no state, several outcomes (see `alternatives`)"""
NOW, AT_END, AT_MARKER, IN_WINDOW = range(4)
CURVES = ("cubic", "quintic")
"""the curves by their numbers"""
MATCH = -2.0
"""in place of the phase at which a motion is entered: at that of the old one"""
MEASURED = ("speed", "turning", "height", "phase", "time")
"""what conditions may ask of an actor beside its parameters, where none of them has that name"""


class Condition(Protocol):
    """A small program over numbers; see `machine.conditions`."""

    @property
    def variables(self) -> tuple[str, ...]:
        """The names that it asks for."""

    def evaluate(self, values: Floats) -> Floats:
        """(N,) float64, true where it is not 0, of `values` (V, N) in the order of `Machine.variables`."""


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
    condition: Condition | None = None
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
    when: Condition
    release: Condition | None
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


@dataclass(frozen=True, eq=False)
class Machine:
    """The machine as run; S states (those of the base, then those of each layer), L layers, E events of which END is the last. Seconds."""

    name: str
    states: tuple[str, ...]
    """names as in their layer"""
    events: tuple[str, ...]
    layers: tuple[Layer, ...]
    """the base first"""
    layer_of: NDArray[np.int16]
    """(S,) the layer of each state"""
    layer_concerns: NDArray[np.bool_]
    """(L, E) which layers an event goes to: those whose tables say anything about it, else the base alone"""
    initials: tuple[int, ...]
    """the state that each layer begins in"""
    target: NDArray[np.int16]
    """(S, E) the next state, or BLANK, OFF, UNDEFINED, MIXED"""
    when: NDArray[np.uint8]
    """(S, E) NOW, AT_END, AT_MARKER or IN_WINDOW"""
    restart: NDArray[np.bool_]
    """(S, E); this and the next four: of the first outcome, where there are several"""
    blend: NDArray[np.float32]
    """(S, E)"""
    curve: NDArray[np.uint8]
    """(S, E) row of CURVES"""
    enter: NDArray[np.float32]
    """(S, E) phase 0…1 at which the new motion begins, or MATCH"""
    action: NDArray[np.int16]
    """(S, E) row of `actions`, -1 none"""
    moments: Mapping[tuple[int, int], Moment]
    """the marker or window where `when` names one"""
    outcomes: Mapping[tuple[int, int], tuple[Outcome, ...]]
    """for every cell that is neither blank nor off, all that it can lead to; the first that is true counts, or one is drawn by weight"""
    sources: Mapping[tuple[int, int], tuple[str, str]]
    """where each cell stands in the file: row and column as written"""
    buffer: NDArray[np.float32]
    """(E,) how long an event waits in a blank cell"""
    motion: NDArray[np.int16]
    """(S,) row of `motions`: of a blend the first clip; -1 where a layer's state has none"""
    blends: tuple[BlendDefinition | None, ...]
    """(S,) the blend of clips that a state plays, if it plays one"""
    loop: NDArray[np.bool_]
    """(S,)"""
    duration: NDArray[np.float64]
    """(S,) of a blend the longest clip's; infinite where there is no motion"""
    markers: tuple[tuple[tuple[str, float], ...], ...]
    """(S,) name and phase 0…1 of each marker, by phase; those of a blend are its first clip's"""
    speed: NDArray[np.float64]
    """(S,) factor of time, where speed_parameter is -1"""
    speed_parameter: NDArray[np.int16]
    """(S,) row of `parameters` that gives the factor, -1 none"""
    idle: int
    """the event that stands for nobody touching anything, -1 none"""
    fallbacks: tuple[int, ...]
    """for each layer, the state of an actor whose own is gone after an edit"""
    actions: tuple[ActionDefinition, ...]
    motions: tuple[str, ...]
    keys: Mapping[str, Key]
    parameters: tuple[Parameter, ...]
    variables: tuple[str, ...]
    """the names that conditions may ask for: the parameters, then those of MEASURED that are none"""
    senses: tuple[Sense, ...]
    touches: tuple[Touch, ...]
    colliders: tuple[Collider, ...]
    histories: tuple[tuple[str, str], ...]
    """layer and name of the outer states that are resumed where they were left"""
    inside: NDArray[np.bool_]
    """(S, H) which states are part of each of them"""
    undefined: Mapping[tuple[int, int], str]
    """what the table names where the target is UNDEFINED"""

    @property
    def initial(self) -> int:
        """The state that the base begins in."""
        return self.initials[0]

    @property
    def end(self) -> int:
        """The column of END."""
        return len(self.events) - 1

    @property
    def alternatives(self) -> dict[tuple[int, int], tuple[Outcome, ...]]:
        """The cells with several outcomes (MIXED)."""
        return {place: several for place, several in self.outcomes.items() if self.target[place] == MIXED}

    def rows(self, layer: int) -> range:
        """The rows of a layer's states."""
        found = np.flatnonzero(self.layer_of == layer)
        return range(int(found[0]), int(found[-1]) + 1)

    @cached_property
    def end_matters(self) -> NDArray[np.bool_]:
        """(S,) whether END, or the idle event in its place, finds a cell with something to do."""
        at_end = self.target[:, self.end]
        idle = self.target[:, self.idle] if self.idle >= 0 else np.full(len(self.states), OFF)
        idle_acts = (idle >= 0) | (idle == MIXED)
        return np.asarray((at_end >= 0) | (at_end == UNDEFINED) | (at_end == MIXED) | ((at_end == BLANK) & idle_acts))

    @cached_property
    def targets(self) -> list[list[int]]:
        """`target` as Python numbers, for looking up one cell."""
        found: list[list[int]] = self.target.tolist()
        return found

    @cached_property
    def whens(self) -> list[list[int]]:
        """`when` as Python numbers."""
        found: list[list[int]] = self.when.tolist()
        return found
