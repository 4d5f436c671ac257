"""The `flock:` of a machine as written (FL1, FAQ Q34): all actors of the role fly as one flock, in place of
the root motion of their clips.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

Point = tuple[float, float, float]


@dataclass(frozen=True)
class GoalDefinition:
    """The goal of the flock: a fixed point, or a point on a level circle around it."""

    center: Point
    """metres"""
    radius: float = 0.0
    """metres of the circle; 0: the goal stands still"""
    seconds: float = 60.0
    """of one lap, to the left"""


@dataclass(frozen=True)
class ObstacleDefinition:
    """What the flock avoids: a sphere, or the half-space behind a plane. Metres."""

    kind: Literal["sphere", "plane"]
    center: Point
    radius: float = 0.0
    normal: Point = (0.0, 1.0, 0.0)
    """of a plane: unit vector towards the free side"""


@dataclass(frozen=True)
class FlockDefinition:
    """The rules that members of a flock follow. Metres, seconds."""

    line: int
    distance: float = 1.0
    """wanted distance to the neighbours that a member sees"""
    reach: float = 5.0
    """range of sight of a member"""
    sight_deg: float = 360.0
    """the whole field of view, in degrees"""
    nearest: int = 7
    """number of neighbours that a member looks at; near neighbours hide far ones"""
    strength: float = 4.0
    """metres per second squared: scales the forces"""
    min_speed: float = 0.0
    max_speed: float = 5.0
    max_acceleration: float = 10.0
    max_turn_deg: float = 180.0
    """largest turn of the heading, in degrees per second"""
    wander: float = 0.0
    """metres per second squared of random acceleration"""
    follow: float = 0.0
    """0…1: the part of its neighbours' velocity that a member takes over"""
    formation: tuple[float, float] | None = None
    """metres beside and behind the member ahead"""
    goal: GoalDefinition | None = None
    obstacles: tuple[ObstacleDefinition, ...] = ()
    avoid: tuple[str, ...] = ()
    """colliders of actors of other roles to avoid as well, the first 64 at least"""
    sets: Mapping[str, str] = field(default_factory=dict)
    """the parameters that the flight sets, by quantity: speed, climb (metres per second), turn (radians per
    second)
    """
