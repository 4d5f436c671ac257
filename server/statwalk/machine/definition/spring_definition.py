"""The `springs:` of a machine as written (KF9, follow-through): joints that lag behind their motion, and
settle.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class SpringDefinition:
    """A joint whose far end hangs on a spring; `below`: all joints below it too."""

    line: int
    half_life: float
    """seconds in which the swing halves"""
    frequency: float = 0.0
    """swings per second; 0: it comes back without swinging past (critically damped)"""
    weight: float = 1.0
    """0…1 the part of the swing that is shown"""
    below: bool = False
