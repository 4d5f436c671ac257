"""A clip: timed poses of a character (FAQ Q16), with the semantics of glTF's animations."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from statwalk.maths import quat
from statwalk.maths.pose import Pose
from statwalk.motion.channel import Channel, Marker, duration_of
from statwalk.motion.sample import sample, wrap
from statwalk.motion.track import Track, tracks_of

__all__ = ["Channel", "Clip", "Marker", "duration_of"]


@dataclass(frozen=True, eq=False)
class Clip:
    """Keyed channels over the pose they rest on. Immutable; the packed form is made on first use.

    pose = clip.sample(0.3)                  # Pose of one moment
    poses = clip.sample([0.0, 0.1, 0.2])     # a leading axis of three
    """

    name: str
    channels: tuple[Channel, ...]
    duration: float
    """seconds: time runs from 0 to the last key of all channels"""
    rest: Pose
    """unbatched: the pose of all that has no channel"""
    markers: tuple[Marker, ...] = ()
    loop: bool = False
    """whether it is made to be repeated; B-splines whose ends meet then have no seam"""

    def sample(self, time: ArrayLike, loop: bool = False) -> Pose:
        """The pose at `time` seconds, float32; a leading axis where `time` is an array (N,).

        Outside 0…duration the ends hold; with `loop` time is taken modulo the duration.
        STEP, LINEAR and CUBICSPLINE are those of glTF 2.0, appendix C.
        """
        times = np.asarray(time, np.float64)
        flat = wrap(times, self.duration).reshape(-1) if loop else times.reshape(-1)
        poses = sample(self.tracks, self.base, flat)
        return poses if times.ndim else poses.take(0)

    @cached_property
    def tracks(self) -> tuple[Track, ...]:
        """The channels that change, packed for sampling."""
        return tracks_of(self.channels, self.loop)

    @cached_property
    def base(self) -> Pose:
        """The rest pose with the values of all channels that never change, float32."""
        pose = Pose(*(array.astype(np.float32) for array in self.rest))
        for channel in self.channels:
            if channel.is_constant and channel.path == "weights":
                pose.weights[channel.weight_first : channel.weight_first + channel.keys.shape[-1]] = channel.keys[0]
            elif channel.is_constant:
                value = quat.normalize(channel.keys[0].astype(np.float64)) if channel.path == "rotation" else channel.keys[0]
                getattr(pose, channel.path)[channel.joint] = value
        return pose
