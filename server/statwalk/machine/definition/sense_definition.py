"""What a character senses: thresholds, touches, and the colliders that touch."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True)
class SenseDefinition:
    """A threshold that raises an event when its condition becomes true, and again only after `release` was
    true.
    """

    when: str
    release: str
    """empty: when `when` is false"""
    line: int


@dataclass(frozen=True)
class TouchDefinition:
    """A pair of colliders that raises an event: one of this machine, and one of any actor on the stage
    (perhaps of the same name).
    """

    own: str
    other: str
    on: Literal["enter", "stay", "leave"]
    line: int


@dataclass(frozen=True)
class ColliderDefinition:
    """A sphere or a plane that rides on a joint (or on the root) and can be touched.

    Metres, in the joint's space.
    """

    kind: Literal["sphere", "plane"]
    line: int
    joint: str = ""
    """empty: the root of the actor"""
    center: tuple[float, float, float] = (0.0, 0.0, 0.0)
    radius: float = 0.0
    """of a sphere; of a plane: of its disc, 0 for an endless plane"""
    normal: tuple[float, float, float] = (0.0, 0.0, 1.0)
    """of a plane: towards its front"""
