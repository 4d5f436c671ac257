"""What operations say of cells, states, parameters …: members as the machine file has them.

A member that is left out stays as it is; null takes it away.
"""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import ConfigDict, Field, StringConstraints

from statwalk.machine.definition.cell_definition import Curve, Enter
from statwalk.machine.definition.framing import Framing
from statwalk.machine.definition.parameter_definition import Kind
from statwalk.web.schemas.base import Name, RequestModel

MOST_ENTRIES = 1_024
Words = Annotated[str, StringConstraints(max_length=400)]
Text = Annotated[str, StringConstraints(max_length=4_000)]
Point = Annotated[list[float], Field(min_length=2, max_length=2)]
Vector = Annotated[list[float], Field(min_length=3, max_length=3)]
Phases = Annotated[dict[Name, float], Field(max_length=MOST_ENTRIES)]


class Fields(RequestModel):
    """The base of all members of an entry."""

    def given(self) -> dict[str, Any]:
        """Returns the members that were sent, by their names in the file."""
        return self.model_dump(exclude_unset=True, by_alias=True)


class BlendTime(RequestModel):
    """How long a transition blends (seconds), and along which curve."""

    seconds: Annotated[float, Field(ge=0, le=60)]
    curve: Curve


BlendField = Annotated[float, Field(ge=0, le=60)] | BlendTime


class AlternativeField(RequestModel):
    """An alternative of a cell: `to` if the condition `if` is true; without `if` always."""

    model_config = ConfigDict(validate_by_name=False)

    condition: Annotated[Words, Field(alias="if")] = ""
    to: Name
    blend: BlendField = 0.0
    enter: Enter = 0.0
    action: Words = ""


class CellFields(Fields):
    """What a cell says beyond its text: `alternatives` are a list, or weights by state."""

    when: Words | None = None
    blend: BlendField | None = None
    enter: Enter | None = None
    action: Words | None = None
    off: bool | None = None
    alternatives: (
        Annotated[list[AlternativeField], Field(min_length=1, max_length=32)]
        | Annotated[dict[Name, float], Field(min_length=1, max_length=32)]
        | None
    ) = None


class BlendMotion(RequestModel):
    """A motion that blends clips over one parameter or two: the point of each clip."""

    over: Words | Annotated[list[Words], Field(min_length=1, max_length=2)]
    clips: Annotated[dict[Words, float | Point], Field(min_length=2, max_length=64)]
    markers: Annotated[dict[Words, Phases], Field(max_length=64)] = Field(default_factory=dict)


class ExpressionsMotion(RequestModel):
    """A motion that expressions drive, a line each; "": the pose at rest."""

    expressions: Text


class StateFields(Fields):
    """A state: `motion` is a clip, `none` (in layers), a blend, or expressions; `speed` a factor or a
    parameter; `ground_speed` metres a second forward, `[x, z]`, or `found`.
    """

    motion: Words | BlendMotion | ExpressionsMotion = ""
    loop: bool | None = None
    speed: float | Name | None = None
    ground_speed: float | Point | Literal["found"] | None = None
    final: bool | None = None
    framing: Framing | None = None
    resume: bool | None = None
    markers: Phases | None = None


class HandleField(RequestModel):
    """The degree of freedom of a joint at which the page has a handle for a parameter."""

    joint: Words
    freedom: Words
    event: Name = ""


class ParameterFields(Fields):
    """A parameter; `smooth` in seconds."""

    kind: Kind | None = None
    default: float | Annotated[list[float], Field(max_length=4)] | None = None
    min: float | None = None
    max: float | None = None
    smooth: float | None = None
    handle: HandleField | None = None


class SenseFields(Fields):
    """A sense: a condition with its `release`, or a `touch` of two colliders."""

    when: Words | None = None
    release: Words | None = None
    touch: Annotated[list[Name], Field(min_length=2, max_length=2)] | None = None
    on: Literal["enter", "stay", "leave"] | None = None


class KeyFields(Fields):
    """What a key sends: `press` or `hold` when it goes down, `release` when it comes up; or what it moves."""

    press: Name | None = None
    hold: Name | None = None
    release: Name | None = None
    change: Annotated[dict[Name, Phases], Field(max_length=MOST_ENTRIES)] | None = None


class ColliderFields(Fields):
    """A sphere with its radius, or a plane with its normal; metres, in the joint's space."""

    sphere: float | None = None
    plane: Vector | None = None
    joint: Words | None = None
    at: Vector | None = None
    radius: float | None = None


class LayerFields(Fields):
    """What a layer moves, how, and how much."""

    mask: Annotated[list[Words], Field(min_length=1, max_length=MOST_ENTRIES)] | None = None
    mode: Literal["override", "additive"] | None = None
    weight: float | Name | None = None


class DefaultsFields(Fields):
    """What cells take that say nothing; `buffer` in seconds."""

    when: Words | None = None
    blend: BlendField | None = None
    buffer: float | None = None


class MachineFields(Fields):
    """What a machine says of itself; `idle` is an event, `fallback` a state, `root` a joint."""

    title: Words | None = None
    description: Text | None = None
    root: Words | None = None
    idle: Name | None = None
    fallback: Name | None = None
    foot_lock: bool | float | Name | None = None
