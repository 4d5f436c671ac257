"""The FAQ's bones: joints with a length and a direction, each starting where its parent ends.

SK1, SK2, SK3; FAQ Q11, Q12, Q14.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from statwalk.maths import quat, transform
from statwalk.maths.arrays import Floats
from statwalk.maths.columns import lock_fields
from statwalk.maths.pose import Pose
from statwalk.rig.evaluate import world_from_local
from statwalk.rig.skeleton import Skeleton


class BoneFrames(NamedTuple):
    """The result of the FAQ's evaluation (Q14) for every bone, over any leading axes."""

    relative: Floats
    """(…, J, 3, 4) the R-matrix: local rotation and translation, from the parent's start"""
    absolute: Floats
    """(…, J, 3, 4) the A-matrix: from the bone's own space to the character's"""
    start: Floats
    """(…, J, 3) the end attached to the parent: the parent's end-point, moved by the bone's own
    translation
    """
    end: Floats
    """(…, J, 3) the end to which children are attached"""


@dataclass(frozen=True, eq=False)
class Bones:
    """A skeleton whose joints are bones at rest: lengths (J,) in the file's unit, unit directions (J, 3) in
    the bone's own space.
    """

    skeleton: Skeleton
    length: Floats
    direction: Floats

    def __post_init__(self) -> None:
        lock_fields(self)

    def attachment(self, length: Floats | None = None) -> Floats:
        """Returns the point to which children are attached, in the bone's own space: direction · length (…,
        J, 3).
        """
        return self.direction * (self.length if length is None else length)[..., None]

    def pose(
        self, rotation: Floats | None = None, translation: Floats | None = None, length: Floats | None = None
    ) -> Pose:
        """Returns the local pose for rotations (…, J, 4), own translations (…, J, 3) and lengths (…, J);
        omitted arguments stay at rest.

        A length is the translation of the bone's children along its direction: 0 hides a limb, and keys let
        it grow (Q12). An own translation moves a bone off its parent's end: recoil, dismemberment.
        """
        parent = self.skeleton.parent
        placed = self.attachment(length)[..., parent, :] * (parent >= 0)[:, None]
        if translation is not None:
            placed = placed + translation
        turned = quat.IDENTITY.astype(placed.dtype) if rotation is None else rotation
        leading = np.broadcast_shapes(placed.shape[:-1], turned.shape[:-1])
        placed, turned = np.broadcast_to(placed, (*leading, 3)), np.broadcast_to(turned, (*leading, 4))
        return Pose(placed, turned, np.ones_like(placed), np.zeros((*leading[:-1], 0), placed.dtype))

    def evaluate(
        self, rotation: Floats | None = None, translation: Floats | None = None, length: Floats | None = None
    ) -> BoneFrames:
        """Returns relative and absolute matrices, start- and end-points of all bones, parents first;
        arguments as for `pose`.
        """
        pose = self.pose(rotation, translation, length)
        relative = transform.from_trs(pose.translation, pose.rotation, pose.scale)
        absolute = world_from_local(self.skeleton, pose)
        return BoneFrames(
            relative, absolute, absolute[..., 3], transform.apply(absolute, self.attachment(length))
        )
