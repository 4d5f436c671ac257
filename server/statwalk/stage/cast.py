"""A cast: the actors that share a role, as arrays with a leading axis of actors. One actor is a cast of one.

A cast is never changed; a tick makes the next one. Poses are float32, times and places float64.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.ticking.state import MachineState, fresh
from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.pose import Pose
from statwalk.motion import inertialize
from statwalk.stage.hash import Words, mix
from statwalk.stage.moving.fading import Fading
from statwalk.stage.moving.posing import composite
from statwalk.stage.role import Role


@dataclass(frozen=True, eq=False)
class Cast:
    """N actors of one role, L layers."""

    role: Role
    ids: NDArray[np.int64]
    """(N,) rising"""
    names: tuple[str, ...]
    machine: MachineState
    shown: Pose
    """(N, …) the poses of this tick"""
    before: Pose
    """(N, …) the poses of the tick before: with `shown` they give the velocities that were shown"""
    fading: Fading
    position: Floats
    """(N, 3) metres"""
    heading: Floats
    """(N,) radians about +Y"""
    way: Floats
    """(N, 3) the way of this tick in the actor's frame: x, z (metres), yaw (radians)"""
    hash: Words
    """(N,) over all states since the actor came"""

    def row(self, actor: int) -> int:
        """The row of an actor, or -1."""
        row = int(self.ids.searchsorted(actor))
        return row if row < len(self.ids) and self.ids[row] == actor else -1

    def joined(self, other: Cast) -> Cast:
        """With the actors of `other`, whose ids are higher."""
        return Cast(
            self.role,
            np.concatenate([self.ids, other.ids]),
            self.names + other.names,
            self.machine.append(other.machine),
            _append(self.shown, other.shown),
            _append(self.before, other.before),
            Fading._make(np.concatenate(pair) for pair in zip(self.fading, other.fading, strict=True)),
            np.concatenate([self.position, other.position]),
            np.concatenate([self.heading, other.heading]),
            np.concatenate([self.way, other.way]),
            np.concatenate([self.hash, other.hash]),
        )

    def take(self, rows: Ints) -> Cast:
        """The actors of some rows, in rising order."""
        return Cast(
            self.role,
            self.ids[rows],
            tuple(self.names[row] for row in rows.tolist()),
            self.machine.take(rows),
            self.shown.take(rows),
            self.before.take(rows),
            Fading._make(array[rows] for array in self.fading),
            self.position[rows],
            self.heading[rows],
            self.way[rows],
            self.hash[rows],
        )

    def without(self, row: int) -> Cast:
        """Without the actor of that row."""
        return self.take(np.flatnonzero(np.arange(len(self.ids)) != row))

    def with_parameters(self, given: Iterable[tuple[int, int, float]]) -> Cast:
        """With parameters set, in this order: row, parameter, value."""
        parameters = self.machine.parameters.copy()
        for row, parameter, value in given:
            parameters[row, parameter] = value
        return replace(self, machine=self.machine._replace(parameters=parameters))

    def rehashed(self) -> Cast:
        """With the hash that follows from the state now (what is fading shows in the poses)."""
        return replace(self, hash=mix(self.hash, [*self.machine.arrays(), *self.shown, self.position, self.heading, self.way]))

    @property
    def phase(self) -> Floats:
        """(N, L) 0…1 of each motion; 0 where it has no duration."""
        duration = self.role.machine.duration[self.machine.state]
        return self.machine.time / np.where(duration > 0, duration, 1)


def _append(first: Pose, second: Pose) -> Pose:
    return Pose(*(np.concatenate(pair) for pair in zip(first, second, strict=True)))


def enter(role: Role, ids: Sequence[int], names: Sequence[str], position: Floats, heading: Floats) -> Cast:
    """A cast of N new actors (`ids` rising) in the machine's initial state, at places (N, 3) with headings (N,)."""
    count = len(ids)
    machine = fresh(role.machine, count)
    shown = composite(role, machine)
    fading = Fading.none(count, machine.state.shape[1], inertialize.size(shown))
    return Cast(
        role,
        np.array(ids, np.int64),
        tuple(names),
        machine,
        shown,
        shown,
        fading,
        np.array(position, np.float64),
        np.array(heading, np.float64),
        np.zeros((count, 3)),
        np.zeros(count, np.uint64),
    ).rehashed()
