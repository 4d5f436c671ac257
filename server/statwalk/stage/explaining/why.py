"""Why: what became of every event of a tick, which cell decided it, what that cell saw, and which joints it set in motion."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from statwalk.errors import StageError, UnknownNameError
from statwalk.machine.built.runparts import CURVES
from statwalk.machine.ticking.step import StepResult
from statwalk.maths.vector import length
from statwalk.motion import inertialize
from statwalk.stage.cast import Cast
from statwalk.stage.fold import StageState, forward, stepping
from statwalk.stage.frame import Verdict
from statwalk.stage.moving.posing import ahead
from statwalk.stage.past.timeline import Timeline

MOST_JOINTS = 5
DEGREES_A_MILLIMETRE = 0.1
"""how much a joint has moved when it has turned and shifted: a tenth of a degree is a millimetre at the end of a limb of 57 cm"""


class Moved(NamedTuple):
    """A joint, and how far what was shown lies from the motion that begins: what the transition has to bring about."""

    joint: str
    degrees: float
    millimetres: float


class Explained(NamedTuple):
    """What became of one event."""

    event: str
    layer: int
    verdict: str
    """taken, waits or dropped"""
    reason: str
    cell: tuple[str, str] | None
    """row and column as written"""
    source: str
    """what kind of a cell that is"""
    line: int
    """of the machine file"""
    values: tuple[tuple[str, float], ...]
    """what its condition saw"""
    other: int
    from_state: str
    to_state: str
    blend_seconds: float | None
    """None where no motion began"""
    curve: str
    joints: tuple[Moved, ...]
    """those that the transition moves most, the one that it moves most first"""


class Why(NamedTuple):
    """What happened to an actor in a tick. `states`: in each layer; `since`: the tick in which each was entered."""

    tick: int
    actor: int
    states: tuple[str, ...]
    since: tuple[int, ...]
    events: tuple[Explained, ...]


def why(stage: Timeline, actor: int, tick: int) -> Why:
    """What happened to an actor in a tick from `first` to `head`, worked out again from the log; the playhead stays where it is.

    Raises StageError where that tick is not there, UnknownNameError where the actor is not.
    """
    state = stage.state_at(tick)
    found = state.find(actor)
    if found is None:
        raise UnknownNameError("actor", str(actor), [str(one) for cast in state.casts for one in cast.ids])
    cast, row = found
    machine = cast.role.machine
    states = tuple(machine.states[one] for one in cast.machine.state[row])
    since = tuple(tick - int(age) for age in cast.machine.age[row])
    return Why(tick, actor, states, since, tuple(_events(stage, actor, tick)) if tick > 0 else ())


def _events(stage: Timeline, actor: int, tick: int) -> Iterator[Explained]:
    """All events of the actor, in order."""
    before, entries, dt = stage.state_at(tick - 1), stage.entries(tick), 1 / stage.rate
    _, stepped = stepping(before, entries, dt, stage.seed)
    begun = {}
    for cast, done in stepped:
        if (row := cast.row(actor)) >= 0:
            begun = _begun(before, actor, cast, done, row)
    for one in forward(before, entries, dt, stage.seed).verdicts:
        if one.actor == actor:
            yield _explained(one, begun)


Beginning = tuple[float, str, tuple[Moved, ...]]


def _begun(before: StageState, actor: int, cast: Cast, done: StepResult, row: int) -> dict[tuple[int, str], Beginning]:
    """Blend, curve and joints for each layer and event that began a motion; only the last one of a layer came to be shown."""
    changes, events = done.changes, cast.role.machine.events
    found: dict[tuple[int, str], Beginning] = {}
    for number in np.flatnonzero(changes.actor == row)[::-1].tolist():
        layer, event = int(changes.layer[number]), events[changes.event[number]]
        if (layer, event) in found:
            continue
        shown = all(key[0] != layer for key in found)
        joints = _joints(before, actor, cast, row) if shown else ()
        found[layer, event] = float(changes.blend[number]), CURVES[changes.curve[number]], joints
    return found


def _joints(before: StageState, actor: int, cast: Cast, row: int) -> tuple[Moved, ...]:
    """The joints whose pose lies farthest from what was shown in the tick before."""
    old = before.find(actor)
    if old is None:
        raise StageError(f"actor {actor} was not there in the tick before")
    was, place = old
    rows = np.array([row])
    new = ahead(cast.role, cast.machine.take(rows), 0.0)
    offset = inertialize.difference(was.shown.take(np.array([place])), new)[0].astype(np.float64)
    names = cast.role.character.skeleton.names
    shift, turn = offset[: 3 * len(names)].reshape(-1, 3), offset[3 * len(names) : 6 * len(names)].reshape(-1, 3)
    degrees, millimetres = np.degrees(length(turn)), 1000 * length(shift)
    order = np.argsort(-(degrees + DEGREES_A_MILLIMETRE * millimetres), kind="stable")
    found = (Moved(names[joint], round(float(degrees[joint]), 3), round(float(millimetres[joint]), 3)) for joint in order[:MOST_JOINTS])
    return tuple(one for one in found if one.degrees or one.millimetres)


def _explained(one: Verdict, begun: dict[tuple[int, str], Beginning]) -> Explained:
    """A verdict, with what its cell brought about."""
    has_begun = one.verdict == "taken" and (one.layer, one.event) in begun
    blend, curve, joints = begun[one.layer, one.event] if has_begun else (None, "", ())
    place = (one.cell, one.source, one.line, one.values, one.other, one.from_state, one.to_state)
    return Explained(one.event, one.layer, one.verdict, one.reason, *place, blend, curve, joints)
