"""A frame, what a stage shows at a tick: the poses of all actors, and the events of the tick.

Frames are immutable; they are sent or drawn.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.character.role import Role
from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.pose import Pose


class Action(NamedTuple):
    """An output of a machine (SM5); `seq` counts all actions of a stage from 1."""

    seq: int
    tick: int
    actor: int
    name: str
    arguments: tuple[str | float, ...] = ()
    other: int = -1
    """id of the actor that was touched, or raised the event; -1 none"""


class Verdict(NamedTuple):
    """What became of an event (taken, waits or dropped), and why."""

    tick: int
    actor: int
    layer: int
    event: str
    verdict: str
    reason: str
    from_state: str
    to_state: str
    """empty if the state did not change"""
    cell: tuple[str, str] | None = None
    """row and column of the cell as authored, None if no cell is authored there"""
    source: str = ""
    """kind of the cell: of the state itself, or a default"""
    line: int = 0
    """line of the cell in the machine file"""
    values: tuple[tuple[str, float], ...] = ()
    """name and value of each variable that the conditions have read"""
    other: int = -1
    """id of the actor that was touched, or raised the event; -1 none"""


class CastFrame(NamedTuple):
    """The n actors that share a role; L layers."""

    role: Role
    ids: NDArray[np.int64]
    """(n,)"""
    pose: Pose
    """(n, …) local, float32; without the root"""
    root_position: Floats
    """(n, 3) metres, float64"""
    heading: Floats
    """(n,) radians about +Y, float64"""
    state: Ints
    """(n, L) rows of the table"""
    phase: Floats
    """(n, L) 0…1 of the motion"""
    blend: Floats
    """(n, L) 1…0: the share of the transition that is left"""


class Frame(NamedTuple):
    """One tick of a stage."""

    tick: int
    hash: str
    casts: tuple[CastFrame, ...]
    actions: tuple[Action, ...]
    verdicts: Sequence[Verdict]
