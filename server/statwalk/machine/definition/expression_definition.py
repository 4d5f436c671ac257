"""Expressions of a machine (EX1): assignments to channels of joints, to weights of morph targets and to free
variables.

    gear_b.rotate_z = -(10/8) * gear_a.rotate_z

A channel is a joint's name, a dot, and `rotate_x`, `trans_y`, `scale_z` or another of CHANNELS: the joint's
local Euler angles in degrees (about X first, then Y, then Z), its local translation in metres, its scale; or
`length`, its distance to its child in metres. Or the name of a morph target, and `weight`.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from statwalk.maths.formula.assignments import Assignment

ANGLES = tuple(f"rotate_{axis}" for axis in "xyz")
CHANNELS = (*ANGLES, *(f"{kind}_{axis}" for kind in ("trans", "scale") for axis in "xyz"))
"""the channels of a joint"""
LENGTH = "length"
"""the distance from a joint to its child, which is told by the child's translation"""
WEIGHT = "weight"
"""the channel of a morph target"""
FRAME, TIME = "frameid", "time"
CLOCKS = (FRAME, TIME)
"""built-in variables: the number of the stage's tick, and seconds; neither can be set"""


@dataclass(frozen=True)
class ExpressionMotion:
    """A pose driven by expressions, as a state's motion: the pose at rest with some channels set; `time` is
    the time in the motion.
    """

    assignments: tuple[Assignment, ...]
    line: int


def channel_of_name(name: str) -> tuple[str, str] | None:
    """Returns joint and channel of `gear_a.rotate_z`, or morph target and channel of `smile.weight`; None:
    the name has no channel.
    """
    owner, dot, channel = name.rpartition(".")
    return (owner, channel) if dot and channel in (*CHANNELS, LENGTH, WEIGHT) else None


def free_variables(assignments: Iterable[Assignment]) -> tuple[str, ...]:
    """Returns the names that assignments set and that are no channels."""
    return tuple(line.target for line in assignments if channel_of_name(line.target) is None)
