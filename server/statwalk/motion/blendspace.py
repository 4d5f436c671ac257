"""Blend spaces: a motion between several clips, each of which stands at a place in a space of one or two parameters.

The clips run in step: their phases are matched at their sync markers, and a lap takes the weighted mean of their durations.
Whatever way they go is weighted as well, lap for lap, so that a foot which stands in all of them stands in the blend.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property, reduce
from itertools import combinations

import numpy as np

from statwalk.errors import ContentError
from statwalk.maths import quat
from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.phases import Marks, Warp, warp
from statwalk.maths.pose import Pose
from statwalk.motion.single import Single

NEAREST = 1e-6
"""how far two places must be from each other at least"""
_ROUNDS = 4
"""of the secant that finds how far a step goes; one is exact between two markers"""


@dataclass(frozen=True, eq=False)
class BlendSpace:
    """K motions of one clip each. Time is counted in seconds of the longest clip, phases are those of the first."""

    motions: tuple[Single, ...]
    places: Floats
    """(K, 1) or (K, 2) float64: where each stands"""
    columns: tuple[int, ...]
    """which parameters are the axes"""
    marks: tuple[Marks, ...]
    """of each clip: name and phase 0…1"""
    loop: bool

    @property
    def rest(self) -> Pose:
        """The unbatched pose of all that is not keyed."""
        return self.motions[0].rest

    @property
    def travels(self) -> bool:
        """Whether any of them moves the root."""
        return any(motion.travels for motion in self.motions)

    @property
    def duration(self) -> float:
        """Seconds of the longest clip."""
        return max(motion.clip.duration for motion in self.motions)

    @cached_property
    def warps(self) -> tuple[Warp, ...]:
        """From the phases of the first clip to those of each."""
        return tuple(warp(self.marks[0], marks, self.loop) for marks in self.marks)

    def weights(self, parameters: Floats) -> Floats:
        """(N, K) of each clip for parameters (N, P)."""
        points = parameters[:, self.columns].clip(self.places.min(0), self.places.max(0))
        return along_a_line(points[:, 0], self.places[:, 0]) if len(self.columns) == 1 else gradient_band(points, self.places)

    def rate(self, times: Floats, seconds: Floats, parameters: Floats) -> Floats:
        """(N,) factor of time for the next `seconds` (N,) at `times` (N,): a lap takes the weighted mean of the clips' durations.

        In between the pace is that of the weighted mean of their phases, so that a clip which is alone keeps its own.
        """
        weights = self.weights(parameters)
        lap = _total(weights[:, k] * motion.clip.duration for k, motion in enumerate(self.motions))
        factor = np.where(lap > 0, self.duration / np.where(lap > 0, lap, 1), 1.0)
        if all(warp.is_identity for warp in self.warps):
            return factor
        phase, wanted = self._phase(times), seconds / np.where(lap > 0, lap, 1)
        begin = self._mean_phase(phase, weights)
        step = wanted
        for _ in range(_ROUNDS):
            gone = self._mean_phase(phase + step, weights) - begin
            step = step * np.where(gone > 0, wanted / np.where(gone > 0, gone, 1), 1)
        return factor * np.where(wanted > 0, step / np.where(wanted > 0, wanted, 1), 1)

    def _mean_phase(self, phase: Floats, weights: Floats) -> Floats:
        """(N,) the weighted mean of the clips' phases, laps counted through, at the first one's `phase` (N,)."""
        return _total(weights[:, k] * warp.lift(phase) for k, warp in enumerate(self.warps))

    def pose(self, times: Floats, parameters: Floats) -> Pose:
        """Poses (N, …) at `times` (N,) seconds."""
        phases = self._phase(times)

        def sample(k: int, rows: Ints) -> Pose:
            lifted = self.warps[k].lift(phases[rows])
            return self.motions[k].clip.sample((lifted - np.floor(lifted) if self.loop else lifted) * self.motions[k].clip.duration)

        return self._mixed(self.weights(parameters), sample)

    def first(self, parameters: Floats) -> Pose:
        """The poses (N, …) that the clips begin with."""
        return self._mixed(self.weights(parameters), lambda k, rows: self.motions[k].clip.sample(np.zeros(len(rows))))

    def way(self, start: Floats, end: Floats, wraps: Ints, parameters: Floats) -> Floats:
        """x, z, yaw (N, 3) from `start` to `end` (N,) seconds through `wraps` (N,) repeats, in the frame of the actor at `start`."""
        weights, begin, reached = self.weights(parameters), self._phase(start), self._phase(end) + wraps
        return _total(self._own_way(k, begin, reached) * weights[:, k, None] for k in range(len(self.motions)))

    def _own_way(self, k: int, start: Floats, end: Floats) -> Floats:
        """The way (N, 3) of one clip between phases of the first, laps counted through."""
        root, duration = self.motions[k].root, self.motions[k].clip.duration
        begin, reached = self.warps[k].lift(start), self.warps[k].lift(end)
        first, last = (np.floor(begin), np.floor(reached)) if self.loop else (np.zeros(len(start)), np.zeros(len(start)))
        return root.displacement((begin - first) * duration, (reached - last) * duration, (last - first).astype(np.int64))

    def _phase(self, times: Floats) -> Floats:
        return times / self.duration if self.duration > 0 else np.zeros_like(times)

    def _mixed(self, weights: Floats, sample: Callable[[int, Ints], Pose]) -> Pose:
        """The poses that `sample` gives for each clip and the rows it has a weight in: straight, rotations on the side of those before."""
        mixed = Pose(*(np.zeros((len(weights), *array.shape), np.float32) for array in self.rest))
        for k in range(len(self.motions)):
            rows = weights[:, k].nonzero()[0]
            if len(rows):
                _add(mixed, sample(k, rows), weights[rows, k].astype(np.float32), rows)
        return mixed._replace(rotation=quat.normalize(mixed.rotation))


def _add(mixed: Pose, pose: Pose, weight: Floats, rows: Ints) -> None:
    """Adds weighted poses (n, …) to the `rows` of others."""
    parts = pose._replace(rotation=quat.align(mixed.rotation[rows], pose.rotation))
    for array, part in zip(mixed, parts, strict=True):
        array[rows] += part * weight.reshape(-1, *(1,) * (part.ndim - 1))


def along_a_line(points: Floats, places: Floats) -> Floats:
    """Weights (N, K) of K places (K,) at `points` (N,): linear between neighbours, the ends hold."""
    order = np.argsort(places)
    rising = places[order]
    within = points.clip(rising[0], rising[-1])
    row = (rising.searchsorted(within, "right") - 1).clip(0, len(places) - 2)
    part = (within - rising[row]) / (rising[row + 1] - rising[row])
    weights, everyone = np.zeros((len(points), len(places))), np.arange(len(points))
    weights[everyone, order[row]] = 1 - part
    weights[everyone, order[row + 1]] = part
    return weights


def gradient_band(points: Floats, places: Floats) -> Floats:
    """Weights (N, K) of K places (K, 2) at `points` (N, 2) (Johansen, *Automated Semi-Procedural Animation*, 2009, section 6.3).

    A place has its full say where it lies, and none from each other place on, measured along the line between the two.
    """
    say = []
    for here in range(len(places)):
        offset = points - places[here]
        bands = [_band(offset, places[other] - places[here]) for other in range(len(places)) if other != here]
        say.append(reduce(np.minimum, bands))
    total = _total(say)
    return np.stack([one / total for one in say], -1)


def _band(offset: Floats, across: Floats) -> Floats:
    """1…0 from a place to another that lies `across` (2,) from it, at `offset` (N, 2) from the first."""
    done = (offset[:, 0] * across[0] + offset[:, 1] * across[1]) / (across[0] * across[0] + across[1] * across[1])
    left: Floats = 1 - done.clip(0, 1)
    return left


def check_places(places: Floats, names: Sequence[str]) -> None:
    """Raises ContentError for fewer than two places (K, A), and for two that are one; `names` are those of the clips."""
    if len(places) < 2:
        raise ContentError(f"a blend needs two clips or more, not {len(places)}")
    for one, other in combinations(range(len(places)), 2):
        if np.abs(places[one] - places[other]).max() < NEAREST:
            raise ContentError(f"{names[one]} and {names[other]} stand at the same place")


def _total(parts: Iterable[Floats]) -> Floats:
    """The sum, in their order."""
    total: Floats = reduce(np.add, parts)
    return total


Motion = Single | BlendSpace
"""what a state plays"""
