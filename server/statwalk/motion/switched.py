"""Switching between keys in place of going from one to the next (RTCA 2.2, Listing 2). DS2, KF7."""

from __future__ import annotations

from dataclasses import replace

from statwalk.motion.clip import Channel, Clip
from statwalk.motion.keys.interpolations import half_way


def switched(clip: Clip) -> Clip:
    """Returns the clip with linear keys that switch half-way to the next key; other keys stay.

    The clip keeps its length and its last pose.
    """
    return replace(clip, channels=tuple(_switched(channel) for channel in clip.channels))


def _switched(channel: Channel) -> Channel:
    if channel.interpolation != "LINEAR" or len(channel.times) == 1:
        return channel
    times, values = half_way(channel.times, channel.values)
    return replace(channel, times=times, values=values, interpolation="STEP")
