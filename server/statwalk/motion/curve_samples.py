"""The same key rotations by several interpolations, for comparison: rotation, angle, angular speed and
acceleration over time, sampled from clips as a tick samples them.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from statwalk.maths import quat
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import rest
from statwalk.motion.clip import Clip
from statwalk.motion.keys.interpolations import TimedKeys, rotation_channel

WINDOW, SHORT_WINDOW = 1 / 60, 1 / 480
"""of the whole time: acceleration and speed are measured over as much before and after a moment"""


class CurveSamples(NamedTuple):
    """N samples of a rotation over time.

    rotations (N, 4); angle (N,) from the first key, speed (N,) and acceleration (N,): the lengths of the
    angular velocity and of its change, radians and seconds. Where the speed jumps, at a key, the acceleration
    has a bump, as wide as the measuring.
    """

    rotations: Floats
    angle: Floats
    speed: Floats
    acceleration: Floats


def curve_samples(
    times: Floats, angles: Floats, weights: Floats, interpolation: str, moments: Floats
) -> CurveSamples:
    """Returns keys at `times` (K,) with Euler XYZ `angles` (K, 3) radians and `weights` (K,), interpolated
    and sampled at `moments` (N,); a curve begins and ends at its first and last key time.

    :raises ContentError: when times do not rise, a weight is out of range, or no such curve passes the keys.
    """
    keys = TimedKeys(times, quat.from_euler_xyz(angles), weights)
    channel = rotation_channel(0, keys, angles, interpolation)
    clip = Clip(interpolation, (channel,), float(times[-1]), rest(1))
    rotations = _at(clip, moments)
    return CurveSamples(
        rotations,
        _length(_way(keys.values[:1], rotations)),
        _speed(clip, times, moments),
        _acceleration(clip, times, moments),
    )


def _speed(clip: Clip, times: Floats, moments: Floats) -> Floats:
    """The angular speed (N,), measured between two keys and never across one: at a key it may jump."""
    segment = np.clip(np.searchsorted(times, moments, "right") - 1, 0, len(times) - 2)
    start, end = times[segment], times[segment + 1]
    window = np.minimum(float(times[-1] - times[0]) * SHORT_WINDOW, (end - start) / 2)
    middle = np.clip(moments, start + window, end - window)
    way = _way(_at(clip, middle - window), _at(clip, middle + window))
    return np.asarray(_length(way) / (2 * window))


def _acceleration(clip: Clip, times: Floats, moments: Floats) -> Floats:
    window = float(times[-1] - times[0]) * WINDOW
    middle = np.clip(moments, times[0] + window, times[-1] - window)
    before, here, after = (_at(clip, at) for at in (middle - window, middle, middle + window))
    return _length(_way(here, after) - _way(before, here)) / (window * window)


def _at(clip: Clip, moments: Floats) -> Floats:
    rotations: Floats = clip.sample(moments).rotation[:, 0].astype(np.float64)
    return rotations


def _way(start: Floats, end: Floats) -> Floats:
    """The rotation vectors (N, 3) from one rotation to another."""
    return quat.to_rotation_vector(quat.mul(end, quat.conjugate(start)))


def _length(vectors: Floats) -> Floats:
    x, y, z = vectors.T
    return np.asarray(np.sqrt(x * x + y * y + z * z))
