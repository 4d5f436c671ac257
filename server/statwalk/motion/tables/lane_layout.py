"""The layout of a packed row of sixteen lanes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Ints
from statwalk.maths.pose import Pose
from statwalk.maths.pose_buffer import columns
from statwalk.maths.simd.lanes import LANES
from statwalk.maths.simd.pose_layout import first_channels, indices_in_block, padded
from statwalk.motion.keys.packed_keys import Track
from statwalk.motion.tables.lane_rows import Owner


class PackedClip(Protocol):
    """The packed parts of a clip: its duration (seconds), the tracks of its changing channels, and the pose
    of its constant ones.
    """

    @property
    def duration(self) -> float: ...  # noqa: D102
    @property
    def tracks(self) -> tuple[Track, ...]: ...  # noqa: D102
    @property
    def base(self) -> Pose: ...  # noqa: D102


@dataclass(frozen=True, eq=False)
class LaneLayout:
    """The layout of a packed row; the last groups are padded with their last lane."""

    turning: Ints
    """the first channel of each rotation, padded to a multiple of 16"""
    moving: Ints
    """the other channels, padded to a multiple of 16"""
    common: NDArray[np.int32]
    common_values: NDArray[np.float32]
    base: NDArray[np.float32]
    """(M + 1, C) all channels of the rest pose, then each clip's constant channels"""
    owners: tuple[Owner, ...]

    @classmethod
    def of(cls, clips: Sequence[PackedClip], rest: Pose) -> LaneLayout:
        """Returns the layout for all motions of a role."""
        base = np.stack([columns(rest), *(columns(clip.base) for clip in clips)])
        joints, channels = rest.rotation.shape[-2], base.shape[1]
        owners = tuple(Owner.of(clip.tracks, channels, joints) for clip in clips)
        played = np.stack([np.full(channels, -1), *(owner.signature for owner in owners)])
        differs = (played >= 0).any(0) | (base != base[0]).any(0)
        first = first_channels("rotation", np.arange(joints), joints)
        rotations = first[:, None] + np.arange(4)
        is_rotation = np.zeros(channels, bool)
        is_rotation[rotations] = True
        turns = differs[rotations].any(1)
        common = ~differs
        common[rotations[turns]] = False
        turning, moving = (
            _filled(_alike(rows, played)) for rows in (first[turns], np.flatnonzero(differs & ~is_rotation))
        )
        places = np.flatnonzero(common)
        return cls(turning, moving, indices_in_block(places), base[0, places], base, owners)

    @property
    def order(self) -> Ints:
        """Returns (W,) the channel of each number of a packed row."""
        turns = self.turning.reshape(-1, 1, LANES) + np.arange(4)[:, None]
        return np.concatenate([turns.ravel(), self.moving])

    @property
    def places(self) -> NDArray[np.int32]:
        """Returns (2 + W,) the number of rotation numbers, the number of all numbers, and the index in a
        block of each.
        """
        turns = 4 * len(self.turning)
        counts = np.array([turns, turns + len(self.moving)], np.int32)
        return np.concatenate([counts, indices_in_block(self.order)])


def _alike(channels: Ints, played: Ints) -> Ints:
    """The channels sorted so that channels of the same tracks with the same number of keys are side
    by side.
    """
    return channels[np.lexsort(played[:, channels])] if len(channels) else channels


def _filled(channels: Ints) -> Ints:
    return np.concatenate([channels, channels[-1:].repeat(padded(len(channels)) - len(channels))]).astype(
        np.int64
    )
