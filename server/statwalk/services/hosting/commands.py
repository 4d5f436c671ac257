"""The commands that a stage takes from its clients, the setup of a new stage, and who acts; plain data."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

ClockKind = Literal["real", "manual"]
"""`real`: the ticker moves the stage; `manual`: only `Step` and `StepTo` move it"""
EventKind = Literal["press", "hold", "release"]


@dataclass(frozen=True)
class AddActor:
    """Adds an actor that plays a machine; `position` in metres, `heading` in radians about +Y."""

    machine: str
    position: tuple[float, float, float] = (0.0, 0.0, 0.0)
    heading: float = 0.0
    name: str | None = None


@dataclass(frozen=True)
class RemoveActor:
    """Removes an actor; its past stays in the log."""

    actor: int


@dataclass(frozen=True)
class SendEvent:
    """Sends an event to one actor, or (None) to all actors whose machines have the event."""

    event: str
    actor: int | None = None
    kind: EventKind = "press"


@dataclass(frozen=True)
class SetParameter:
    """Sets a parameter of one actor, or (None) of all actors whose machines have the parameter."""

    parameter: str
    value: float | Sequence[float]
    """a list for a point, direction or rotation"""
    actor: int | None = None


@dataclass(frozen=True)
class TravelTo:
    """Sends an actor to a state by the fastest path of events; an empty `state` cancels the travel."""

    actor: int
    state: str


Command = AddActor | RemoveActor | SendEvent | SetParameter | TravelTo


@dataclass(frozen=True)
class StageSetup:
    """A stage to open: `rate` in ticks a second; `seed` None means the scene's seed, or 0 without a scene."""

    seed: int | None = None
    rate: int = 60
    clock: ClockKind = "real"
    actors: tuple[AddActor, ...] = ()
    scene: str | None = None
    keep_running: bool = False
    """also while nobody uses it"""
    name: str = ""
    """what people call it"""


@dataclass(frozen=True)
class Doer:
    """Who acts on the clock of a stage: a name for people, and the number of the viewer; None: a program."""

    name: str = "a program"
    viewer: int | None = None


PROGRAM = Doer()
