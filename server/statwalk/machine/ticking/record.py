"""What a tick brings about: motions that start, verdicts on events, actions; and an event that waits."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray


class Verdict(NamedTuple):
    """What became of an event, and why. Numbers are rows of the machine; `actor` is a row of the batch."""

    tick: int
    actor: int
    layer: int
    event: int
    verdict: str
    """taken, waits or dropped"""
    reason: str
    from_state: int
    to_state: int
    """-1 where the state stayed"""
    cell: tuple[str, str] = ("", "")
    """row and column of the cell that decided, as written in the file; empty where none did"""
    values: tuple[tuple[str, float], ...] = ()
    """name and value of all that the cell's conditions asked for"""
    other: int = -1
    """id of the actor that was touched, or raised the event; -1 none"""


class Change(NamedTuple):
    """A motion that starts: another state, or the same one again (`restart`). `blend` and `time` (into the new motion) in seconds."""

    actor: int
    layer: int
    from_state: int
    to_state: int
    event: int
    action: int
    blend: float
    restart: bool
    time: float
    curve: int
    """row of CURVES"""


class Action(NamedTuple):
    """An output of a cell (SM5)."""

    tick: int
    actor: int
    name: str
    arguments: tuple[str | float, ...] = ()
    other: int = -1
    """id of the actor that was touched, or raised the event; -1 none"""
    layer: int = 0


@dataclass(eq=False)
class Waiting:
    """An event in the queue; `until`: the tick in which its buffer has run out, NEW, MOMENT or FOREVER."""

    event: int
    until: int
    held: bool = False
    other: int = -1
    """as in Action"""
    slot: int = -1
    """its place in the queue at the tick before, -1 none"""
    kept: int = -1
    """its `until` then"""


@dataclass
class Record:
    """What a tick has brought about, for all actors, in order."""

    changes: list[Change] = field(default_factory=list)
    verdicts: list[Verdict] = field(default_factory=list)
    actions: list[Action] = field(default_factory=list)


class Changes(NamedTuple):
    """The motions that start in a tick, (C,) each, in the order in which they came about; an actor may stand there several times."""

    actor: NDArray[np.int64]
    layer: NDArray[np.int64]
    from_state: NDArray[np.int16]
    to_state: NDArray[np.int16]
    event: NDArray[np.int16]
    action: NDArray[np.int16]
    """row of the machine's actions, -1 none"""
    blend: NDArray[np.float32]
    """seconds"""
    restart: NDArray[np.bool_]
    """the same state began its motion again"""
    time: NDArray[np.float64]
    """seconds into the new motion"""
    curve: NDArray[np.uint8]
    """row of CURVES"""


CHANGE_KINDS = (np.int64, np.int64, np.int16, np.int16, np.int16, np.int16, np.float32, np.bool_, np.float64, np.uint8)
NO_CHANGES = Changes._make(np.zeros(0, kind) for kind in CHANGE_KINDS)
