"""Filters a clip: captured motion without its noise and spikes (KF8, FAQ Q18)."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from statwalk.errors import ContentError
from statwalk.maths import filters
from statwalk.maths.arrays import Floats
from statwalk.motion.clip import Channel, Clip

HIGHEST_CUTOFF = 1_000.0
MOST_SAMPLES = 4_000_000
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

    Translations, rotations and scales of LINEAR keys are filtered, others stay. Keys at uneven times become
    keys at even times, as many a second as where they are densest.

    :raises ContentError: when the cutoff is no number of Hz from 0 to 1,000.
    """
    wanted = Filter(low_pass, spikes)
    return replace(clip, channels=tuple(_filtered(channel, wanted) for channel in clip.channels))


def _filtered(channel: Channel, wanted: Filter) -> Channel:
    if channel.interpolation != "LINEAR" or len(channel.times) < 3:
        return channel
    even = _even(channel)
    values: Floats = np.asarray(even.values, np.float64)
    rate = (len(even.times) - 1) / float(even.times[-1] - even.times[0])
    if even.path == "rotation":
        values = filters.without_rotation_spikes(values) if wanted.spikes else values
        values = filters.low_pass_rotations(values, rate, wanted.low_pass) if wanted.low_pass else values
    else:
        values = filters.without_spikes(values) if wanted.spikes else values
        values = filters.low_pass(values, rate, wanted.low_pass) if wanted.low_pass else values
    return replace(even, values=values.astype(np.float32))


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
