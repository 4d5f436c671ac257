"""Slow in and slow out: a clip whose time runs unevenly."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from statwalk.errors import UnknownNameError
from statwalk.maths.arrays import Floats
from statwalk.maths.easing import EASINGS
from statwalk.motion.clip import Clip
from statwalk.motion.keys.channel import Channel
from statwalk.motion.principles.resample import PER_SECOND, grid, line, values_of

_HALVINGS = 53


def ease(clip: Clip, easing: str) -> Clip:
    """Returns the clip that shows at time t the pose of the time D · e(t / D), with duration D and the easing
    e of `maths.easing`; markers move with their poses.

    Curves become keys close together (60 a second); held keys stay held.

    :raises UnknownNameError: when there is no easing of this name.
    """
    if easing not in EASINGS:
        raise UnknownNameError("easing", easing, EASINGS)
    if clip.duration <= 0 or easing == "linear":
        return clip
    even = np.linspace(0, clip.duration, int(np.ceil(clip.duration * PER_SECOND)) + 1)
    times = np.unique(np.concatenate([even, _when(grid(clip, 0), clip.duration, easing)]).astype(np.float32))
    poses = clip.sample(clip.duration * EASINGS[easing](times.astype(np.float64) / clip.duration))

    def eased(channel: Channel) -> Channel:
        if channel.interpolation == "STEP":
            return replace(channel, times=_when(channel.times, clip.duration, easing).astype(np.float32))
        return line(channel, times, values_of(channel, poses))

    markers = tuple(
        marker._replace(time=float(_when(np.array([marker.time]), clip.duration, easing)[0]))
        for marker in clip.markers
    )
    return replace(clip, channels=tuple(eased(channel) for channel in clip.channels), markers=markers)


def _when(times: Floats, duration: float, easing: str) -> Floats:
    """The times at which the eased clip shows the poses of `times`: the easing's inverse, by bisection."""
    way = np.clip(times.astype(np.float64) / duration, 0, 1)
    low, high = np.zeros_like(way), np.ones_like(way)
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        is_before = EASINGS[easing](middle) < way
        low, high = np.where(is_before, middle, low), np.where(is_before, high, middle)
    return high * duration
