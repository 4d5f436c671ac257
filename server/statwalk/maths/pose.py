"""A pose: the local transform of every joint, and the weights of the morph targets."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from statwalk.maths import quat
from statwalk.maths.arrays import Floats


class Pose(NamedTuple):
    """Local transforms T·R·S of J joints, over any leading axes (none, or one for the actors of a cast), and
    W morph weights.
    """

    translation: Floats
    """(…, J, 3) metres, from the parent joint"""
    rotation: Floats
    """(…, J, 4) unit quaternions xyzw"""
    scale: Floats
    """(…, J, 3)"""
    weights: Floats
    """(…, W)"""

    def copy(self) -> Pose:
        """Returns a copy of the pose."""
        return Pose(*(array.copy() for array in self))

    def take(self, rows: Any) -> Pose:
        """Returns the poses of some actors: every array indexed along its leading axis."""
        return Pose(*(array[rows] for array in self))

    def blend(self, other: Pose, weight: ArrayLike) -> Pose:
        """Returns this pose at weight 0, `other` at 1: linear, and along the shorter arc for rotations
        (slerp).

        `weight` has the leading axes.
        """
        part = np.asarray(weight, self.translation.dtype)
        by_joint, by_axis = part[..., None], part[..., None, None]
        return Pose(
            self.translation + (other.translation - self.translation) * by_axis,
            quat.slerp(self.rotation, other.rotation, by_joint),
            self.scale + (other.scale - self.scale) * by_axis,
            self.weights + (other.weights - self.weights) * by_joint,
        )


def rest(joints: int, weights: int = 0) -> Pose:
    """Returns the pose of `joints` joints at their parents, without rotation, at scale 1; float32."""
    rotation = np.broadcast_to(quat.IDENTITY, (joints, 4)).astype(np.float32)
    return Pose(
        np.zeros((joints, 3), np.float32),
        rotation,
        np.ones((joints, 3), np.float32),
        np.zeros(weights, np.float32),
    )
