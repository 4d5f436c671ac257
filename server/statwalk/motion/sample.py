"""The pose of a clip at a time: for one actor, or for all that play it at once."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose
from statwalk.motion.track import Track


def wrap(times: Floats, duration: float) -> Floats:
    """Times of a motion that loops: t modulo its duration (0 where it has none)."""
    return np.mod(times, duration) if duration > 0 else np.zeros_like(times)


def sample(tracks: Iterable[Track], base: Pose, times: Floats) -> Pose:
    """Poses (N, …) float32 at `times` (N,) float64 seconds.

    `base` (unbatched) is the pose of all that has no track. Before a channel's first key its first value holds, after its last the last.
    """
    pose = Pose(*(array[None].repeat(len(times), 0) for array in base))
    by_path = pose._asdict()
    for track in tracks:
        values = track.values(times)
        if track.path == "weights":
            pose.weights[:, track.target] = values[..., 0]
        else:
            by_path[track.path][:, track.target] = values
    return pose
