"""What a tick brings about: motions that start, verdicts on events, actions; and an event that waits."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple


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


class Action(NamedTuple):
    """An output of a cell (SM5)."""

    tick: int
    actor: int
    name: str


@dataclass(eq=False)
class Waiting:
    """An event in the queue; `until`: the tick in which its buffer has run out, NEW or FOREVER."""

    event: int
    until: int
    held: bool = False


@dataclass
class Record:
    """What a tick has brought about, for all actors, in order."""

    changes: list[Change] = field(default_factory=list)
    verdicts: list[Verdict] = field(default_factory=list)
    actions: list[Action] = field(default_factory=list)
