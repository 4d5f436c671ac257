"""What is left of the motions that actors have turned from: offsets of the pose that die out, and the old way
of the root.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import slow_inertialize
from numpy.typing import NDArray
from statwalk.maths.arrays import Bools, Floats, Ints
from statwalk.maths.easing import smoothstep
from statwalk.maths.pose import Pose

ROUNDING_S = 1e-6
"""less than this left of a transition is nothing: 12 times 1/60 s is 0.2 s"""


class Beginning(NamedTuple):
    """Transitions that begin, of n actors: of one layer each. (Of several at once, see
    `test_layers_change_together`.)
    """

    rows: Ints
    """(n,)"""
    seconds: Floats
    """(n, L) how long each layer's lasts; 0 where none begins"""
    quintic: Bools
    """(n, L) the curve"""
    offset: Floats
    """(n, D) what was shown at the tick before, less the new motions"""
    rate: Floats
    """(n, D) its velocity per second"""


class Fading(NamedTuple):
    """The transitions of N actors in L layers; over where `elapsed` has reached `duration`.

    What is shown has the offsets of all on top.
    """

    start: Floats
    """(N, L, D) float32: the offset at its beginning, see `motion.inertialize`"""
    rate: Floats
    """(N, L, D) float32: its velocity then, per second"""
    elapsed: Floats
    """(N, L) float64 seconds"""
    duration: Floats
    """(N, L) float64 seconds"""
    quintic: NDArray[np.bool_]
    """(N, L) the curve, else a cubic"""
    way: Floats
    """(N, 3) float64: x, z, yaw that the old motion of the base went in a tick"""

    @classmethod
    def none(cls, actors: int, layers: int, size: int) -> Fading:
        """No transition."""
        offset, clock = np.zeros((actors, layers, size), np.float32), np.zeros((actors, layers))
        return cls(offset, offset, clock, clock, np.zeros((actors, layers), bool), np.zeros((actors, 3)))

    def with_layers(self, order: Sequence[int]) -> Fading:
        """The layers in another order; -1 stands for a new one."""
        size = self.start.shape[2]
        new = Fading.none(len(self.way), 1, size)
        parts = [
            np.concatenate([ours, blank], 1)[:, list(order)]
            for ours, blank in zip(self[:5], new[:5], strict=True)
        ]
        return Fading(parts[0], parts[1], parts[2], parts[3], parts[4], self.way)

    def begun(self, new: Beginning, moved: Bools, way: Floats, dt: float) -> Fading:
        """With transitions started at the tick before this one; `moved` (L, D): what each layer moves, `way`
        (n, 3) what was gone then.

        What others still have on top is their own; the rest goes to the layer that begins.
        """
        fading = Fading._make(array.copy() for array in self)
        offset, rate = self._less_others(new, dt)
        for layer in range(len(moved)):
            turns = new.seconds[:, layer] > 0
            rows = new.rows[turns]
            fading.start[rows, layer] = np.where(moved[layer], offset[turns], np.float32(0))
            fading.rate[rows, layer] = np.where(moved[layer], rate[turns], np.float32(0))
            fading.elapsed[rows, layer], fading.duration[rows, layer] = 0.0, new.seconds[turns, layer]
            fading.quintic[rows, layer] = new.quintic[turns, layer]
        base = new.seconds[:, 0] > 0
        fading.way[new.rows[base]] = way[base]
        return fading

    def replaced(self, rows: Ints, seconds: Floats, jump: tuple[Floats, Floats], way: Floats) -> Fading:
        """Returns a copy in which the rows (n,) have one cubic transition of `seconds` (n,) for all layers,
        in place of their transitions before.
        """
        fading = Fading._make(array.copy() for array in self)
        fading.elapsed[rows], fading.duration[rows], fading.quintic[rows] = 0.0, 0.0, False
        fading.start[rows, 0], fading.rate[rows, 0] = jump
        fading.duration[rows, 0], fading.way[rows] = seconds, way
        return fading

    def advanced(self, dt: float) -> Fading:
        """A tick of `dt` seconds later."""
        elapsed = self.elapsed + dt
        return self._replace(elapsed=np.where(elapsed + ROUNDING_S < self.duration, elapsed, self.duration))

    @property
    def is_under_way(self) -> Bools:
        """(N, L) bool."""
        return self.elapsed < self.duration

    @property
    def left(self) -> Floats:
        """(N, L) 1…0 of the transition."""
        passed: Floats = np.where(
            self.duration > 0, self.elapsed / np.where(self.duration > 0, self.duration, 1), 1
        )
        return 1 - passed

    def on(self, pose: Pose) -> Pose:
        """The poses (N, …) with what is left of the offsets on top."""
        rows = np.flatnonzero(self.is_under_way.any(1))
        if not len(rows):
            return pose
        offset = self.offsets(rows, self.is_under_way[rows])
        if len(rows) == len(self.start):
            return slow_inertialize.add(pose, offset)
        blended = pose.copy()
        for array, part in zip(blended, slow_inertialize.add(pose.take(rows), offset), strict=True):
            array[rows] = part
        return blended

    def offsets(self, rows: Ints, which: Bools, earlier: float = 0.0) -> Floats:
        """What is left (n, D) on some rows of the transitions `which` (n, L), so many seconds before now; the
        layers' in their order.
        """
        if which.shape[1] == 1 and which.all():
            return self._of_layer(rows, 0, earlier)
        total = np.zeros((len(rows), self.start.shape[2]), np.float32)
        for layer in range(which.shape[1]):
            ours = which[:, layer]
            if ours.any():
                total[ours] += self._of_layer(rows[ours], layer, earlier)
        return total

    def blended_way(self, way: Floats) -> Floats:
        """The way (N, 3) of this tick: from the old motion's to the new one's (root motion is blended by
        velocity).
        """
        is_under_way = self.is_under_way[:, 0]
        if not is_under_way.any():
            return way
        weight = smoothstep(1 - self.left[:, 0])[:, None]
        return np.where(is_under_way[:, None], self.way + (way - self.way) * weight, way)

    def _of_layer(self, rows: Ints, layer: int, earlier: float) -> Floats:
        elapsed = np.maximum(self.elapsed[rows, layer] - earlier, 0.0)
        clocks = elapsed, self.duration[rows, layer], self.quintic[rows, layer]
        return slow_inertialize.decay(self.start[rows, layer], self.rate[rows, layer], *clocks)

    def _less_others(self, new: Beginning, dt: float) -> tuple[Floats, Floats]:
        """Offset and velocity (n, D) without what other layers still have on top and keep."""
        others = self.is_under_way[new.rows] & ~(new.seconds > 0)
        if not others.any():
            return new.offset, new.rate
        now, before = (self.offsets(new.rows, others, earlier) for earlier in (0.0, dt))
        return new.offset - now, new.rate - (now - before) / np.float32(dt)
