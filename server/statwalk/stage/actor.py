"""An actor, as one asks for it by name: its state, pose and place at the tick that its stage shows."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from statwalk.maths import quat, transform
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose
from statwalk.skin.primitive import Part
from statwalk.stage.cast import Cast
from statwalk.stage.hash import text
from statwalk.stage.role import Role

_UP = np.array([0.0, 1.0, 0.0])


class Place(NamedTuple):
    """Where an actor stands: `position` (3,) metres float64, `heading` radians about +Y (0 looks along +Z, left is positive)."""

    position: Floats
    heading: float


def _moved(part: Part, matrix: Floats) -> Part:
    """The part in the space that `matrix` (3, 4), a rigid motion, leads to."""
    normals = None if part.normals is None else transform.apply_vector(matrix, part.normals)
    return part._replace(positions=transform.apply(matrix, part.positions), normals=normals)


class Actor:
    """A view of one actor; it follows the playhead. Raises UnknownNameError at ticks where the actor is not there."""

    def __init__(self, actor: int, find: Callable[[int], tuple[Cast, int]]) -> None:
        self.id = actor
        self._find = find

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Actor) and (self.id, self._find) == (other.id, other._find)

    def __hash__(self) -> int:
        return hash(self.id)

    def __repr__(self) -> str:
        return f"<Actor {self.id}>"

    @property
    def name(self) -> str:
        """What it was called when it came."""
        cast, row = self._find(self.id)
        return cast.names[row]

    @property
    def role(self) -> Role:
        """Its character and machine."""
        return self._find(self.id)[0].role

    @property
    def state(self) -> str:
        """The machine's state (of the base layer)."""
        return self.states[0]

    @property
    def states(self) -> tuple[str, ...]:
        """The machine's state in each layer."""
        cast, row = self._find(self.id)
        return tuple(cast.role.machine.states[state] for state in cast.machine.state[row])

    @property
    def time(self) -> float:
        """Seconds into the motion (of the base layer)."""
        cast, row = self._find(self.id)
        return float(cast.machine.time[row, 0])

    @property
    def pose(self) -> Pose:
        """Local transforms (J, …) and morph weights; without the root's place."""
        cast, row = self._find(self.id)
        return cast.shown.take(row)

    @property
    def root(self) -> Place:
        """Its place on the stage."""
        cast, row = self._find(self.id)
        return Place(cast.position[row].copy(), float(cast.heading[row]))

    @property
    def matrix(self) -> Floats:
        """(3, 4) float64: from the character's space to the stage's."""
        place = self.root
        return transform.from_trs(place.position, quat.from_axis_angle(_UP, place.heading), np.ones(3))

    @property
    def world(self) -> Floats:
        """(J, 4, 4) float64: the joints in the stage's space."""
        cast, _ = self._find(self.id)
        joints = transform.from_matrix4(cast.role.character.world(self.pose).astype(np.float64))
        return transform.to_matrix4(transform.mul(self.matrix, joints))

    def vertices(self) -> list[Part]:
        """Every drawn primitive, positions and normals (V, 3) in the stage's space."""
        cast, _ = self._find(self.id)
        matrix = self.matrix
        return [_moved(part, matrix) for part in cast.role.character.vertices(self.pose)]

    @property
    def hash(self) -> str:
        """16 hexadecimal digits over all its states since it came; the same alone and in a crowd."""
        cast, row = self._find(self.id)
        return text(int(cast.hash[row]))
