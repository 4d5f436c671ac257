"""The `flock:` of a machine as authored (FL1, FAQ Q34): all actors of the role fly as one flock, in place of the way their motions go."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

Point = tuple[float, float, float]


@dataclass(frozen=True)
class GoalDefinition:
    """Where the flock would like to be: a place, or one that goes round it on the level."""

    center: Point
    """metres"""
    radius: float = 0.0
    """metres of the circle; 0: it stands still"""
    seconds: float = 60.0
    """for once round, to the left"""


@dataclass(frozen=True)
class ObstacleDefinition:
    """What is flown around: a sphere, or all that lies behind a plane. Metres."""

    kind: Literal["sphere", "plane"]
    center: Point
    radius: float = 0.0
    normal: Point = (0.0, 1.0, 0.0)
    """of a plane: unit, towards where one may fly"""


@dataclass(frozen=True)
class FlockDefinition:
    """What the members keep to. Metres, seconds."""

    line: int
    distance: float = 1.0
    """that a member would like to have to those it sees"""
    reach: float = 5.0
    """beyond it a member sees nobody"""
    sight_deg: float = 360.0
    """the whole field of view"""
    nearest: int = 7
    """so many are looked at: near ones hide far ones"""
    strength: float = 4.0
    """metres per second squared: scales the forces"""
    min_speed: float = 0.0
    max_speed: float = 5.0
    max_acceleration: float = 10.0
    max_turn_deg: float = 180.0
    """degrees per second that the heading may turn"""
    wander: float = 0.0
    """metres per second squared of chance"""
    follow: float = 0.0
    """0…1: how much of the speed of those it sees a member takes over"""
    formation: tuple[float, float] | None = None
    """metres beside and behind the one ahead"""
    goal: GoalDefinition | None = None
    obstacles: tuple[ObstacleDefinition, ...] = ()
    avoid: tuple[str, ...] = ()
    """colliders of actors of other roles that are flown around as well, the first 64 at least"""
    sets: Mapping[str, str] = field(default_factory=dict)
    """the parameters that the flight sets: of speed, climb (metres per second) and turn (radians per second)"""
