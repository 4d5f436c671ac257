"""The poses of a crowd: sixteen actors side by side, so that one instruction works on sixteen of them.

`maths.simd.pose_layout` defines the layout. Lanes without an actor hold the rest pose, so that no kernel
meets a NaN or a denormal there.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Ints
from statwalk.maths.pose import Pose
from statwalk.maths.simd.pose_layout import (
    JOINT_CHANNELS,
    ROTATION_CHANNEL,
    SCALE_CHANNEL,
    blocks,
    padded,
    places,
    zero_blocks,
)


@dataclass(eq=False)
class PoseBuffer:
    """Poses of `count` actors of one character. Kernels may write the arrays."""

    values: NDArray[np.float32]
    """(B, C, LANES) contiguous, aligned to 64 bytes"""
    count: int
    rest: Pose
    """the unbatched pose (J, …) that lanes without an actor hold"""

    @classmethod
    def at_rest(cls, rest: Pose, count: int) -> PoseBuffer:
        """Returns a buffer of `count` actors in the rest pose (J, …)."""
        buffer = cls(zero_blocks(blocks(count), channels(rest)), count, rest)
        buffer.values[:] = columns(rest)[:, None]
        return buffer

    @classmethod
    def of(cls, rest: Pose, poses: Pose) -> PoseBuffer:
        """Returns a buffer of the poses (N, J, …) of N actors."""
        buffer = cls.at_rest(rest, len(poses.rotation))
        buffer.put(np.arange(buffer.count), poses)
        return buffer

    @property
    def used(self) -> int:
        """Returns the number of channels of a pose, without padding."""
        return _used(self.rest)

    def actor(self, row: int) -> Pose:
        """Returns a copy of the pose (J, …) of one actor."""
        return Pose(*(array[0] for array in self.poses(np.array([row]))))

    def poses(self, rows: Ints | None = None) -> Pose:
        """Returns copies of the poses (n, J, …) of some rows, or of all rows if `rows` is None."""
        rows = np.arange(self.count) if rows is None else rows
        values, joints = self._channels(rows), self.rest.rotation.shape[-2]
        of_joints = values[:, : JOINT_CHANNELS * joints].reshape(len(rows), joints, JOINT_CHANNELS)
        parts = (
            of_joints[..., :ROTATION_CHANNEL],
            of_joints[..., ROTATION_CHANNEL:SCALE_CHANNEL],
            of_joints[..., SCALE_CHANNEL:],
            values[:, JOINT_CHANNELS * joints : self.used],
        )
        return Pose(*(np.ascontiguousarray(part) for part in parts))

    def put(self, rows: Ints, poses: Pose) -> None:
        """Writes poses (n, J, …) into some rows."""
        self._write(rows, columns(poses))

    def take(self, rows: Ints) -> PoseBuffer:
        """Returns a new buffer of the actors of some rows, in this order."""
        taken = PoseBuffer.at_rest(self.rest, len(rows))
        taken._write(np.arange(len(rows)), self._channels(rows))
        return taken

    def append(self, other: PoseBuffer) -> PoseBuffer:
        """Returns a new buffer of these actors, then the other buffer's actors."""
        both = PoseBuffer.at_rest(self.rest, self.count + other.count)
        for source, first in ((self, 0), (other, self.count)):
            rows = np.arange(source.count)
            both._write(rows + first, source._channels(rows))
        return both

    def copy(self) -> PoseBuffer:
        """Returns a copy of the buffer."""
        copied = PoseBuffer(zero_blocks(*self.values.shape[:2]), self.count, self.rest)
        copied.values[:] = self.values
        return copied

    def rows(self) -> NDArray[np.float32]:
        """Returns (N, 10·J + W) one contiguous row of channels for each actor, without padding and empty
        lanes, for storage and transport.
        """
        used = _used(self.rest)
        lanes = np.ascontiguousarray(self.values[:, :used].transpose(0, 2, 1))
        return lanes.reshape(-1, used)[: self.count]

    @classmethod
    def of_rows(cls, rest: Pose, rows: NDArray[np.float32]) -> PoseBuffer:
        """Returns the buffer for the result (N, 10·J + W) of `rows()`."""
        buffer = cls.at_rest(rest, len(rows))
        block, lane = places(np.arange(len(rows)))
        buffer.values[block, : buffer.used, lane] = rows
        return buffer

    def _channels(self, rows: Ints) -> NDArray[np.float32]:
        """(n, C) the channels of some rows, with padding."""
        block, lane = places(rows)
        return self.values[block, :, lane]

    def _write(self, rows: Ints, channels: NDArray[np.float32]) -> None:
        block, lane = places(rows)
        self.values[block, :, lane] = channels


def channels(rest: Pose) -> int:
    """Returns the number of channels of a block for poses like `rest` (J, …), padding included."""
    return padded(_used(rest))


def _used(rest: Pose) -> int:
    return int(JOINT_CHANNELS * rest.rotation.shape[-2] + rest.weights.shape[-1])


def columns(poses: Pose) -> NDArray[np.float32]:
    """Returns the channels (…, C) of poses (…, J, …), float32, padding included."""
    lead, joints = poses.rotation.shape[:-2], poses.rotation.shape[-2]
    of_joints = np.concatenate(poses[:3], -1, dtype=np.float32).reshape(*lead, JOINT_CHANNELS * joints)
    padding = np.zeros((*lead, channels(poses) - _used(poses)), np.float32)
    return np.concatenate([of_joints, poses.weights, padding], -1, dtype=np.float32)
