"""A clip: timed poses of a character (FAQ Q16), with the semantics of glTF's animations."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from statwalk.maths.pose import Pose
from statwalk.motion.bundle import Bundle, bundles_of
from statwalk.motion.channel import Channel, Marker, duration_of
from statwalk.motion.keytable import KeyTable
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
    channels: Sequence[Channel]
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
        return self.channels.tracks() if isinstance(self.channels, KeyTable) else tracks_of(self.bundles, self.loop)

    @cached_property
    def bundles(self) -> tuple[Bundle, ...]:
        """The channels by kind, where they do not come in a table."""
        return bundles_of(self.channels)

    @cached_property
    def base(self) -> Pose:
        """The rest pose with the values of all channels that never change, float32."""
        pose = Pose(*(array.astype(np.float32) for array in self.rest))
        for part in (self.channels,) if isinstance(self.channels, KeyTable) else self.bundles:
            part.lay(pose)
        return pose
