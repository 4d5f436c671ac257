"""The parts of a machine: cells, states, layers, keys, parameters, senses, colliders."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from statwalk.machine.definition.cell_definition import Curve, Enter
from statwalk.machine.definition.framing import Framing
from statwalk.machine.definition.parameter_definition import Kind
from statwalk.web.schemas.base import Place, ResponseModel, Vector


class AlternativeView(ResponseModel):
    """An alternative of a cell; `blend` in seconds, `enter` is the phase 0…1 at which the motion begins, or
    `match`.
    """

    to: str
    condition: str
    weight: float | None
    blend: float
    curve: Curve
    enter: Enter
    restart: bool
    action: str | None


class CellView(ResponseModel):
    """A cell of the full table with its defaults resolved; `to` is null if the cell does nothing; `source`
    says which row the cell comes from. Where `alternatives` decide, `to` and `restart` are those of the
    first, and the other members what an alternative takes that says nothing.
    """

    to: str | None
    when: str
    blend: float
    curve: Curve
    enter: Enter
    restart: bool
    action: str | None
    source: str
    line: int
    written: Place
    alternatives: list[AlternativeView]


class EdgeView(ResponseModel):
    """An edge of the state graph, and the events that take it."""

    start: Annotated[str, Field(alias="from")]
    to: str
    events: list[str]


class MarkerView(ResponseModel):
    """A marker of a motion: its name, and its phase 0…1; `written`: the machine's file sets it, otherwise
    the clip has it.
    """

    name: str
    phase: float
    written: bool


class StateView(ResponseModel):
    """A state and its motion (null: none); `over`: the parameters of a blend; `duration` in seconds; `outer`:
    the composite state that contains it, or empty.
    """

    name: str
    motion: str | None
    over: list[str]
    clips: list[str]
    points: dict[str, list[float]]
    """where each clip of a blend stands: a number for each parameter of `over`"""
    clip_markers: dict[str, list[MarkerView]]
    """the markers of each clip of a blend, by phase"""
    speed: float | str
    """a factor of time, or the parameter that gives it"""
    ground_speed: tuple[float, float] | Literal["found"] | None
    """x, z (m/s) that the motion moves the actor over the ground, besides its root motion; found: as fast as
    the ground runs back under the feet of its clip
    """
    loop: bool
    duration: float
    outer: str
    final: bool
    framing: Framing | None
    """what the viewer's camera shows while an actor is in the state; null: the viewer's own choice"""
    markers: list[MarkerView]
    expressions: list[str]
    """of a motion that expressions drive, in the order in which they run"""


class CompositeView(ResponseModel):
    """A composite state, a machine within a state: the inner state that it begins with, and whether a
    transition to it resumes the inner state left last; `outer`, `final` as of a state.
    """

    name: str
    initial: str
    resume: bool
    outer: str
    final: bool


class LayerView(ResponseModel):
    """A layer and its table; `weight` is a number or a parameter's name; `rows` is the table as it is
    written: the head, then a row for each state.
    """

    name: str
    mode: Literal["override", "additive"]
    mask: list[str]
    weight: float | str
    initial: str
    states: list[StateView]
    composites: list[CompositeView]
    table: dict[str, dict[str, CellView]]
    rows: list[list[str]]
    edges: list[EdgeView]


class DefaultsView(ResponseModel):
    """What cells take that say nothing: when they fire, the seconds and the curve of their blend; `buffer`:
    seconds that an event waits in a blank cell.
    """

    when: str
    blend: float
    curve: Curve
    buffer: float


class KeyView(ResponseModel):
    """The events of a key: `press` when it goes down (`hold`: held until it comes up), `release` when it
    comes up. `change`: by state, the parameters that move while it is down, units a second; the first state
    that a layer of the actor is in counts, or `*`.
    """

    press: str | None
    release: str | None
    hold: bool
    change: dict[str, dict[str, float]]


class ParameterView(ResponseModel):
    """A number that clients set; `smooth` in seconds; `driven`: a flock overwrites it; `vector`: the point,
    direction or rotation that it is a component of (empty: none); `joint`, `freedom`: the degree of freedom
    at which the page has a handle for it, and the event that the page sends when you take it (empty: none).
    """

    name: str
    default: float
    minimum: float
    maximum: float
    smooth: float
    kind: Kind
    vector: str
    joint: str
    freedom: str
    event: str
    driven: bool


class TouchView(ResponseModel):
    """An event that a touch raises; `touch` names the machine's own collider, and the other collider."""

    touch: Place
    on: Literal["enter", "stay", "leave"]


class ThresholdView(ResponseModel):
    """An event that a condition raises; it raises the event again only after `release` was true."""

    when: str
    release: str


SenseView = TouchView | ThresholdView


class GroundView(ResponseModel):
    """A rectangle of uneven ground between two corners x z, metres; `heights`: at x0 z0, x1 z0, x1 z1,
    x0 z1.
    """

    corner: list[float]
    opposite: list[float]
    heights: list[float]


class ColliderView(ResponseModel):
    """A collider in metres, in the joint's space (no joint: the root's)."""

    kind: Literal["sphere", "plane"]
    line: int
    joint: str
    center: Vector
    radius: float
    normal: Vector
