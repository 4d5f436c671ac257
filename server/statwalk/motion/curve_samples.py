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


class CurveSamples(NamedTuple):
    """N samples of a rotation over time.

    rotations (N, 4); angle (N,) from the first key, speed (N,) and acceleration (N,): the lengths of the
    angular velocity and of its change, from neighbouring samples; radians and seconds.
    """

    rotations: Floats
    angle: Floats
    speed: Floats
    acceleration: Floats


def curve_samples(
    times: Floats, angles: Floats, weights: Floats, interpolation: str, moments: Floats
) -> CurveSamples:
    """Returns keys at `times` (K,) with Euler XYZ `angles` (K, 3) radians and `weights` (K,), interpolated
    and sampled at even `moments` (N,), N > 2; a curve begins and ends at its first and last key time.

    :raises ContentError: when times do not rise, a weight is out of range, or no such curve passes the keys.
    """
    keys = TimedKeys(times, quat.from_euler_xyz(angles), weights)
    channel = rotation_channel(0, keys, angles, interpolation)
    clip = Clip(interpolation, (channel,), float(times[-1]), rest(1))
    rotations = clip.sample(moments).rotation[:, 0].astype(np.float64)
    gap = moments[1] - moments[0]
    first = quat.mul(quat.conjugate(keys.values[:1]), rotations)
    velocity = quat.to_rotation_vector(quat.mul(rotations[1:], quat.conjugate(rotations[:-1]))) / gap
    change = _length(np.diff(velocity, axis=0)) / gap
    speed = _length(velocity)
    return CurveSamples(
        rotations,
        _length(quat.to_rotation_vector(first)),
        (np.append(speed[:1], speed) + np.append(speed, speed[-1:])) / 2,
        np.concatenate([change[:1], change, change[-1:]]),
    )


def _length(vectors: Floats) -> Floats:
    x, y, z = vectors.T
    return np.asarray(np.sqrt(x * x + y * y + z * z))
