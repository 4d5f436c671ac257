"""Filters a clip: captured motion without its noise and spikes (KF8, FAQ Q18)."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from statwalk.errors import ContentError
from statwalk.maths import filters
from statwalk.maths.arrays import Floats
from statwalk.motion.clip import Channel, Clip
from statwalk.motion.principles.resample import grid, line, values_of

HIGHEST_CUTOFF = 1_000.0
MOST_SAMPLES = 4_000_000
SEAM = 1e-3
"""of the range of a loop's values: ends so near to each other meet"""
UNEVEN = 1e-3
"""a share of the time between two keys: keys nearer to an even grid count as even"""


@dataclass(frozen=True)
class Filter:
    """What is taken out of a clip.

    low_pass   Hz: what moves faster goes, without a delay (4 to 10 suits a walk); 0: nothing
    spikes     whether single wild samples are replaced
    """

    low_pass: float = 0.0
    spikes: bool = False

    def __post_init__(self) -> None:
        if not 0 <= self.low_pass <= HIGHEST_CUTOFF:
            raise ContentError(
                f"the cutoff of a low-pass filter is a number of Hz up to {HIGHEST_CUTOFF:g}, not "
                f"{self.low_pass:g}"
            )


def filtered(clip: Clip, low_pass: float = 0.0, spikes: bool = False) -> Clip:
    """Returns the clip without spikes, then without what moves faster than `low_pass` Hz.

    Curves become keys close together (60 a second) first; held keys stay held. Keys at uneven times become
    keys at even times, as many a second as where they are densest. A clip that loops and whose ends meet is
    filtered across its seam.

    :raises ContentError: when the cutoff is no number of Hz from 0 to 1,000.
    """
    wanted = Filter(low_pass, spikes)
    if wanted == Filter():
        return clip
    lines = _as_lines(clip)
    return replace(clip, channels=tuple(_filtered(channel, wanted, clip.loop) for channel in lines))


def _as_lines(clip: Clip) -> list[Channel]:
    """Returns the channels, with LINEAR keys in place of curves."""
    straight = ("LINEAR", "STEP")
    if all(channel.interpolation in straight for channel in clip.channels):
        return list(clip.channels)
    times = grid(clip)
    poses = clip.sample(times)
    return [
        channel if channel.interpolation in straight else line(channel, times, values_of(channel, poses))
        for channel in clip.channels
    ]


def _filtered(channel: Channel, wanted: Filter, is_loop: bool) -> Channel:
    if channel.interpolation != "LINEAR" or len(channel.times) < 3:
        return channel
    even = _even(channel)
    values: Floats = np.asarray(even.values, np.float64)
    if not (is_loop and _ends_meet(values, even.path)):
        return replace(even, values=_clean(even, values, wanted).astype(np.float32))
    once = len(values) - 1  # the last key is the first: three rounds, of which the middle one is kept
    rounds = np.concatenate([values[:-1], values[:-1], values])
    return replace(even, values=_clean(even, rounds, wanted)[once : 2 * once + 1].astype(np.float32))


def _ends_meet(values: Floats, path: str) -> bool:
    """Returns whether the last key shows what the first does."""
    last = -values[-1] if path == "rotation" and values[-1] @ values[0] < 0 else values[-1]
    return bool(np.abs(last - values[0]).max() <= SEAM * max(1.0, float(np.ptp(values, axis=0).max())))


def _clean(even: Channel, values: Floats, wanted: Filter) -> Floats:
    """Returns values (K, n) at the even times of a channel, or several rounds of them, filtered."""
    rate = (len(even.times) - 1) / float(even.times[-1] - even.times[0])
    if even.path == "rotation":
        values = filters.without_rotation_spikes(values) if wanted.spikes else values
        values = filters.low_pass_rotations(values, rate, wanted.low_pass) if wanted.low_pass else values
    else:
        values = filters.without_spikes(values) if wanted.spikes else values
        values = filters.low_pass(values, rate, wanted.low_pass) if wanted.low_pass else values
    return values


def _even(channel: Channel) -> Channel:
    """Returns the channel with keys at even times."""
    times = np.asarray(channel.times, np.float64)
    steps = np.diff(times)
    if (steps.max() - steps.min()) <= UNEVEN * steps.min() + 4 * np.finfo(np.float32).eps * times[-1]:
        return channel
    count = min(MOST_SAMPLES, int(np.ceil((times[-1] - times[0]) / steps.min())) + 1)
    even_times = np.linspace(times[0], times[-1], count)
    return replace(channel, times=even_times.astype(np.float32), values=_values_at(channel, even_times))


def _values_at(channel: Channel, times: Floats) -> Floats:
    values: Floats = np.asarray(channel.values, np.float64)
    if channel.path == "rotation":
        values = filters.continuous(values)
    at = np.stack([np.interp(times, channel.times, column) for column in values.T], -1)
    size = np.sqrt((at * at).sum(-1, keepdims=True)) if channel.path == "rotation" else 1.0
    return (at / size).astype(np.float32)
