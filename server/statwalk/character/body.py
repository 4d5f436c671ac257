"""A character's body at rest: where its bones are, and which way it stands and faces."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from statwalk.character.body_bones import SIDES
from statwalk.character.character import Character
from statwalk.maths import quat, vector
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose
from statwalk.rig.evaluate import world_from_local
from statwalk.rig.skeleton import Skeleton

UPRIGHT, STRAIGHT = 0.8, 0.9
"""cosines: an axis of the body that is so near to an axis of the file is that axis"""


@dataclass(frozen=True)
class Body:
    """A character at rest, in its own space.

    bones      the joint of each body bone
    position   (J, 3), rotation (J, 4): the joints in the character's space
    axes       (4,) turns +X to the body's left, +Y up, +Z forward
    """

    character: Character
    bones: Mapping[str, int]
    position: Floats
    rotation: Floats
    axes: Floats

    @classmethod
    def of(cls, character: Character, bones: Mapping[str, int]) -> Body:
        """Returns the body of a character whose joints carry these bones."""
        pose = Pose(*(array.astype(np.float64) for array in character.bind_pose))
        position = world_from_local(character.skeleton, pose)[..., 3]
        rotation = world_rotations(character.skeleton, pose.rotation)
        return cls(character, bones, position, rotation, _axes(position, bones))

    @property
    def up(self) -> Floats:
        """Returns the unit vector (3,) up the body."""
        return quat.rotate(self.axes, np.array([0.0, 1.0, 0.0]))

    def at(self, bone: str) -> Floats:
        """Returns the place (3,) of a bone's joint."""
        place: Floats = self.position[self.bones[bone]]
        return place

    def direction(self, bone: str, child: str) -> Floats | None:
        """Returns the unit vector (3,) from a bone's joint to its child's; None where one is missing, or both
        are in one place.
        """
        if bone not in self.bones or child not in self.bones:
            return None
        way = self.at(child) - self.at(bone)
        size = vector.length(way)
        return way / size if size > 1e-9 else None

    def leg(self) -> float:
        """Returns the mean length of thigh and shin of the legs that are known; 0: none."""
        lengths = [
            float(vector.length(self.at(side + low) - self.at(side + high)))
            for side in SIDES
            for high, low in (("UpperLeg", "LowerLeg"), ("LowerLeg", "Foot"))
            if side + high in self.bones and side + low in self.bones
        ]
        return 2 * sum(lengths) / len(lengths) if lengths else 0.0


def world_rotations(skeleton: Skeleton, local: Floats) -> Floats:
    """Returns the rotations (…, J, 4) of joints in the character's space; even scales play
    no part.
    """
    world = np.empty_like(local)
    for joint, parent in enumerate(skeleton.parent.tolist()):
        own = quat.normalize(local[..., joint, :])
        world[..., joint, :] = own if parent < 0 else quat.mul(world[..., parent, :], own)
    return world


def _axes(position: Floats, bones: Mapping[str, int]) -> Floats:
    """Returns the turn from the file's axes to the body's: up from hips to head, left from leg to leg."""
    up = np.array([0.0, 1.0, 0.0])
    for top in ("Head", "Neck", "UpperChest", "Chest", "Spine"):
        if top in bones and "Hips" in bones:
            up = _snapped(position[bones[top]] - position[bones["Hips"]], UPRIGHT, up)
            break
    left = np.array([1.0, 0.0, 0.0])
    for pair in ("UpperLeg", "UpperArm", "LowerLeg", "LowerArm"):
        if all(side + pair in bones for side in SIDES):
            across = position[bones["Left" + pair]] - position[bones["Right" + pair]]
            left = _snapped(across - up * vector.dot(across, up), STRAIGHT, left)
            break
    forward = vector.unit(vector.cross(left, up))
    return quat.from_matrix(np.stack([vector.cross(up, forward), up, forward], -1))


def _snapped(way: Floats, nearest: float, fallback: Floats) -> Floats:
    """Returns the axis of the file that a vector nearly has, else its own direction."""
    size = vector.length(way)
    if size < 1e-9:
        return fallback
    unit: Floats = way / size
    row = int(np.abs(unit).argmax())
    if abs(unit[row]) < nearest:
        return unit
    axis = np.zeros(3)
    axis[row] = np.sign(unit[row])
    return axis
