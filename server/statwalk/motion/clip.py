"""A clip: timed poses of a character (FAQ Q16), with the semantics of glTF's animations."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose
from statwalk.motion.keys.channel import Channel, Marker, duration_of
from statwalk.motion.keys.channel_table import ClipChannels
from statwalk.motion.keys.key_set import KeySet, key_sets_of
from statwalk.motion.keys.packed_keys import Track, tracks_of
from statwalk.motion.sampling.poses import poses_at
from statwalk.motion.tables.build import Alone, tables_of
from statwalk.motion.tables.motion_tables import MotionTables

__all__ = ["Channel", "Clip", "Marker", "duration_of"]


@dataclass(frozen=True, eq=False)
class Clip:
    """Keyed channels over the pose they rest on. Immutable; the packed form is made on first use.

    pose = clip.sample(0.3)                  # one pose
    poses = clip.sample([0.0, 0.1, 0.2])     # a leading axis of three
    """

    name: str
    channels: Sequence[Channel]
    duration: float
    """seconds: time runs from 0 to the last key of all channels"""
    rest: Pose
    """unbatched: the pose of all properties without a channel"""
    markers: tuple[Marker, ...] = ()
    loop: bool = False
    """whether the clip repeats; a B-spline whose ends meet then has no seam"""

    def __repr__(self) -> str:
        parts = [f"{self.duration:.4g} s", f"{len(self.channels)} channels"]
        parts += [f"{len(self.markers)} markers"] if self.markers else []
        parts += ["loop"] if self.loop else []
        return f"Clip({self.name!r}, {', '.join(parts)})"

    def sample(self, time: ArrayLike, loop: bool = False) -> Pose:
        """Returns the pose at `time` seconds, float32; with a leading axis if `time` is an array (N,).

        Outside 0…duration the ends hold; with `loop` time is taken modulo the duration. STEP, LINEAR and
        CUBICSPLINE follow glTF 2.0, appendix C.
        """
        times = np.asarray(time, np.float64)
        flat = _wrap(times, self.duration).reshape(-1) if loop else times.reshape(-1)
        poses = poses_at(self.tables, self.rest, flat)
        return poses if times.ndim else poses.take(0)

    @cached_property
    def tables(self) -> MotionTables:
        """Returns the tables of this clip alone, for sampling."""
        return tables_of((Alone(self),), self.rest)

    @cached_property
    def tracks(self) -> tuple[Track, ...]:
        """Returns the channels that change, packed for sampling."""
        return (
            self.channels.tracks()
            if isinstance(self.channels, ClipChannels)
            else tracks_of(self.key_sets, self.loop)
        )

    @cached_property
    def key_sets(self) -> tuple[KeySet, ...]:
        """Returns the channels by kind, for clips without a channel table."""
        return key_sets_of(self.channels)

    @cached_property
    def base(self) -> Pose:
        """Returns the rest pose with the values of all constant channels, float32."""
        pose = Pose(*(array.astype(np.float32) for array in self.rest))
        for part in (self.channels,) if isinstance(self.channels, ClipChannels) else self.key_sets:
            part.lay(pose)
        return pose


def _wrap(times: Floats, duration: float) -> Floats:
    """Times modulo the duration; 0 for a motion without duration."""
    return np.mod(times, duration) if duration > 0 else np.zeros_like(times)
