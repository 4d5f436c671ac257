"""The `chains:` of a machine as written (SK4): chains that hang under gravity between their anchors."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class ChainDefinition:
    """A chain of joints that falls, swings and settles."""

    line: int
    joints: tuple[str, ...]
    """from start to end"""
    anchors: tuple[str, ...] = ()
    """the first joint, the last or both, which stay where the motion has them; empty: the first"""
    gravity: float = 9.81
    """m/s²"""
    half_life: float = 1.0
    """seconds in which velocities halve"""
    mass: float = 1.0
    """of the last joint; that of the others is 1"""
