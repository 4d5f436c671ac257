"""A clip as keys close together, for principles that change its curves."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose
from statwalk.motion.clip import Clip
from statwalk.motion.keys.channel import Channel

PER_SECOND = 60
MOST_KEYS = 36_000


def grid(clip: Clip, per_second: float = PER_SECOND) -> Floats:
    """Returns even times (K,) from 0 to the clip's duration, and its key times: distinct in float32."""
    count = int(np.clip(np.ceil(clip.duration * per_second), 1, MOST_KEYS)) + 1
    keys = [channel.times for channel in clip.channels]
    every = np.concatenate([np.linspace(0, clip.duration, count), *keys]).astype(np.float32)
    return np.unique(every).astype(np.float64)


def values_of(channel: Channel, poses: Pose) -> Floats:
    """Returns the values (K, n) of a channel's property in poses (K, …)."""
    if channel.path == "weights":
        first = channel.weight_first
        return poses.weights[:, first : first + channel.values.shape[-1]]
    values: Floats = getattr(poses, channel.path)[:, channel.joint]
    return values


def line(channel: Channel, times: Floats, values: Floats) -> Channel:
    """Returns the channel with LINEAR keys."""
    return replace(
        channel,
        times=times.astype(np.float32),
        values=values.astype(np.float32),
        interpolation="LINEAR",
        key_weights=None,
    )
