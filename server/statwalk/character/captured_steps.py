"""Finds when the foot of a captured motion stands, and how far it is above where it stands."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from statwalk.maths.arrays import Bools, Floats

STANDING_SHARE = 5.0
"""percent: a joint of the foot stands when it is as low as in so much of the clip"""
LOW, SLOW, LEAST = 0.025, 0.45, 0.015
"""in legs: a joint of a foot that stands is at most so far above the floor, and so fast in a second; a foot
in the air is at least so high
"""
UNEVEN, STEP = 0.06, 0.6
"""in legs: a captured floor is at most so uneven; seconds within which a foot comes down on it"""
EASE = 0.05
"""seconds in which a foot leaves the ground, and comes down to it"""


class CapturedSteps(NamedTuple):
    """The steps of a foot.

    stands  (F,) whether ankle or toes stand
    above   (F,) metres that the lowest part of the foot is above where it stands
    floor   (F,) metres that the floor is higher than where the ankle stands lowest
    """

    stands: Bools
    above: Floats
    floor: Floats


def steps_of(joints: Sequence[Floats], leg: float, times: Floats) -> CapturedSteps:
    """Returns the steps of a foot: `joints` are the places (F, 3) of its ankle, and of its toes if they are
    known; `leg` the length of the leg, `times` (F,) seconds.
    """
    floors = [_floor(place, leg, times) for place in joints]
    heights = [place[:, 1] - floor for place, floor in zip(joints, floors, strict=True)]
    stands = np.zeros(len(times), bool)
    for place, height in zip(joints, heights, strict=True):
        stands |= (height < LOW * leg) & (_speed(place, times) < SLOW * leg)
    stands = _without_gaps(stands, times)
    lowest: Floats = np.min(heights, axis=0)
    in_air = 1 - _eased(stands, times)
    floor = floors[0] - standing_height(joints[0])
    return CapturedSteps(stands, np.maximum(lowest, LEAST * leg) * in_air, floor)


def standing_height(place: Floats) -> float:
    """Returns the height at which a joint of a foot stands, from its places (F, 3)."""
    return float(np.percentile(place[:, 1], STANDING_SHARE))


def _floor(place: Floats, leg: float, times: Floats) -> Floats:
    """The heights (F,) at which a joint stands."""
    from scipy.ndimage import minimum_filter1d, uniform_filter1d

    lowest = standing_height(place)
    if len(times) < 2:
        return np.full(len(times), lowest)
    frames = _frames(2 * STEP, times)
    near = minimum_filter1d(place[:, 1], frames, mode="nearest")
    floor: Floats = uniform_filter1d(np.clip(near, lowest, lowest + UNEVEN * leg), frames, mode="nearest")
    return floor


def _frames(seconds: float, times: Floats) -> int:
    """An odd number of frames, no more than all to both sides of one."""
    half = max(1, round(seconds / 2 / float(np.median(np.diff(times)))))
    return 2 * min(half, len(times) - 1) + 1


def _without_gaps(stands: Bools, times: Floats) -> Bools:
    """A foot that stands does not leave the ground for a moment only."""
    from scipy.ndimage import binary_closing

    if len(times) < 2:
        return stands
    frames = _frames(2 * EASE, times)
    padded = np.pad(stands, frames, mode="edge")
    closed: Bools = binary_closing(padded, np.ones(frames))[frames:-frames]
    return closed


def _speed(place: Floats, times: Floats) -> Floats:
    if len(times) < 2:
        return np.zeros(len(times))
    speed: Floats = np.linalg.norm(np.gradient(place, times, axis=0), axis=-1)
    return speed


def _eased(stands: Bools, times: Floats) -> Floats:
    """1 where the foot stands, and less for a moment before and after."""
    if len(times) < 2 or not stands.any():
        return stands.astype(np.float64)
    at = np.flatnonzero(stands)
    following = at[np.minimum(np.searchsorted(at, np.arange(len(times))), len(at) - 1)]
    before = at[np.maximum(np.searchsorted(at, np.arange(len(times)), "right") - 1, 0)]
    away = np.minimum(np.abs(times[following] - times), np.abs(times - times[before]))
    part = np.clip(1 - away / EASE, 0, 1)
    eased: Floats = part * part * (3 - 2 * part)
    return eased
