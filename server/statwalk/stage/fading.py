"""What is left of the motions that actors have turned from: offsets of the pose that die out, and the old way of the root."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from statwalk.maths.arrays import Bools, Floats, Ints
from statwalk.maths.easing import smoothstep
from statwalk.maths.pose import Pose
from statwalk.motion import inertialize

ROUNDING_S = 1e-6
"""less than this left of a transition is nothing: 12 times 1/60 s is 0.2 s"""


class Fading(NamedTuple):
    """The transition of each of N actors; over where `elapsed` has reached `duration`."""

    start: Floats
    """(N, D) float32: the offset at its beginning, see `motion.inertialize`"""
    rate: Floats
    """(N, D) float32: its velocity then, per second"""
    elapsed: Floats
    """(N, L) float64 seconds"""
    duration: Floats
    """(N, L) float64 seconds"""
    way: Floats
    """(N, 3) float64: x, z, yaw that the old motion went in a tick"""

    @classmethod
    def none(cls, actors: int, layers: int, size: int) -> Fading:
        """No transition."""
        offset, clock = np.zeros((actors, size), np.float32), np.zeros((actors, layers))
        return cls(offset, offset, clock, clock, np.zeros((actors, 3)))

    def begun(self, rows: Ints, duration: Floats, offset: tuple[Floats, Floats], way: Floats) -> Fading:
        """With transitions of some rows started at the tick before this one."""
        fading = Fading(*(array.copy() for array in self))
        fading.start[rows], fading.rate[rows] = offset
        fading.elapsed[rows], fading.duration[rows], fading.way[rows] = 0.0, duration[:, None], way
        return fading

    def advanced(self, dt: float) -> Fading:
        """A tick of `dt` seconds later."""
        elapsed = self.elapsed + dt
        return self._replace(elapsed=np.where(elapsed + ROUNDING_S < self.duration, elapsed, self.duration))

    @property
    def is_under_way(self) -> Bools:
        """(N,) bool."""
        return self.elapsed[:, 0] < self.duration[:, 0]

    @property
    def left(self) -> Floats:
        """(N, L) 1…0 of the transition."""
        passed: Floats = np.where(self.duration > 0, self.elapsed / np.where(self.duration > 0, self.duration, 1), 1)
        return 1 - passed

    def on(self, pose: Pose) -> Pose:
        """The poses (N, …) with what is left of the offsets on top."""
        rows = self.is_under_way.nonzero()[0]
        if not len(rows):
            return pose
        clocks = self.elapsed[rows, 0], self.duration[rows, 0]
        offset = inertialize.decay(self.start[rows], self.rate[rows], *clocks)
        if len(rows) == len(self.start):
            return inertialize.add(pose, offset)
        blended = pose.copy()
        for array, part in zip(blended, inertialize.add(pose.take(rows), offset), strict=True):
            array[rows] = part
        return blended

    def blended_way(self, way: Floats) -> Floats:
        """The way (N, 3) of this tick: from the old motion's to the new one's (root motion is blended by velocity)."""
        if not self.is_under_way.any():
            return way
        weight = smoothstep(1 - self.left[:, 0])[:, None]
        return np.where(self.is_under_way[:, None], self.way + (way - self.way) * weight, way)
