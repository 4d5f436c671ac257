"""Blend spaces: a motion between several clips, each at a position in a space of one or two parameters.

The clips run in step: their phases are matched at their sync markers, and a lap takes the weighted mean of
their durations. Their root motion is weighted as well, lap by lap, so that a foot which stands still in every
clip stands still in the blend.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations

import numpy as np

from statwalk.errors import ContentError
from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.columns import lock_fields
from statwalk.maths.phases import Marks, Warp, warp
from statwalk.maths.pose import Pose
from statwalk.motion.sampling.poses import poses_at, rates_at, ways_gone, weights_at
from statwalk.motion.single import Single
from statwalk.motion.tables.build import tables_of
from statwalk.motion.tables.motion_tables import MotionTables

NEAREST = 1e-6
"""the least distance between two positions"""


@dataclass(frozen=True, eq=False)
class BlendSpace:
    """K motions of one clip each.

    Time is in seconds of the longest clip, phases are phases of the first clip.
    """

    motions: tuple[Single, ...]
    places: Floats
    """(K, 1) or (K, 2) float64: the position of each clip"""
    columns: tuple[int, ...]
    """the parameters that are the axes"""
    marks: tuple[Marks, ...]
    """name and phase 0…1 of each marker, for each clip"""
    loop: bool

    def __post_init__(self) -> None:
        lock_fields(self)

    @property
    def members(self) -> tuple[Single, ...]:
        """Returns the clips."""
        return self.motions

    @property
    def rest(self) -> Pose:
        """Returns the rest pose (unbatched) that stands in for channels without keys."""
        return self.motions[0].rest

    @property
    def travels(self) -> bool:
        """Returns whether any clip moves the root."""
        return any(motion.travels for motion in self.motions)

    @property
    def duration(self) -> float:
        """Returns the seconds of the longest clip."""
        return max(motion.clip.duration for motion in self.motions)

    @cached_property
    def warps(self) -> tuple[Warp, ...]:
        """Returns the warps from the phases of the first clip to the phases of each clip."""
        return tuple(warp(self.marks[0], marks, self.loop) for marks in self.marks)

    @cached_property
    def tables(self) -> MotionTables:
        """Returns the tables of this motion alone."""
        return tables_of((self,), self.rest)

    def weights(self, parameters: Floats) -> Floats:
        """Returns (N, K) the weight of each clip for parameters (N, P): on a line linear between two
        neighbours, in a plane by gradient bands.

        A clip has full weight at its own position and none from every other clip's position on, measured
        along the line between the two (Johansen, *Automated Semi-Procedural Animation*, 2009, section 6.3).
        """
        return weights_at(self.tables, parameters)

    def rate(self, times: Floats, seconds: Floats, parameters: Floats) -> Floats:
        """Returns (N,) the factor of time for the next `seconds` (N,) at `times` (N,): a lap takes the
        weighted mean of the clips' durations.

        Within a lap the pace follows the weighted mean of the clips' phases, so that a single clip keeps its
        own pace.
        """
        return rates_at(self.tables, times, seconds, parameters)

    def pose(self, times: Floats, parameters: Floats) -> Pose:
        """Returns the poses (N, …) at `times` (N,) seconds: the weighted means, rotations summed on one side,
        then normalised.
        """
        return poses_at(self.tables, self.rest, times, parameters)

    def first(self, parameters: Floats) -> Pose:
        """Returns the poses (N, …) at the start of the clips."""
        return poses_at(self.tables, self.rest, np.zeros(len(parameters)), parameters, start=True)

    def way(self, start: Floats, end: Floats, wraps: Ints, parameters: Floats) -> Floats:
        """Returns the root motion x, z, yaw (N, 3) from `start` to `end` (N,) seconds through `wraps` (N,)
        repeats, in the frame of the actor at `start`.
        """
        return ways_gone(self.tables, start, end, wraps, parameters)


def check_places(places: Floats, names: Sequence[str]) -> None:
    """Checks the positions (K, A) of the clips `names`.

    :raises ContentError: when there are fewer than two positions, or two clips have the same position.
    """
    if len(places) < 2:
        raise ContentError(f"a blend needs two clips or more, not {len(places)}")
    for first, second in combinations(range(len(places)), 2):
        if np.abs(places[first] - places[second]).max() < NEAREST:
            raise ContentError(f"{names[first]} and {names[second]} stand at the same place")


Motion = Single | BlendSpace
"""the motion of a state"""
