"""Exaggeration: a motion scaled about its mean pose."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

import numpy as np

from statwalk.errors import ContentError
from statwalk.maths import quat
from statwalk.maths.arrays import Floats
from statwalk.motion.clip import Clip
from statwalk.motion.keys.channel import Channel
from statwalk.motion.principles.chosen_joints import check_joints
from statwalk.motion.principles.resample import PER_SECOND, grid, line, values_of

MOST = 10.0


def exaggerate(clip: Clip, factor: float, joints: Collection[int] | None = None) -> Clip:
    """Returns the clip with each property's way from its mean over time multiplied by `factor`: above 1
    livelier, below 1 calmer, 0 the mean pose.

    Rotations q become m · exp(factor · log(m⁻¹ q)). `joints`: rows of the joints that change; None: all.
    Held keys stay held; other curves become keys close together (60 a second).

    :raises ContentError: when `factor` is not 0 to 10, or there is no such joint.
    """
    check_joints(clip, joints or ())
    if not 0 <= factor <= MOST:
        raise ContentError(f"an exaggeration should be 0 to {MOST:g}, it is {factor:g}")
    if clip.duration <= 0:
        return clip
    even = np.linspace(0, clip.duration, int(np.ceil(clip.duration * PER_SECOND)) + 1)
    at_even, times = clip.sample(even[:-1]), grid(clip)
    poses = clip.sample(times)

    def scaled(channel: Channel) -> Channel:
        if joints is not None and channel.joint not in joints:
            return channel
        middle = mean(values_of(channel, at_even), channel.path == "rotation")
        if channel.interpolation == "STEP":
            return replace(channel, values=_scaled(channel.values, middle, factor, channel))
        return line(channel, times, _scaled(values_of(channel, poses), middle, factor, channel))

    return replace(clip, channels=tuple(scaled(channel) for channel in clip.channels))


def mean(values: Floats, is_turn: bool) -> Floats:
    """Returns the mean (n,) of values (K, n); of rotations the normalised sum, on the side of the first."""
    exact = values.astype(np.float64)
    if not is_turn:
        return np.asarray(exact.mean(0))
    sides = np.where(quat.dot(exact[:1], exact) < 0, -1.0, 1.0)
    total = (exact * sides[:, None]).sum(0)
    return quat.normalize(total) if quat.dot(total, total) > 1e-12 else exact[0]


def _scaled(values: Floats, middle: Floats, factor: float, channel: Channel) -> Floats:
    exact = values.astype(np.float64)
    if channel.path != "rotation":
        return (middle + factor * (exact - middle)).astype(np.float32)
    way = quat.to_rotation_vector(quat.mul(quat.conjugate(middle)[None], quat.normalize(exact)))
    return quat.mul(middle[None], quat.from_rotation_vector(factor * way)).astype(np.float32)
