"""The colliders of a role: their positions for N actors.

Only the joints that colliders ride on, and their ancestors, are evaluated.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numba import types
from numpy.typing import NDArray

from statwalk.character.character import Character
from statwalk.errors import MachineError, UnknownNameError
from statwalk.machine.compile.alternatives import Collider
from statwalk.machine.compile.compile_machine import Machine
from statwalk.machine.definition.machine_definition import MachineDefinition
from statwalk.maths import scalar, vector
from statwalk.maths.arrays import Bools, Floats
from statwalk.maths.columns import lock_fields
from statwalk.maths.compiling import FLOAT, LONG, kernel, read, write
from statwalk.rig.hierarchy import read_matrix
from statwalk.rig.model_buffer import JointList, ModelBuffer

_DOUBLE = types.float64
MOST = 64
GONE = 1e-6
"""the scale of a joint below which its colliders vanish"""


class Placed(NamedTuple):
    """The C colliders of N actors on the stage, metres."""

    center: Floats
    """(N, C, 3)"""
    radius: Floats
    """(N, C)"""
    normal: Floats
    """(N, C, 3) unit, of planes"""
    is_there: Bools
    """(N, C) false if the joint is scaled to nothing"""


@dataclass(frozen=True, eq=False)
class Colliders:
    """The colliders of a role's actors.

    A sphere grows with the scale of its joint, and vanishes at scale 0.
    """

    names: tuple[str, ...]
    joints: JointList
    """the joints that colliders need"""
    rides_on: NDArray[np.int64]
    """(C,) index in `joints`, -1 the root"""
    center: Floats
    """(C, 3) metres, in the joint's space"""
    radius: Floats
    """(C,)"""
    normal: Floats
    """(C, 3)"""
    is_plane: Bools
    """(C,)"""

    def __post_init__(self) -> None:
        lock_fields(self)

    @classmethod
    def of(cls, machine: Machine, character: Character, definition: MachineDefinition) -> Colliders:
        """Returns the colliders of a machine on a character.

        :raises MachineError: when a collider rides on a joint that the character does not have, or there are
            too many colliders; with the line.
        """
        written = machine.colliders
        if len(written) > MOST:
            raise definition.refuse(
                f"{len(written)} colliders; at most {MOST} are looked at", written[MOST].line
            )
        on = [_joint(character, collider, definition) for collider in written]
        joints = JointList.of(character.skeleton, on)
        return cls(
            names=tuple(collider.name for collider in written),
            joints=joints,
            rides_on=joints.places(np.array(on, np.int64)).astype(np.int64),
            center=np.array([collider.center for collider in written], np.float64).reshape(-1, 3),
            radius=np.array([collider.radius for collider in written], np.float64),
            normal=vector.unit(
                np.array([collider.normal for collider in written], np.float64).reshape(-1, 3)
            ),
            is_plane=np.array([collider.kind == "plane" for collider in written], bool),
        )

    def placed(self, model: ModelBuffer, position: Floats, heading: Floats) -> Placed:
        """Returns the positions of the colliders for the N actors of a model buffer of `joints`, at places
        (N, 3), with headings (N,) radians.
        """
        shape = len(position), len(self.names)
        placed = Placed(np.empty((*shape, 3)), np.empty(shape), np.empty((*shape, 3)), np.empty(shape, bool))
        own = self.rides_on, self.center, self.radius, self.normal
        places = np.ascontiguousarray(position), np.ascontiguousarray(heading)
        _place(model.values, *own, *places, np.empty((3, 4)), *placed)
        return placed


def _joint(character: Character, collider: Collider, definition: MachineDefinition) -> int:
    if not collider.joint:
        return -1
    try:
        return character.skeleton.index(collider.joint)
    except UnknownNameError as error:
        raise MachineError(
            f"collider {collider.name}: {error}", file=definition.file, place=f"line {collider.line}"
        ) from None


@kernel(
    read(FLOAT, 4), read(LONG, 1), read(_DOUBLE, 2), read(_DOUBLE, 1), read(_DOUBLE, 2), read(_DOUBLE, 2),
    read(_DOUBLE, 1), write(_DOUBLE, 2), write(_DOUBLE, 3), write(_DOUBLE, 2), write(_DOUBLE, 3),
    write(types.boolean, 2),
)  # fmt: skip
def _place(
    model: Any, rides_on: Any, centers: Any, radii: Any, normals: Any, position: Any, heading: Any,
    matrix: Any, center: Any, radius: Any, normal: Any, is_there: Any,
) -> None:  # fmt: skip
    """Places each collider (C, …): under the matrix of its joint, turned about +Y by the heading, moved to
    the position; `matrix` is memory to work in.
    """
    for row in range(len(heading)):
        sine, cosine = scalar.sin(heading[row]), scalar.cos(heading[row])
        for k in range(len(radii)):
            read_matrix(model, row, rides_on[k], matrix)
            size = 0.0
            for axis in range(3):
                x, y, z = matrix[0, axis], matrix[1, axis], matrix[2, axis]
                size = max(size, x * x + y * y + z * z)
            size = math.sqrt(size)
            radius[row, k], is_there[row, k] = radii[k] * size, size > GONE
            for axis in range(3):
                x, y, z = matrix[axis, 0], matrix[axis, 1], matrix[axis, 2]
                moved = x * centers[k, 0] + y * centers[k, 1] + z * centers[k, 2]
                center[row, k, axis] = moved + matrix[axis, 3]
                normal[row, k, axis] = x * normals[k, 0] + y * normals[k, 1] + z * normals[k, 2]
            x, z = center[row, k, 0], center[row, k, 2]
            center[row, k, 0] = x * cosine + z * sine + position[row, 0]
            center[row, k, 1] += position[row, 1]
            center[row, k, 2] = z * cosine - x * sine + position[row, 2]
            x, y, z = normal[row, k, 0], normal[row, k, 1], normal[row, k, 2]
            x, z = x * cosine + z * sine, z * cosine - x * sine
            length = math.sqrt(x * x + y * y + z * z)
            unit = length if length > 0 else 1.0
            normal[row, k, 0], normal[row, k, 1], normal[row, k, 2] = x / unit, y / unit, z / unit
