"""The colliders of a role: where they are for N actors. Only the joints that they ride on, and those above them, are evaluated."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.character import Character
from statwalk.errors import MachineError, UnknownNameError
from statwalk.machine.authored.definition import MachineDefinition
from statwalk.machine.built.build import Machine
from statwalk.machine.built.runparts import Collider
from statwalk.maths import transform, vector
from statwalk.maths.arrays import Bools, Floats
from statwalk.maths.elementary import sincos
from statwalk.maths.pose import Pose
from statwalk.rig.evaluate import world_from_local
from statwalk.rig.skeleton import Skeleton

MOST = 64
GONE = 1e-6
"""the scale of a joint below which what rides on it is not there any more"""


class Placed(NamedTuple):
    """The C colliders of N actors on the stage, metres."""

    center: Floats
    """(N, C, 3)"""
    radius: Floats
    """(N, C)"""
    normal: Floats
    """(N, C, 3) unit, of planes"""
    is_there: Bools
    """(N, C) false where the joint is scaled to nothing"""


@dataclass(frozen=True, eq=False)
class Colliders:
    """What can be touched of the actors of a role. A sphere grows with the scale of its joint, and is gone where that is 0."""

    names: tuple[str, ...]
    skeleton: Skeleton
    """the joints needed"""
    joints: NDArray[np.int64]
    """(J,) their rows in the character's skeleton"""
    rides_on: NDArray[np.int64]
    """(C,) row of `joints`, -1 the root"""
    center: Floats
    """(C, 3) metres, in the joint's space"""
    radius: Floats
    """(C,)"""
    normal: Floats
    """(C, 3)"""
    is_plane: Bools
    """(C,)"""

    @classmethod
    def of(cls, machine: Machine, character: Character, definition: MachineDefinition) -> Colliders:
        """The colliders of a machine on a character; raises MachineError with the line for a joint that the character has not."""
        all_of_them = machine.colliders
        if len(all_of_them) > MOST:
            raise definition.refuse(f"{len(all_of_them)} colliders; at most {MOST} are looked at", all_of_them[MOST].line)
        on = [_joint(character, one, definition) for one in all_of_them]
        joints = _with_parents(character.skeleton, on)
        row_of = {joint: row for row, joint in enumerate(joints)}
        parents = [row_of.get(int(character.skeleton.parent[joint]), -1) for joint in joints]
        return cls(
            names=tuple(one.name for one in all_of_them),
            skeleton=Skeleton(tuple(character.skeleton.names[joint] for joint in joints), np.array(parents, np.int32)),
            joints=np.array(joints, np.int64),
            rides_on=np.array([row_of.get(joint, -1) for joint in on], np.int64),
            center=np.array([one.center for one in all_of_them], np.float64).reshape(-1, 3),
            radius=np.array([one.radius for one in all_of_them], np.float64),
            normal=vector.unit(np.array([one.normal for one in all_of_them], np.float64).reshape(-1, 3)),
            is_plane=np.array([one.kind == "plane" for one in all_of_them], bool),
        )

    def placed(self, pose: Pose, position: Floats, heading: Floats) -> Placed:
        """Where they are for actors in poses (N, …), at places (N, 3), with headings (N,) radians."""
        matrices = np.empty((len(position), len(self.names), 3, 4))
        matrices[:] = np.eye(4)[:3]
        rides = (self.rides_on >= 0).nonzero()[0]
        if len(rides):
            part = Pose(pose.translation[:, self.joints], pose.rotation[:, self.joints], pose.scale[:, self.joints], pose.weights)
            matrices[:, rides] = world_from_local(self.skeleton, part)[:, self.rides_on[rides]]
        columns = [vector.dot(matrices[..., axis], matrices[..., axis]) for axis in range(3)]
        size = np.sqrt(np.maximum(np.maximum(columns[0], columns[1]), columns[2]))
        center = _turned(transform.apply(matrices, self.center), heading) + position[:, None]
        normal = vector.unit(_turned(transform.apply_vector(matrices, self.normal), heading))
        return Placed(center, self.radius * size, normal, size > GONE)


def _joint(character: Character, collider: Collider, definition: MachineDefinition) -> int:
    """The joint that a collider rides on, -1 for the root."""
    if not collider.joint:
        return -1
    try:
        return character.skeleton.index(collider.joint)
    except UnknownNameError as error:
        raise MachineError(f"collider {collider.name}: {error}", file=definition.file, place=f"line {collider.line}") from None


def _with_parents(skeleton: Skeleton, joints: Sequence[int]) -> list[int]:
    """These joints and all above them, parents first."""
    found: set[int] = set()
    for joint in joints:
        while joint >= 0 and joint not in found:
            found.add(joint)
            joint = int(skeleton.parent[joint])
    return sorted(found)


def _turned(vectors: Floats, heading: Floats) -> Floats:
    """Vectors (N, C, 3) turned about +Y by `heading` (N,)."""
    sine, cosine = (part[:, None] for part in sincos(heading))
    x, y, z = vectors[..., 0], vectors[..., 1], vectors[..., 2]
    return np.stack([x * cosine + z * sine, y, z * cosine - x * sine], -1)
