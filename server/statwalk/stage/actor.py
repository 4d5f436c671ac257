"""An actor as a caller sees it: state, pose and place at the tick that its stage shows."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from statwalk.character.expressions import ExpressionValues, values_by_name
from statwalk.character.role import Role
from statwalk.machine.settings import values_of
from statwalk.maths import quat, transform
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose
from statwalk.rig.limits import ClampedJoint
from statwalk.skin.primitive import Part
from statwalk.stage.state.cast import Cast
from statwalk.stage.state.hashing import text
from statwalk.stage.steps.expression_values import expression_values
from statwalk.stage.steps.limit_excess import clamped_joints
from statwalk.stage.steps.reached import ReachedTarget, reached_targets

_UP = np.array([0.0, 1.0, 0.0])


class Place(NamedTuple):
    """The place of an actor: `position` (3,) metres float64, `heading` radians about +Y (0 faces +Z, left is
    positive).
    """

    position: Floats
    heading: float


class Found(NamedTuple):
    """An actor at the tick that its stage shows: its cast, its row there, its name; the tick, and the seconds
    of a tick.
    """

    cast: Cast
    row: int
    name: str
    tick: int
    dt: float


def _moved(part: Part, matrix: Floats) -> Part:
    """The part transformed by `matrix` (3, 4), a rigid motion."""
    normals = None if part.normals is None else transform.apply_vector(matrix, part.normals)
    return part._replace(positions=transform.apply(matrix, part.positions), normals=normals)


class Actor:
    """A view of one actor; it follows the playhead.

    :raises UnknownNameError: from every member, when the actor does not exist at the tick that is shown.
    """

    def __init__(self, actor: int, find: Callable[[int], Found]) -> None:
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
        """The name that the actor was added with."""
        return self._find(self.id).name

    @property
    def role(self) -> Role:
        """The role, in the version in force: character and machine."""
        return self._find(self.id).cast.role

    @property
    def state(self) -> str:
        """The state of the base layer."""
        return self.states[0]

    @property
    def states(self) -> tuple[str, ...]:
        """The state of each layer."""
        cast, row = self._find(self.id)[:2]
        return tuple(cast.role.machine.states[state] for state in cast.machine.state[row])

    @property
    def time(self) -> float:
        """Seconds into the motion of the base layer."""
        cast, row = self._find(self.id)[:2]
        return float(cast.machine.time[row, 0])

    @property
    def variables(self) -> dict[str, float]:
        """The free variables of the expressions of the machine and its character, by name."""
        return self._expressed().variables

    @property
    def channels(self) -> dict[str, float]:
        """The channels that expressions set, by name: degrees, metres and scales."""
        return self._expressed().channels

    def _expressed(self) -> ExpressionValues:
        cast, row, _, tick, dt = self._find(self.id)
        (values,) = expression_values(cast, np.array([row]), tick, dt).tolist()
        return values_by_name(cast.role.expressions, values)

    @property
    def parameters(self) -> dict[str, float | tuple[float, ...]]:
        """The parameters of the machine as they are set, by name; points, directions and rotations as
        tuples.
        """
        cast, row = self._find(self.id)[:2]
        return values_of(cast.role.machine, cast.machine.parameters[row].tolist())

    @property
    def pose(self) -> Pose:
        """Local transforms (J, …) and morph weights, without the place on the stage."""
        cast, row = self._find(self.id)[:2]
        return cast.shown.actor(row)

    @property
    def root(self) -> Place:
        """The place on the stage."""
        cast, row = self._find(self.id)[:2]
        return Place(cast.position[row].copy(), float(cast.heading[row]))

    @property
    def matrix(self) -> Floats:
        """(3, 4) float64: from character space to stage space."""
        place = self.root
        return transform.from_trs(place.position, quat.from_axis_angle(_UP, place.heading), np.ones(3))

    @property
    def world(self) -> Floats:
        """(J, 4, 4) float64: the joints in stage space."""
        cast = self._find(self.id).cast
        joints = transform.from_matrix4(cast.role.character.world(self.pose).astype(np.float64))
        return transform.to_matrix4(transform.mul(self.matrix, joints))

    def vertices(self, skinning: str = "") -> list[Part]:
        """Returns every drawn primitive, positions and normals (V, 3) in stage space; `skinning` as in
        `Character.vertices`.

        :raises UnknownNameError: when there is no such way of skinning.
        """
        cast = self._find(self.id).cast
        matrix = self.matrix
        return [_moved(part, matrix) for part in cast.role.character.vertices(self.pose, skinning)]

    @property
    def clamped(self) -> tuple[ClampedJoint, ...]:
        """The joints that their limits changed in this tick, after blending or in solvers; by how much."""
        cast, row, _, tick, dt = self._find(self.id)
        return clamped_joints(cast, np.array([row]), (tick, dt))[0]

    @property
    def reached(self) -> dict[str, ReachedTarget]:
        """What each solver of the machine file did in this tick: weight, distance left, reached; by name."""
        cast, row = self._find(self.id)[:2]
        return {
            found.solver: found for found in reached_targets(cast.role, cast.solver_memory[row : row + 1])[0]
        }

    @property
    def hash(self) -> str:
        """16 hexadecimal digits over all states since the actor was added; the same alone and in a crowd."""
        cast, row = self._find(self.id)[:2]
        return text(int(cast.hash[row]))
