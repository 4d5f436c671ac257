"""A machine as authored: what its file says, with line numbers; `build` makes of it what runs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Literal

from statwalk.errors import MachineError
from statwalk.errors import nearest as nearest
from statwalk.machine.authored.celldefinition import CellDefinition, Defaults
from statwalk.machine.authored.flockdefinition import FlockDefinition

END = "END"
"""the event that a motion raises when it ends; always the last column"""
ANY = "*"
"""the row and column of defaults"""
BASE = "base"
"""the layer that every machine has"""
NO_MOTION = ""
"""the motion of a layer's state that leaves the layers below as they are (`motion: none`)"""


@dataclass(frozen=True)
class BlendDefinition:
    """A motion blended of clips over one or two parameters, their phases matched at sync markers."""

    over: tuple[str, ...]
    """one or two parameters"""
    clips: Mapping[str, tuple[float, ...]]
    """for each clip where it stands: one number for each parameter"""
    line: int
    markers: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    """for each clip, phases 0…1 of named moments: the clips run in step where they have some in common"""


@dataclass(frozen=True)
class StateDefinition:
    """A state and the motion it is tied to (SM1). Within a sub-machine its name is OUTER.INNER."""

    motion: str | BlendDefinition
    line: int
    loop: bool | None = None
    """None: as the motion itself says"""
    speed: float | str = 1.0
    """a factor of time, or the parameter that gives it"""
    markers: Mapping[str, float] = field(default_factory=dict)
    """phases 0…1 of named moments, beside those that the clip has"""
    outer: str = ""
    """the state this one is part of, if any"""
    final: bool = False
    """when its motion ends, so does that of the outer state"""

    @property
    def clips(self) -> tuple[str, ...]:
        """The names of the clips that it plays; none where it has no motion."""
        if isinstance(self.motion, BlendDefinition):
            return tuple(self.motion.clips)
        return (self.motion,) if self.motion else ()


@dataclass(frozen=True)
class OuterDefinition:
    """A state that is a machine itself: a row of defaults for its inner states, flattened when the file is read."""

    initial: str
    """full name of the inner state that it begins with (an outer one's, where they nest)"""
    resume: bool
    """coming back leads to the inner state that was left last"""
    line: int
    outer: str = ""
    """the outer state around this one"""
    final: bool = False
    """when it ends, so does the outer state around it"""


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
    smooth: float = 0.0
    """seconds in which a new value is reached, without a jump in value or rate; 0: at once"""


@dataclass(frozen=True)
class SenseDefinition:
    """A threshold that raises an event when its condition becomes true, and again only after `release` was true."""

    when: str
    release: str
    """empty: when `when` is false"""
    line: int


@dataclass(frozen=True)
class TouchDefinition:
    """A pair of colliders that raises an event: one of this machine's, and one of any actor's on the stage (perhaps the same name)."""

    own: str
    other: str
    on: Literal["enter", "stay", "leave"]
    line: int


@dataclass(frozen=True)
class ColliderDefinition:
    """What can be touched: a sphere or a plane that rides on a joint (or on the root). Metres, in the joint's space."""

    kind: Literal["sphere", "plane"]
    line: int
    joint: str = ""
    """empty: the root of the actor"""
    center: tuple[float, float, float] = (0.0, 0.0, 0.0)
    radius: float = 0.0
    """of a sphere; of a plane: of the disc that counts, 0 for an endless one"""
    normal: tuple[float, float, float] = (0.0, 0.0, 1.0)
    """of a plane: the side that is in front"""


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
class LayerDefinition:
    """Another table that runs beside the first on the same character; it shares events, parameters, senses and defaults."""

    states: Mapping[str, StateDefinition]
    initial: str
    line: int
    mask: tuple[str, ...] = ()
    """joints that it moves, each with all below it; empty: all"""
    mode: Literal["override", "additive"] = "override"
    weight: float | str = 1.0
    """0…1, or the parameter that gives it"""
    outers: Mapping[str, OuterDefinition] = field(default_factory=dict)
    cells: Mapping[tuple[str, str], CellDefinition] = field(default_factory=dict)
    rows: tuple[tuple[str, ...], ...] = ()


@dataclass(frozen=True)
class MachineDefinition:
    """All that a machine file says about behaviour.

    Cells stand under (state, event); either may be `*`, the state may be an outer one, or `OUTER.*` for the `*` of a sub-machine.
    """

    name: str
    states: Mapping[str, StateDefinition]
    initial: str
    events: Mapping[str, EventDefinition] = field(default_factory=dict)
    """the inputs, in the order of the columns; END is not among them"""
    cells: Mapping[tuple[str, str], CellDefinition] = field(default_factory=dict)
    outers: Mapping[str, OuterDefinition] = field(default_factory=dict)
    layers: Mapping[str, LayerDefinition] = field(default_factory=dict)
    """those beside the base layer, from below to above"""
    defaults: Defaults = field(default_factory=Defaults)
    idle: str | None = None
    fallback: str = ""
    """the state of an actor whose own is gone after an edit; empty: the initial one"""
    keys: Mapping[str, KeyDefinition] = field(default_factory=dict)
    parameters: Mapping[str, ParameterDefinition] = field(default_factory=dict)
    senses: Mapping[str, SenseDefinition | TouchDefinition] = field(default_factory=dict)
    """by the event that they raise"""
    colliders: Mapping[str, ColliderDefinition] = field(default_factory=dict)
    flock: FlockDefinition | None = None
    """all actors of the role fly as one flock"""
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

    def tables(self) -> dict[str, MachineDefinition]:
        """One machine for each layer, the base first: its states, cells and rows, and all that they share."""
        alone = replace(self, layers={})
        others = {
            name: replace(
                alone, states=one.states, initial=one.initial, cells=one.cells, outers=one.outers, rows=one.rows, fallback="", properties=()
            )
            for name, one in self.layers.items()
        }
        return {BASE: alone} | others

    def refuse(self, message: str, line: int) -> MachineError:
        """The error about a line of this machine's file."""
        return MachineError(message, file=self.file, place=f"line {line}" if line else "")
