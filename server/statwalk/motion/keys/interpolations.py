"""The interpolations that a file or a request names, and the channels that they make of keys (FAQ Q17).

KF3, KF4, KF5, KF6, KF7.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from statwalk.maths import curves, quat
from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.squad import squad, squad_tangents
from statwalk.motion.keys.channel import Channel, Interpolation, Path

_DENSE_PER_SECOND, _DENSE_MOST = 60, 64
INTERPOLATIONS: Mapping[str, Interpolation] = {
    "hold": "STEP",  # holds a value until the next key
    "step": "STEP",  # switches half-way between two keys (RTCA Listing 2)
    "linear": "LINEAR",  # rotations: normalised linear interpolation (nlerp)
    "slerp": "LINEAR",
    "squad": "LINEAR",
    "euler linear": "LINEAR",  # the FAQ's own: interpolates each of the three angles
    "b-spline": "BSPLINE",
    "b-spline through": "BSPLINE_THROUGH",
    "nurbs": "NURBS",
    "nurbs through": "NURBS_THROUGH",
}
_MEETS = 1 - 1e-9
"""cosine of half the angle up to which the first and the last rotation of a loop are the same"""
_DENSE = ("linear", "squad", "euler linear")


class TimedKeys(NamedTuple):
    """K keys: times (K,) in seconds, rising; values (K, n); weights (K,), how strongly each key of a NURBS
    pulls.
    """

    times: Floats
    values: Floats
    weights: Floats | None = None


def channel_of(joint: int, path: Path, keys: TimedKeys, interpolation: str) -> Channel:
    """Returns the channel of keys with one of the INTERPOLATIONS.

    :raises ContentError: when the times do not rise, or the values or weights do not fit them.
    """
    times, values = keys.times.astype(np.float32), keys.values.astype(np.float32)
    if interpolation == "step" and len(times) > 1:
        times, values = half_way(times, values)
    weights = keys.weights if interpolation.startswith("nurbs") else None
    return Channel(joint, path, times, values, INTERPOLATIONS[interpolation], key_weights=weights)


def half_way(times: Floats, values: Floats) -> tuple[Floats, Floats]:
    """Returns held keys (K + 1,) that switch half-way between the keys (K,), and end with the last (RTCA 2.2,
    Listing 2).
    """
    half = np.full(len(times) - 1, 0.5)
    middles = (times[:-1] + times[1:]) * times.dtype.type(0.5)
    return (
        np.concatenate([times[:1], middles, times[-1:]]),
        np.concatenate([values[:1], curves.step(values[:-1], values[1:], half), values[-1:]]),
    )


def rotation_channel(
    joint: int, keys: TimedKeys, angles: Floats, interpolation: str, loop: bool = False
) -> Channel:
    """Returns the rotation channel of key quaternions (K, 4); `angles` (K, 3) are the same keys as Euler XYZ
    angles in radians, for `euler linear`. `loop`: squad goes on into the next lap, if its ends meet.

    Clips have no channel for nlerp, squad and angles: keys close together stand for their curve.

    :raises ContentError: as `channel_of`.
    """
    if interpolation not in _DENSE or len(keys.times) == 1:
        return channel_of(joint, "rotation", keys, interpolation)
    before, part, times = _dense(keys.times)
    if interpolation == "euler linear":
        values = quat.from_euler_xyz(
            angles[before] * (1 - part)[:, None] + angles[before + 1] * part[:, None]
        )
    elif interpolation == "linear":
        values = quat.nlerp(keys.values[before], keys.values[before + 1], part)
    else:
        values = _squad(keys, before, part, loop)
    return channel_of(joint, "rotation", TimedKeys(times, values), interpolation)


def _dense(times: Floats) -> tuple[Ints, Floats, Floats]:
    """Times close together between keys: (key before, part of the way 0…1, time)."""
    counts = np.clip(np.ceil(np.diff(times) * _DENSE_PER_SECOND), 1, _DENSE_MOST).astype(np.int64)
    key_before = np.repeat(np.arange(len(counts)), counts)
    part = np.concatenate([np.arange(count) / count for count in counts])
    key_before, part = np.append(key_before, len(counts) - 1), np.append(part, 1.0)
    return key_before, part, times[key_before] * (1 - part) + times[key_before + 1] * part


def _squad(keys: TimedKeys, key_before: Ints, part: Floats, loop: bool) -> Floats:
    """The spherical cubic through the keys. The first key has no neighbour before it, and the last none after
    it: in a loop whose ends meet that is the neighbour of the other, else the key itself, as far away as the
    one that it has.
    """
    aligned, steps = keys.values.copy(), np.diff(keys.times).astype(keys.values.dtype)
    for row in range(1, len(aligned)):
        aligned[row] = quat.align(aligned[row - 1], aligned[row])
    first, last = aligned[0], aligned[-1]
    since, until = np.append(steps[0], steps), np.append(steps, steps[-1])
    if loop and abs(first @ last) > _MEETS:
        first, last = quat.align(first, aligned[-2]), quat.align(last, aligned[1])
        since[0], until[-1] = steps[-1], steps[0]
    before, after = np.vstack([first, aligned[:-1]]), np.vstack([aligned[1:], last])
    into, out_of = squad_tangents(before, aligned, after, since, until)
    return squad(aligned[key_before], out_of[key_before], into[key_before + 1], aligned[key_before + 1], part)
