"""Root tracks: the place of a motion's root over time, and the composition of places and root motion."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from statwalk.maths.arrays import Floats
from statwalk.maths.columns import lock_fields
from statwalk.maths.elementary import sincos


@dataclass(frozen=True, eq=False)
class RootTrack:
    """The place of a motion's root over time, interpolated linearly."""

    times: Floats
    """(K,) float64 seconds"""
    places: Floats
    """(K, 3) float64: x, z, yaw"""

    def __post_init__(self) -> None:
        lock_fields(self)

    def at(self, times: Floats) -> Floats:
        """Returns places (N, 3) at `times` (N,) seconds; the ends hold."""
        if len(self.times) == 1:
            standing: Floats = self.places.repeat(len(times), 0)
            return standing
        key = (self.times.searchsorted(times, "right") - 1).clip(0, len(self.times) - 2)
        part = (times - self.times[key]) / (self.times[key + 1] - self.times[key])
        start = self.places[key]
        places: Floats = start + (self.places[key + 1] - start) * part.clip(0, 1)[:, None]
        return places


STANDING = RootTrack(np.zeros(1), np.zeros((1, 3)))


def compose(place: Floats, way: Floats) -> Floats:
    """Returns the place after root motion `way` (N, 3), given in the frame of `place` (N, 3)."""
    sine, cosine = sincos(place[:, 2])
    x, z = way[:, 0], way[:, 1]
    return place + np.stack([x * cosine + z * sine, z * cosine - x * sine, way[:, 2]], -1)


def relative(origin: Floats, place: Floats) -> Floats:
    """Returns `place` (N, 3) in the frame of `origin` (N, 3)."""
    way = place - origin
    sine, cosine = sincos(origin[:, 2])
    x, z = way[:, 0], way[:, 1]
    return np.stack([x * cosine - z * sine, z * cosine + x * sine, way[:, 2]], -1)


def moving(track: RootTrack, duration: float, velocity: tuple[float, float]) -> RootTrack:
    """Returns the track of a motion of `duration` seconds with a straight way added to it: `velocity`,
    x and z (m/s) in the frame of the track.
    """
    standing = track is STANDING
    times = np.array([0.0, duration]) if standing else track.times
    places = np.zeros((2, 3)) if standing else track.places
    return RootTrack(times, places + times[:, None] * np.array([*velocity, 0.0]))
