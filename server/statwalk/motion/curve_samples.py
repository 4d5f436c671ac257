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

WINDOW = 1 / 60
"""of the whole time: speed and acceleration are measured over as much before and after a moment"""


class CurveSamples(NamedTuple):
    """N samples of a rotation over time.

    rotations (N, 4); angle (N,) from the first key, speed (N,) and acceleration (N,): the lengths of the
    angular velocity and of its change, radians and seconds. A jump of the speed becomes a bump of the
    acceleration, as wide as the measuring.
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
    window = float(times[-1] - times[0]) * WINDOW
    middle = np.clip(moments, times[0] + window, times[-1] - window)
    rotations, before, here, after = (
        clip.sample(at).rotation[:, 0].astype(np.float64)
        for at in (moments, middle - window, middle, middle + window)
    )
    arriving, leaving = _way(before, here) / window, _way(here, after) / window
    return CurveSamples(
        rotations,
        _length(_way(keys.values[:1], rotations)),
        _length(arriving + leaving) / 2,
        _length(leaving - arriving) / window,
    )


def _way(start: Floats, end: Floats) -> Floats:
    """The rotation vectors (N, 3) from one rotation to another."""
    return quat.to_rotation_vector(quat.mul(end, quat.conjugate(start)))


def _length(vectors: Floats) -> Floats:
    x, y, z = vectors.T
    return np.asarray(np.sqrt(x * x + y * y + z * z))
