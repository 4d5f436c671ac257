"""Squash and stretch: a joint and all that hangs on it change their form and keep their volume."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from itertools import pairwise

import numpy as np

from statwalk.errors import ContentError
from statwalk.maths.arrays import Floats
from statwalk.motion.clip import Clip
from statwalk.motion.keys.channel import Channel
from statwalk.motion.principles.chosen_joints import check_joints

AXES = ("x", "y", "z")
_LONGEST_STEP = 0.05
"""of ln stretch between two keys: glTF's cubic then keeps the volume to 1e-6"""
SMALLEST, LARGEST = 0.1, 10.0


def squash(clip: Clip, joint: int, stretch: Mapping[float, float], axis: str = "y") -> Clip:
    """Returns the clip with `joint` (a row) stretched along its own `axis` by a factor s, and by 1/√s across
    it: its volume stays, to 1e-6.

    stretch: s by time (seconds); in between s is linear, the ends hold. A factor below 1 squashes.

    :raises ContentError: when the axis is not x, y or z, there is no such joint, a factor is not 0.1 to 10, a
        time is negative or endless, or the clip keys the joint's scale already.
    """
    _check(clip, joint, stretch, axis)
    times, factors = _fine(stretch)
    along = AXES.index(axis)
    values = np.empty((len(times), 3, 3))
    slope = np.diff(factors) / np.diff(times) if len(times) > 1 else np.zeros(0)
    arrive, leave = np.append(slope[:1], slope), np.append(slope, slope[-1:])
    if not len(slope):
        arrive = leave = np.zeros(1)
    across = 1 / np.sqrt(factors)
    for row, rate in enumerate((arrive, None, leave)):
        values[:, row] = (across if rate is None else -0.5 * across / factors * rate)[:, None]
        values[:, row, along] = factors if rate is None else rate
    values = values * clip.rest.scale[joint]
    channel = Channel(joint, "scale", times.astype(np.float32), values.astype(np.float32), "CUBICSPLINE")
    return replace(clip, channels=(*clip.channels, channel), duration=max(clip.duration, float(times[-1])))


def _check(clip: Clip, joint: int, stretch: Mapping[float, float], axis: str) -> None:
    if axis not in AXES:
        raise ContentError(f"an axis is x, y or z, not {axis!r}")
    check_joints(clip, [joint])
    if (
        not stretch
        or not all(0 <= time < np.inf for time in stretch)
        or not all(SMALLEST <= s <= LARGEST for s in stretch.values())
    ):
        raise ContentError(f"a stretch needs times from 0 and factors of {SMALLEST:g} to {LARGEST:g}")
    if any(channel.joint == joint and channel.path == "scale" for channel in clip.channels):
        raise ContentError(f"the clip {clip.name} keys the scale of this joint already")


def _fine(stretch: Mapping[float, float]) -> tuple[Floats, Floats]:
    """Times and factors (K,), so close together that no factor differs much from the next."""
    keys = sorted(stretch.items())
    times, factors = [keys[0][0]], [keys[0][1]]
    for (start, small), (end, large) in pairwise(keys):
        parts = max(1, int(np.ceil(abs(np.log(large / small)) / _LONGEST_STEP)))
        way = np.arange(1, parts + 1) / parts
        between = small * (large / small) ** way
        part = (between - small) / (large - small) if large != small else way
        times += (start + (end - start) * part).tolist()
        factors += between.tolist()
    return np.array(times), np.array(factors)
