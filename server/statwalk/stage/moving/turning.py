"""Motions that begin in a tick, and the transitions that begin with them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.built.runparts import CURVES
from statwalk.machine.ticking.state import MachineState
from statwalk.machine.ticking.step import Changes
from statwalk.maths.arrays import Bools, Floats, Ints
from statwalk.maths.pose import Pose
from statwalk.motion import inertialize
from statwalk.stage.cast import Cast
from statwalk.stage.moving.fading import Beginning, Fading
from statwalk.stage.moving.posing import ahead

QUINTIC = CURVES.index("quintic")


class Turned(NamedTuple):
    """The n actors in whom some motion began, as the last change in each layer says."""

    rows: Ints
    """(n,) rising"""
    turns: NDArray[np.bool_]
    """(n, L) the layers in which one began"""
    seconds: Floats
    """(n, L) for how long each blends"""
    quintic: Bools
    """(n, L)"""

    @property
    def of_base(self) -> Ints:
        """The rows whose base layer turned."""
        return self.rows[self.turns[:, 0]]


def turned(changes: Changes, layers: int) -> Turned:
    """The last change of each actor and layer."""
    rows, actor = np.unique(changes.actor, return_inverse=True)
    shape = len(rows), layers
    found = Turned(rows, np.zeros(shape, bool), np.zeros(shape), np.zeros(shape, bool))
    for place, blend, curve in zip(zip(actor.tolist(), changes.layer.tolist(), strict=True), changes.blend, changes.curve, strict=True):
        found.turns[place], found.seconds[place], found.quintic[place] = True, blend, curve == QUINTIC
    return found


def faded(cast: Cast, state: MachineState, pose: Pose, new: Turned, dt: float) -> Fading:
    """What fades from this tick on: `pose` (N, …) is the new motions', in the machines' new `state`."""
    blends = (new.seconds > 0).any(1)  # a blend of 0 s adds nothing to what is still dying out
    rows = new.rows[blends]
    if not len(rows):
        return cast.fading
    following = ahead(cast.role, state.take(rows), dt)
    offset, rate = inertialize.transition(cast.before.take(rows), cast.shown.take(rows), pose.take(rows), following, dt)
    beginning = Beginning(rows, new.seconds[blends], new.quintic[blends], offset, rate)
    return cast.fading.begun(beginning, cast.role.moved, cast.way[rows], dt)
