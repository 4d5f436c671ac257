"""Commands: all input of a stage from outside. A stage follows from its log of commands alone.

Inputs (Press, Hold, Release, Set, Travel) count in the step that makes their tick. Add, Remove and Edit count
at the end of their tick: the tick is shown with the actor added or removed, or with the new version of the
role.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Add:
    """Adds an actor."""

    actor: int
    name: str
    role: str
    """key of the role: its name, or `name@version`"""
    position: tuple[float, float, float]
    """metres"""
    heading: float
    """radians about +Y, to the left"""


@dataclass(frozen=True)
class Remove:
    """Removes an actor."""

    actor: int


@dataclass(frozen=True)
class Press:
    """Sends an event once."""

    actor: int
    event: str


@dataclass(frozen=True)
class Hold:
    """Holds an event down: it counts again at every END and in every new state."""

    actor: int
    event: str


@dataclass(frozen=True)
class Release:
    """Releases an event that is held."""

    actor: int
    event: str


@dataclass(frozen=True)
class Set:
    """Sets a parameter."""

    actor: int
    parameter: str
    value: float


@dataclass(frozen=True)
class Travel:
    """Makes an actor travel to a state of its base layer; the empty name cancels travelling."""

    actor: int
    state: str


@dataclass(frozen=True)
class Edit:
    """Replaces a role by a new version."""

    name: str
    """of the role"""
    role: str
    """key of the new version, `name@version`"""
    text: str
    """the machine file of the new version"""


EventInput = Press | Hold | Release
Input = EventInput | Set | Travel
Command = Input | Add | Remove | Edit


@dataclass(frozen=True)
class LogEntry:
    """One command in the log of a stage."""

    number: int
    """sequence number, rising in the order of the commands"""
    tick: int
    command: Command

    @property
    def actor(self) -> int:
        """The id of the command's actor; 0 for an Edit, which concerns a whole role."""
        return 0 if isinstance(self.command, Edit) else self.command.actor
