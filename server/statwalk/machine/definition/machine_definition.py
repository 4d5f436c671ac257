"""A machine as its file defines it, with line numbers; `build` compiles it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Literal

from statwalk.errors import MachineError
from statwalk.errors import nearest as nearest
from statwalk.machine.definition.budgets_definition import BudgetDefinition
from statwalk.machine.definition.cell_definition import CellDefinition, Defaults
from statwalk.machine.definition.chain_definition import ChainDefinition
from statwalk.machine.definition.clip_definition import ClipDefinition
from statwalk.machine.definition.expression_definition import ExpressionMotion
from statwalk.machine.definition.feet_definition import ContactDefinition, FootDefinition
from statwalk.machine.definition.flock_definition import FlockDefinition
from statwalk.machine.definition.framing import Framing
from statwalk.machine.definition.ground_definition import GroundDefinition
from statwalk.machine.definition.limit_definition import LimitDefinition
from statwalk.machine.definition.parameter_definition import ParameterDefinition
from statwalk.machine.definition.sense_definition import ColliderDefinition, SenseDefinition, TouchDefinition
from statwalk.machine.definition.solver_definition import SolverDefinition
from statwalk.machine.definition.spring_definition import SpringDefinition
from statwalk.maths.formula.assignments import Assignment

END = "END"
"""the event that a motion raises when it ends; always the last column"""
ANY = "*"
"""the row and column of defaults"""
BASE = "base"
"""the layer that every machine has"""
NO_MOTION = ""
"""the motion of a layer's state that leaves the layers below unchanged (`motion: none`)"""


@dataclass(frozen=True)
class BlendDefinition:
    """A motion blended from clips over one or two parameters, their phases matched at sync markers."""

    over: tuple[str, ...]
    """one or two parameters"""
    clips: Mapping[str, tuple[float, ...]]
    """the position of each clip: one number for each parameter"""
    line: int
    markers: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    """for each clip, phases 0…1 of named markers: clips with common markers run in step"""


@dataclass(frozen=True)
class StateDefinition:
    """A state and its motion (SM1). Within a sub-machine its name is OUTER.INNER."""

    motion: str | BlendDefinition | ExpressionMotion
    line: int
    loop: bool | None = None
    """None: as the motion's file defines it"""
    speed: float | str = 1.0
    """a factor of time, or the parameter that gives it"""
    markers: Mapping[str, float] = field(default_factory=dict)
    """phases 0…1 of named markers, beside the markers of the clip"""
    composite: str = ""
    """the composite state around this one, if any"""
    final: bool = False
    """the composite state ends when the motion of this one ends"""
    framing: Framing | None = None
    """what the viewer's camera shows while an actor is in the state; None: the viewer's own choice"""
    ground_speed: tuple[float, float] | Literal["found"] | None = None
    """x, z (m/s) that the motion moves the actor over the ground, besides its root motion; found: as fast as
    the ground runs back under the feet of its clip
    """

    @property
    def clips(self) -> tuple[str, ...]:
        """Returns the names of the clips that the state plays; none for a state without motion."""
        if isinstance(self.motion, BlendDefinition):
            return tuple(self.motion.clips)
        return (self.motion,) if self.motion and isinstance(self.motion, str) else ()


@dataclass(frozen=True)
class CompositeDefinition:
    """A composite state: a row of defaults for its inner states, flattened when the file is read."""

    initial: str
    """full name of the inner state that it begins with (a composite state, if they nest)"""
    resume: bool
    """whether a transition to it resumes the inner state left last"""
    line: int
    composite: str = ""
    """the composite state around this one"""
    final: bool = False
    """the composite state around it ends when this one ends"""


@dataclass(frozen=True)
class EventDefinition:
    """An input (SM2): a column of the table, or named under `events`."""

    line: int
    buffer: float | None = None
    """seconds that the event waits in a blank cell; None: the default"""


@dataclass(frozen=True)
class KeyDefinition:
    """The inputs of a key of the viewer: `press` when it goes down (held down if `hold`), `release` when it
    comes up; or `change`: while it is down, parameters move by so many units a second. The first state that
    a layer of the actor is in counts, or `*`.
    """

    press: str | None
    release: str | None
    hold: bool
    line: int
    change: Mapping[str, Mapping[str, float]] = field(default_factory=dict)


@dataclass(frozen=True)
class PropertyDefinition:
    """A property that must be true of the table."""

    text: str
    line: int


@dataclass(frozen=True)
class LayerDefinition:
    """A second table on the same character; it shares events, parameters, senses and defaults with
    the base.
    """

    states: Mapping[str, StateDefinition]
    initial: str
    line: int
    mask: tuple[str, ...] = ()
    """joints that it moves, each with its descendants; empty: all joints"""
    mode: Literal["override", "additive"] = "override"
    weight: float | str = 1.0
    """0…1, or the parameter that gives it"""
    composites: Mapping[str, CompositeDefinition] = field(default_factory=dict)
    cells: Mapping[tuple[str, str], CellDefinition] = field(default_factory=dict)
    rows: tuple[tuple[str, ...], ...] = ()


@dataclass(frozen=True)
class MachineDefinition:
    """The behaviour that a machine file defines.

    Cells are keyed by (state, event); either may be `*`, the state may be a composite state, or `OUTER.*` for
    the `*` of a sub-machine.
    """

    name: str
    states: Mapping[str, StateDefinition]
    initial: str
    events: Mapping[str, EventDefinition] = field(default_factory=dict)
    """the inputs, in the order of the columns; END is not among them"""
    cells: Mapping[tuple[str, str], CellDefinition] = field(default_factory=dict)
    composites: Mapping[str, CompositeDefinition] = field(default_factory=dict)
    layers: Mapping[str, LayerDefinition] = field(default_factory=dict)
    """the layers above the base, from below to above"""
    defaults: Defaults = field(default_factory=Defaults)
    idle: str | None = None
    fallback: str = ""
    """the state of an actor whose own state was removed by an edit; empty: the initial state"""
    keys: Mapping[str, KeyDefinition] = field(default_factory=dict)
    parameters: Mapping[str, ParameterDefinition] = field(default_factory=dict)
    senses: Mapping[str, SenseDefinition | TouchDefinition] = field(default_factory=dict)
    """by the event that they raise"""
    colliders: Mapping[str, ColliderDefinition] = field(default_factory=dict)
    limits: Mapping[str, LimitDefinition] = field(default_factory=dict)
    """the limits of the character's joints, by joint; they replace the character's own"""
    foot_lock: float | str = 0.0
    """0…1 how much feet that stand are kept in place, or the parameter that says it; 0: no foot lock"""
    ground: tuple[GroundDefinition, ...] = ()
    """what lies on the floor where actors walk"""
    flock: FlockDefinition | None = None
    """all actors of the role fly as one flock"""
    expressions: tuple[Assignment, ...] = ()
    """sorted by dependency"""
    properties: tuple[PropertyDefinition, ...] = ()
    clips: Mapping[str, ClipDefinition] = field(default_factory=dict)
    """the clips that the file makes of the character's own"""
    springs: Mapping[str, SpringDefinition] = field(default_factory=dict)
    """by the joint on which each begins"""
    solvers: Mapping[str, SolverDefinition] = field(default_factory=dict)
    """the chains that reach for targets, by name, in the order in which they work"""
    chains: Mapping[str, ChainDefinition] = field(default_factory=dict)
    """the chains that hang under gravity, by name"""
    feet: Mapping[str, FootDefinition] = field(default_factory=dict)
    """the joints of legs, by foot, where the names of the joints do not tell them"""
    contacts: Mapping[str, Mapping[str, ContactDefinition]] = field(default_factory=dict)
    """corrected contacts with the ground, by clip and foot"""
    budgets: Mapping[str, BudgetDefinition] = field(default_factory=dict)
    """the largest figures that measuring may give, by figure"""
    rows: tuple[tuple[str, ...], ...] = ()
    """the table as written, the header first"""
    view: Mapping[str, Mapping[str, tuple[float, float]]] = field(default_factory=dict)
    """where states stand in the graph, by layer and full name; for people, never in a tick"""
    title: str = ""
    description: str = ""
    file: str = ""

    @property
    def columns(self) -> tuple[str, ...]:
        """Returns the events with END last."""
        return (*self.events, END)

    def tables(self) -> dict[str, MachineDefinition]:
        """Returns one machine for each layer, the base first: its own states, cells and rows, and everything
        that the layers share.
        """
        base = replace(self, layers={})
        above = {
            name: replace(
                base,
                states=layer.states,
                initial=layer.initial,
                cells=layer.cells,
                composites=layer.composites,
                rows=layer.rows,
                fallback="",
                properties=(),
            )
            for name, layer in self.layers.items()
        }
        return {BASE: base} | above

    def refuse(self, message: str, line: int) -> MachineError:
        """Returns the error about a line of this machine's file."""
        return MachineError(message, file=self.file, place=f"line {line}" if line else "")
