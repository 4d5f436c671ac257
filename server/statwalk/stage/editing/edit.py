"""Another version of a role while it is played: everybody goes on where he is, by name, and nothing that is shown jumps."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from statwalk.errors import StageError
from statwalk.maths.arrays import Ints
from statwalk.maths.pose import Pose
from statwalk.motion import inertialize
from statwalk.stage.cast import Cast
from statwalk.stage.editing.remap import Remapped, remap
from statwalk.stage.meeting.raised import Notice
from statwalk.stage.moving.fading import Fading
from statwalk.stage.moving.posing import ahead
from statwalk.stage.role import Role


def check_joints(old: Role, new: Role) -> None:
    """Raises StageError where the new version has other joints: what is shown could not go over into what it shows."""
    joints = [role.character.skeleton for role in (old, new)]
    if joints[0].names != joints[1].names or old.character.bind_pose.weights.shape != new.character.bind_pose.weights.shape:
        raise StageError(f"the new version of {old.name} has other joints; an edit keeps the character")


def edited(cast: Cast, role: Role, dt: float) -> tuple[Cast, list[Notice]]:
    """The cast in another version of its role, and what that did to its actors.

    Where the next tick would show another pose than before, a transition begins: over the default blend, from what was shown.
    """
    done = remap(cast.role.machine, role.machine, cast.machine)
    fading, lost = _layered(cast, role)
    after = replace(cast, role=role, machine=done.state, fading=fading)
    new, following = (ahead(role, done.state, ticks * dt) for ticks in (1, 2))
    rows = np.union1d(_differing(ahead(cast.role, cast.machine, dt), new), lost)
    seconds = role.definition.defaults.blend
    if len(rows) and seconds > 0:
        jump = inertialize.transition(cast.before.take(rows), cast.shown.take(rows), new.take(rows), following.take(rows), dt)
        after = replace(after, fading=fading.replaced(rows, np.full(len(rows), seconds), jump, cast.way[rows]))
    return after, _notices(cast, after, done)


def _layered(cast: Cast, role: Role) -> tuple[Fading, Ints]:
    """What fades, in the layers of the new version; the rows in whom a layer fades that is gone."""
    old, new = ([layer.name for layer in one.machine.layers] for one in (cast.role, role))
    gone = [layer for layer, name in enumerate(old) if name not in new]
    lost = np.flatnonzero(cast.fading.is_under_way[:, gone].any(1))
    return cast.fading.with_layers([old.index(name) if name in old else -1 for name in new]), lost


def _differing(one: Pose, other: Pose) -> Ints:
    """The rows in which two poses are not the same, to the bit."""
    differs = [(first != second).reshape(len(first), -1).any(1) for first, second in zip(one, other, strict=True)]
    found: Ints = np.logical_or.reduce(differs).nonzero()[0]
    return found


def _notices(before: Cast, after: Cast, done: Remapped) -> list[Notice]:
    """What the actors are told: which states they had to leave, and which events they lost."""
    old, new = before.role.machine, after.role.machine
    found = []
    for layer, one in enumerate(new.layers):
        was = [other.name for other in old.layers].index(one.name) if one in old.layers else -1
        for row, actor in enumerate(before.ids.tolist() if was >= 0 else ()):
            here, there = old.states[before.machine.state[row, was]], new.states[after.machine.state[row, layer]]
            if here != there:
                found.append(Notice(actor, EDIT, -1, f"the edit has no state {here}", layer, here, there))
    return found + [Notice(int(before.ids[row]), old.events[event], -1, "the edit has no such event") for row, _, event in done.lost]


EDIT = "EDIT"
"""stands in the place of an event where an edit has put an actor in another state"""
