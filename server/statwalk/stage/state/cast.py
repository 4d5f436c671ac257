"""A cast: the actors that share a role, as arrays with a leading axis of actors; poses are stored for sixteen
actors side by side.

A single actor is a cast of one. Poses are float32, times and places float64. A `CastState` holds arrays only;
a `Cast` is a `CastState` with its role, for the steps of a tick.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, fields, replace
from operator import attrgetter
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from statwalk.character.role import Role
from statwalk.machine.runtime.state import MachineState, fresh
from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.pose_buffer import PoseBuffer
from statwalk.maths.random import Words
from statwalk.rig.model_buffer import ModelBuffer
from statwalk.stage.state.pose_offsets import PoseOffsets, offset_size


@dataclass(frozen=True, eq=False)
class CastState:
    """N actors of one role, L layers."""

    ids: NDArray[np.int64]
    """(N,) ascending"""
    machine: MachineState
    shown: PoseBuffer
    """the poses of this tick"""
    previous: PoseBuffer
    """the poses of the tick before; with `shown` they give the velocities on screen"""
    offsets: PoseOffsets
    """the pose offsets of transitions under way"""
    position: Floats
    """(N, 3) metres"""
    heading: Floats
    """(N,) radians about +Y"""
    root_delta: Floats
    """(N, 3) root motion of this tick in the actor's frame: x, z (metres), yaw (radians)"""
    solver_memory: Floats
    """(N, K) what the role's solvers keep from tick to tick: locked feet, springs (`Role.solver_memory`)"""
    hash: Words
    """(N,) hash over all states since the actor was added"""

    def row(self, actor: int) -> int:
        """Returns the row of an actor, or -1."""
        row = int(self.ids.searchsorted(actor))
        return row if row < len(self.ids) and self.ids[row] == actor else -1

    def append(self, other: CastState) -> Self:
        """Returns the cast followed by the actors of `other`, whose ids are higher."""
        both: dict[str, Any] = {name: getattr(self, name).append(getattr(other, name)) for name in PARTS}
        both |= {name: np.concatenate([getattr(self, name), getattr(other, name)]) for name in COLUMNS}
        return replace(self, **both)

    def take(self, rows: Ints) -> Self:
        """Returns the actors at some rows, in this order."""
        some: dict[str, Any] = {name: getattr(self, name).take(rows) for name in PARTS}
        return replace(self, **some, **{name: getattr(self, name)[rows] for name in COLUMNS})

    def copy(self) -> Self:
        """Returns a copy that shares no memory."""
        return replace(self, **{name: getattr(self, name).copy() for name in (*PARTS, *COLUMNS)})

    def without(self, row: int) -> Self:
        """Returns the cast without the actor at a row."""
        return self.take(np.flatnonzero(np.arange(len(self.ids)) != row))

    def with_parameters(self, values: Iterable[tuple[int, int, float]]) -> Self:
        """Returns the cast with parameters set, in this order: row, parameter, value."""
        parameters = self.machine.parameters.copy()
        for row, parameter, value in values:
            parameters[row, parameter] = value
        return replace(self, machine=self.machine._replace(parameters=parameters))

    @classmethod
    def empty(cls, role: Role) -> CastState:
        """Returns the arrays of a role with zero actors; dtypes and further axes are the same as
        with actors.
        """
        machine, rest = fresh(role.machine.program, 0), role.character.bind_pose
        pose, size = (
            PoseBuffer.at_rest(rest, 0),
            offset_size(len(role.character.skeleton), rest.weights.shape[-1]),
        )
        offsets = PoseOffsets.none(0, machine.state.shape[1], size)
        nowhere, words = np.zeros((0, 3)), np.zeros(0, np.uint64)
        kept = np.zeros((0, role.solver_memory.size))
        return CastState(
            np.zeros(0, np.int64), machine, pose, pose, offsets, nowhere, np.zeros(0), nowhere, kept, words
        )


PARTS = ("machine", "shown", "previous", "offsets")
NAMES = tuple(field.name for field in fields(CastState))
COLUMNS = tuple(name for name in NAMES if name not in PARTS)
_columns_of = attrgetter(*NAMES)


@dataclass(frozen=True, eq=False, kw_only=True)
class Cast(CastState):
    """N actors and the role that they share."""

    role: Role
    model: ModelBuffer | None = None
    """in a tick, after step 7: the joints of the role's colliders as `shown` poses them, in the memory of the
    tick; None if no sense or flock reads them
    """

    @classmethod
    def of(cls, role: Role, state: CastState) -> Cast:
        """Returns a cast from a state and its role."""
        return cls(*_columns_of(state), role=role)

    @property
    def state(self) -> CastState:
        """The arrays, without the role."""
        return CastState(*_columns_of(self))

    @property
    def phase(self) -> Floats:
        """(N, L) phase 0…1 of each motion; 0 for a motion without a duration."""
        duration = self.role.machine.duration[self.machine.state]
        phase: Floats = self.machine.time / np.where(duration > 0, duration, 1)
        return phase
