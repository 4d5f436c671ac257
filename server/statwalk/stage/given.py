"""What reaches a cast in a tick, as its machines take it: what was touched or raised in the tick before, then the entries of the log."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from statwalk.machine.ticking.step import HOLD, NOTHING, PRESS, RELEASE, TRAVEL, Inputs
from statwalk.stage.cast import Cast
from statwalk.stage.journey import presses
from statwalk.stage.meeting.raised import Notice, Raised
from statwalk.stage.past.log import LogEntry

KINDS: Mapping[str, int] = {"press": PRESS, "hold": HOLD, "release": RELEASE, "travel": TRAVEL}


class Given(NamedTuple):
    """A cast with its parameters set, what its machines are told, and what they cannot be told."""

    cast: Cast
    inputs: Inputs
    notices: tuple[Notice, ...]


class Told(NamedTuple):
    """One input: `name` is an event, of TRAVEL a state."""

    actor: int
    name: str
    kind: int
    other: int = -1


def given(cast: Cast, raised: Sequence[Raised], entries: Sequence[LogEntry], dt: float) -> Given:
    """The part of all that happens which concerns one cast. What an edit has taken away is lost, not wrong."""
    if not raised and not entries and cast.machine.goal.max() < 0:
        return Given(cast, NOTHING, ())
    rows: list[tuple[int, int, int, int]] = []
    lost: list[Notice] = []
    machine = cast.role.machine
    columns = {name: column for column, name in enumerate(machine.events[:-1])}
    goals = {"": -1} | {machine.states[row]: row for row in machine.rows(0)}
    for one in _told(raised, entries):
        row, column = cast.row(one.actor), (goals if one.kind == TRAVEL else columns).get(one.name)
        if row >= 0 and column is not None:
            rows.append((row, column, one.kind, one.other))
        elif row >= 0:
            what = "state" if one.kind == TRAVEL else "event"
            lost.append(Notice(one.actor, one.name, one.other, f"{cast.role.name} has no {what} {one.name}"))
    rows += presses(cast, rows, dt)
    return Given(_settled(cast, entries), Inputs(*np.array(rows, np.int64).reshape(-1, 4).T), tuple(lost))


def _told(raised: Iterable[Raised], entries: Iterable[LogEntry]) -> Iterable[Told]:
    """All inputs, in the order in which they count."""
    yield from (Told(one.actor, one.event, one.kind, one.other) for one in raised)
    yield from (Told(entry.actor, entry.name, KINDS[entry.kind]) for entry in entries if entry.kind in KINDS)


def _settled(cast: Cast, entries: Iterable[LogEntry]) -> Cast:
    """With parameters as the entries say; a value beyond the bounds, which an edit may have moved, is brought back into them."""
    known = {one.name: (number, one) for number, one in enumerate(cast.role.machine.parameters)}
    found: list[tuple[int, int, float]] = []
    for entry in entries:
        if entry.kind == "set" and entry.name in known and (row := cast.row(entry.actor)) >= 0:
            number, one = known[entry.name]
            found.append((row, number, min(max(float(entry.value), one.minimum), one.maximum)))
    return cast.with_parameters(found) if found else cast
