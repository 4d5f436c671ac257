"""The lines of a stage's log, `GET /api/stages/{id}/log`: a header, then one line for each command."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from statwalk.web.schemas.base import ResponseModel, Vector


class LogHeader(ResponseModel):
    """The first line: which stage the commands make, and how far it went."""

    statwalk: Literal["log"]
    semantics: int
    engine: int
    """the number of the engine that played the log; another one refuses it"""
    version: str
    """of statwalk"""
    seed: int
    rate: int
    """ticks a second"""
    head: int
    """the newest tick"""
    hash: str
    """of the state at the head: a replay must come to it"""


class _Line(ResponseModel):
    number: int
    """sequence number of the command"""
    tick: int
    """the tick in which the command counts"""


class AddLine(_Line):
    """An actor comes."""

    kind: Literal["add"]
    actor: int
    name: str
    role: str
    position: Vector
    """metres"""
    heading: float
    """radians about +Y, to the left"""


class RemoveLine(_Line):
    """An actor leaves."""

    kind: Literal["remove"]
    actor: int


class EventLine(_Line):
    """An event of an actor: sent once, held down, or let go."""

    kind: Literal["press", "hold", "release"]
    actor: int
    event: str


class SetLine(_Line):
    """A parameter gets a value."""

    kind: Literal["set"]
    actor: int
    parameter: str
    value: float


class TravelLine(_Line):
    """An actor sets out for a state; an empty state ends the travel."""

    kind: Literal["travel"]
    actor: int
    state: str


class EditLine(_Line):
    """A machine gets another version."""

    kind: Literal["edit"]
    name: str
    """of the machine"""
    role: str
    """`name@version`"""
    text: str
    """the machine file"""


LogLine = Annotated[
    AddLine | RemoveLine | EventLine | SetLine | TravelLine | EditLine, Field(discriminator="kind")
]
