"""A motion of one clip, played in place, and its root motion: the motion of a state that does not blend."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

import numpy as np

from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.phases import Warp, warp
from statwalk.maths.pose import Pose
from statwalk.motion.clip import Clip
from statwalk.motion.root_track import RootTrack
from statwalk.motion.sampling.poses import poses_at, ways_gone
from statwalk.motion.tables.build import tables_of
from statwalk.motion.tables.motion_tables import MotionTables


@dataclass(frozen=True, eq=False)
class Single:
    """One clip in place, and its root motion. It ignores parameters (N, P)."""

    clip: Clip
    root: RootTrack
    ground_speed: tuple[float, float] = (0.0, 0.0)
    """x, z (m/s): what the root track has besides the root motion of the clip"""

    places: ClassVar[Floats] = np.zeros((1, 0))
    columns: ClassVar[tuple[int, ...]] = ()
    warps: ClassVar[tuple[Warp, ...]] = (warp((), ()),)

    @property
    def members(self) -> tuple[Single, ...]:
        """Returns this motion as the only member."""
        return (self,)

    @property
    def loop(self) -> bool:
        """Returns whether the clip repeats."""
        return self.clip.loop

    @property
    def rest(self) -> Pose:
        """Returns the rest pose (unbatched) that stands in for channels without keys."""
        return self.clip.rest

    @property
    def travels(self) -> bool:
        """Returns whether the motion moves the root."""
        return len(self.root.times) > 1

    @cached_property
    def tables(self) -> MotionTables:
        """Returns the tables of this motion alone."""
        return tables_of((self,), self.rest)

    def pose(self, times: Floats, parameters: Floats) -> Pose:  # noqa: ARG002 - all motions have one interface
        """Returns the poses (N, …) at `times` (N,) seconds."""
        return poses_at(self.tables, self.rest, times)

    def first(self, parameters: Floats) -> Pose:
        """Returns the poses (N, …) at the start of the motion."""
        return poses_at(self.tables, self.rest, np.zeros(len(parameters)), start=True)

    def rate(self, times: Floats, seconds: Floats, parameters: Floats) -> Floats:  # noqa: ARG002 - as above
        """Returns (N,) the factor of time, always 1."""
        return np.ones(len(times))

    def way(self, start: Floats, end: Floats, wraps: Ints, parameters: Floats) -> Floats:
        """Returns the root motion x, z, yaw (N, 3) from `start` to `end` (N,) seconds through `wraps` (N,)
        repeats, in the frame of the actor at `start`.
        """
        return ways_gone(self.tables, start, end, wraps, parameters)
