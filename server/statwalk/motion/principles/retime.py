"""Timing: the same motion in another time."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from statwalk.errors import ContentError
from statwalk.motion.clip import Clip
from statwalk.motion.keys.channel import Channel

FASTEST = 1000.0


def retime(clip: Clip, speed: float) -> Clip:
    """Returns the clip `speed` times as fast: every key and marker keeps its place in the motion.

    :raises ContentError: when `speed` is not 0.001 to 1000, or key times fall together.
    """
    if not 1 / FASTEST <= speed <= FASTEST:
        raise ContentError(f"a speed should be {1 / FASTEST:g} to {FASTEST:g}, it is {speed:g}")
    markers = tuple(marker._replace(time=marker.time / speed) for marker in clip.markers)
    channels = tuple(_retimed(channel, speed) for channel in clip.channels)
    return replace(clip, channels=channels, duration=clip.duration / speed, markers=markers)


def to_seconds(clip: Clip, seconds: float) -> Clip:
    """Returns the clip with a duration of `seconds`.

    :raises ContentError: when the clip has no duration, or the speed is not 0.001 to 1000.
    """
    if not (clip.duration > 0 and seconds > 0):
        raise ContentError(f"a clip of {clip.duration:g} s cannot take {seconds:g} s")
    return retime(clip, clip.duration / seconds)


def to_frames(clip: Clip, frames: float, rate: float = 24.0) -> Clip:
    """Returns the clip with a length of `frames` at `rate` frames per second, as animators count.

    :raises ContentError: as `to_seconds`, and when the rate is not above 0.
    """
    if not rate > 0:
        raise ContentError(f"a rate should be above 0 frames a second, it is {rate:g}")
    return to_seconds(clip, frames / rate)


def _retimed(channel: Channel, speed: float) -> Channel:
    values = channel.values
    if channel.interpolation == "CUBICSPLINE":  # tangents are per second
        values = values * np.array([speed, 1, speed], values.dtype)[:, None]
    times = (channel.times.astype(np.float64) / speed).astype(np.float32)
    return replace(channel, times=times, values=values)
