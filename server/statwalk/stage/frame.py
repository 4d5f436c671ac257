"""What a tick shows: the poses of all actors, and what happened in it. Immutable; made for whoever sends or draws it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.pose import Pose
from statwalk.stage.role import Role


class Action(NamedTuple):
    """An output of the machine (SM5); `seq` counts all actions of a stage from 1."""

    seq: int
    tick: int
    actor: int
    name: str
    arguments: tuple[str | float, ...] = ()
    other: int = -1
    """id of the actor that was touched, or raised the event; -1 nobody"""


class Verdict(NamedTuple):
    """What became of an event, and why: taken, waits or dropped."""

    tick: int
    actor: int
    layer: int
    event: str
    verdict: str
    reason: str
    from_state: str
    to_state: str
    """empty where the state did not change"""
    cell: tuple[str, str] | None = None
    """row and column of the cell as it is written, None where none stands there"""
    source: str = ""
    """what kind of a cell that is: of the state itself, or a default"""
    line: int = 0
    """of the machine file"""
    values: tuple[tuple[str, float], ...] = ()
    """what its condition saw"""
    other: int = -1
    """id of the actor that was touched, or raised the event; -1 nobody"""


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
    """(n, L) 1…0: how much of the transition is left"""


class Frame(NamedTuple):
    """One tick of a stage."""

    tick: int
    hash: str
    casts: tuple[CastFrame, ...]
    actions: tuple[Action, ...]
    verdicts: tuple[Verdict, ...]
