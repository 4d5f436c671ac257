"""Why: the verdict on every event of a tick, the cell that decided it, the values that its conditions read,
and the joints that the transition moves.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from statwalk.errors import StageError, UnknownNameError
from statwalk.machine.compile.alternatives import CURVES
from statwalk.maths.vector import length
from statwalk.motion import inertialize
from statwalk.stage.effects.effects import Effects
from statwalk.stage.history.timeline import Timeline
from statwalk.stage.state.cast import Cast
from statwalk.stage.state.frame import Verdict
from statwalk.stage.state.stage_state import StageState
from statwalk.stage.steps.sample import poses_ahead

MOST_JOINTS = 5
DEGREES_A_MILLIMETRE = 0.1
"""weight of a shift in the order of joints by movement: a tenth of a degree for a millimetre, the arc at the
end of a limb of 57 cm
"""


class Moved(NamedTuple):
    """A joint, and the distance between its pose in the tick before and in the new motion, which the
    transition has to bridge.
    """

    joint: str
    degrees: float
    millimetres: float


class Explained(NamedTuple):
    """The explanation of one event."""

    event: str
    layer: int
    verdict: str
    """taken, waits or dropped"""
    reason: str
    cell: tuple[str, str] | None
    """row and column as authored"""
    source: str
    """kind of the cell"""
    line: int
    """line of the cell in the machine file"""
    values: tuple[tuple[str, float], ...]
    """name and value of each variable that the conditions have read"""
    other: int
    from_state: str
    to_state: str
    blend_seconds: float | None
    """None if no motion began"""
    curve: str
    joints: tuple[Moved, ...]
    """the joints that the transition moves most, in this order"""


class Why(NamedTuple):
    """The events of an actor in a tick.

    `states`: in each layer; `since`: the tick in which each state was entered.
    """

    tick: int
    actor: int
    states: tuple[str, ...]
    since: tuple[int, ...]
    events: tuple[Explained, ...]


def why(stage: Timeline, actor: int, tick: int) -> Why:
    """Returns what happened to an actor in a tick from `first` to `head`, recomputed from the log; the
    playhead does not move.

    :raises StageError: when the stage does not have the tick.
    :raises UnknownNameError: when the actor does not exist at the tick.
    """
    stage.check(tick)
    before = stage.state_at(max(tick - 1, 0))
    state, effects = stage.after(before.copy()) if tick > 0 else (before, Effects())
    place = state.find(actor)
    if place is None:
        raise UnknownNameError("actor", str(actor), map(str, state.ids))
    key, row = place
    cast = Cast.of(stage.roles[key], state.casts[key])
    states = tuple(cast.role.machine.states[current] for current in cast.machine.state[row])
    since = tuple(tick - int(age) for age in cast.machine.age[row])
    begun = _begun(before, actor, cast, effects, row) if tick > 0 else {}
    return Why(
        tick,
        actor,
        states,
        since,
        tuple(_explained(verdict, begun) for verdict in effects.verdicts if verdict.actor == actor),
    )


Beginning = tuple[float, str, tuple[Moved, ...]]


def _begun(
    before: StageState, actor: int, cast: Cast, effects: Effects, row: int
) -> dict[tuple[int, str], Beginning]:
    """Blend, curve and joints by layer and event of each motion that began; joints only for the last motion
    of a layer, the only one that is shown.
    """
    events = cast.role.machine.events
    beginnings: dict[tuple[int, str], Beginning] = {}
    for changes in effects.changes.values():
        for number in np.flatnonzero(changes.actor == actor)[::-1].tolist():
            layer, event = int(changes.layer[number]), events[changes.event[number]]
            if (layer, event) in beginnings:
                continue
            shown = all(place[0] != layer for place in beginnings)
            joints = _joints(before, actor, cast, row) if shown else ()
            beginnings[layer, event] = float(changes.blend[number]), CURVES[changes.curve[number]], joints
    return beginnings


def _joints(before: StageState, actor: int, cast: Cast, row: int) -> tuple[Moved, ...]:
    """The joints whose pose lies farthest from the pose of the tick before."""
    old = before.find(actor)
    if old is None:
        raise StageError(f"actor {actor} does not exist in the tick before")
    was, place = before.casts[old[0]], old[1]
    rows = np.array([row])
    new = poses_ahead(cast.role, cast.machine.take(rows)).poses()
    offset = inertialize.difference(was.shown.poses(np.array([place])), new)[0].astype(np.float64)
    names = cast.role.character.skeleton.names
    shift, turn = (
        offset[: 3 * len(names)].reshape(-1, 3),
        offset[3 * len(names) : 6 * len(names)].reshape(-1, 3),
    )
    degrees, millimetres = np.degrees(length(turn)), 1000 * length(shift)
    order = np.argsort(-(degrees + DEGREES_A_MILLIMETRE * millimetres), kind="stable")
    moved = (
        Moved(names[joint], round(float(degrees[joint]), 3), round(float(millimetres[joint]), 3))
        for joint in order[:MOST_JOINTS]
    )
    return tuple(joint for joint in moved if joint.degrees or joint.millimetres)


def _explained(verdict: Verdict, begun: dict[tuple[int, str], Beginning]) -> Explained:
    """A verdict with the beginning of the motion that its cell started."""
    has_begun = verdict.verdict == "taken" and (verdict.layer, verdict.event) in begun
    blend, curve, joints = begun[verdict.layer, verdict.event] if has_begun else (None, "", ())
    place = (
        verdict.cell,
        verdict.source,
        verdict.line,
        verdict.values,
        verdict.other,
        verdict.from_state,
        verdict.to_state,
    )
    return Explained(
        verdict.event, verdict.layer, verdict.verdict, verdict.reason, *place, blend, curve, joints
    )
