"""The model-space matrices of a crowd: the transforms of joints in the character's space, sixteen actors side
by side.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.columns import lock_fields
from statwalk.maths.pose_buffer import PoseBuffer
from statwalk.maths.simd.aligned import zeros
from statwalk.maths.simd.lanes import LANES
from statwalk.maths.simd.pose_layout import blocks
from statwalk.rig._kernels import model_space
from statwalk.rig.hierarchy import MATRIX
from statwalk.rig.skeleton import Skeleton


@dataclass(frozen=True, eq=False)
class JointList:
    """Wanted joints and all their ancestors, parents first."""

    joints: NDArray[np.int32]
    """(n,) rows in the skeleton"""
    parents: NDArray[np.int32]
    """(n,) the index of each joint's parent in this list, -1 a root"""

    def __post_init__(self) -> None:
        lock_fields(self)

    @classmethod
    def of(cls, skeleton: Skeleton, wanted: Sequence[int] | None = None) -> JointList:
        """Returns the list for some joints of a skeleton, or for all joints if `wanted` is None."""
        parent = skeleton.parent
        needed = np.full(len(parent), wanted is None)
        for joint in wanted or ():
            while joint >= 0 and not needed[joint]:
                needed[joint] = True
                joint = int(parent[joint])
        joints = needed.nonzero()[0].astype(np.int32)
        place = np.full(len(parent) + 1, -1, np.int32)
        place[joints] = np.arange(len(joints))
        return cls(joints, place[parent[joints]])

    def places(self, wanted: Ints) -> Ints:
        """Returns the indices of the skeleton's joints in this list; -1 (no joint) stays -1."""
        return np.where(wanted < 0, -1, self.joints.searchsorted(wanted))


@dataclass(frozen=True, eq=False)
class ModelBuffer:
    """Matrices of the joints of a list, for `count` actors. A tick fills one for each cast that needs it."""

    values: NDArray[np.float32]
    """(B, n, 12, 16) contiguous, aligned to 64 bytes; the 3 x 4 matrix row by row"""
    count: int
    joints: JointList

    @classmethod
    def room(cls, joints: JointList, count: int) -> ModelBuffer:
        """Returns an empty buffer for `count` actors."""
        shape = blocks(count), len(joints.joints), MATRIX, LANES
        return cls(zeros(int(np.prod(shape))).reshape(shape), count, joints)

    def fill(self, poses: PoseBuffer) -> None:
        """Computes the matrices of all actors of a pose buffer; a tick does it block by block
        (`model_block`).
        """
        model_space(self.joints.joints, self.joints.parents, poses.values, self.values, len(self.values))

    def matrices(self, places: Ints | None = None) -> Floats:
        """Returns (N, n, 3, 4) the matrices of all joints of the list, or of the indices `places`."""
        values = self.values if places is None else self.values[:, places]
        rows = np.moveaxis(values, 3, 1).reshape(-1, values.shape[1], 3, 4)
        return np.ascontiguousarray(rows[: self.count])
