"""A motion of one clip, played in place, and the way it goes: what a state is tied to unless it blends."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.pose import Pose
from statwalk.motion.clip import Clip
from statwalk.motion.root import RootTrack


@dataclass(frozen=True, eq=False)
class Single:
    """One clip in place, and its root motion. It takes no notice of parameters (N, P)."""

    clip: Clip
    root: RootTrack

    @property
    def rest(self) -> Pose:
        """The unbatched pose of all that is not keyed."""
        return self.clip.rest

    @property
    def travels(self) -> bool:
        """Whether it moves the root."""
        return len(self.root.times) > 1

    def pose(self, times: Floats, parameters: Floats) -> Pose:  # noqa: ARG002 - every motion is asked alike
        """Poses (N, …) at `times` (N,) seconds."""
        return self.clip.sample(times)

    def first(self, parameters: Floats) -> Pose:
        """The poses (N, …) that it begins with."""
        return self.clip.sample(np.zeros(len(parameters)))

    def rate(self, times: Floats, seconds: Floats, parameters: Floats) -> Floats:  # noqa: ARG002 - as above
        """(N,) factor of time."""
        return np.ones(len(times))

    def way(self, start: Floats, end: Floats, wraps: Ints, parameters: Floats) -> Floats:  # noqa: ARG002 - as above
        """x, z, yaw (N, 3) from `start` to `end` (N,) seconds through `wraps` (N,) repeats, in the frame of the actor at `start`."""
        return self.root.displacement(start, end, wraps)
