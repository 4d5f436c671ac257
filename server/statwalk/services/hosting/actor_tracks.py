"""Gathers the poses of each actor over a span of a stage's past."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from statwalk.errors import StageError
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose
from statwalk.services.publish.gltf_frames import check_size
from statwalk.stage.stage import Stage
from statwalk.stage.state.frame import CastFrame

MOST_TICKS = 3_600
MOST_JOINT_POSES = 500_000
"""joints of all actors in all ticks: one minute at 60 Hz of two actors with 67 joints"""


class RootPlaces(NamedTuple):
    """Where an actor is at each tick."""

    positions: Floats
    """(T, 3) metres"""
    headings: Floats
    """(T,) radians about +Y"""


@dataclass
class ActorTrack:
    """The ticks of one actor from tick `first` on: for each its cast, and its row in it."""

    first: int
    rows: list[tuple[CastFrame, int]] = field(default_factory=list)

    def poses(self) -> Pose:
        """Returns the local poses (T, …)."""
        poses = (cast.pose.take(row) for cast, row in self.rows)
        return Pose(*(np.stack(arrays) for arrays in zip(*poses, strict=True)))

    def roots(self) -> RootPlaces:
        """Returns the places."""
        positions = np.stack([cast.root_position[row] for cast, row in self.rows])
        return RootPlaces(positions, np.array([cast.heading[row] for cast, row in self.rows]))


def tracks_of(stage: Stage, first: int, last: int) -> dict[int, ActorTrack]:
    """Returns the ticks `first` to `last` of a stage, by actor; moves the stage to `last`.

    :raises StageError: when the stage does not have the ticks, or when they are too many.
    """
    if not first <= last < first + MOST_TICKS:
        raise StageError(
            f"a span goes from a tick to the same or a later tick, {MOST_TICKS} ticks at most; not from "
            f"{first} to {last}"
        )
    tracks: dict[int, ActorTrack] = {}
    joints = 0
    for tick in range(first, last + 1):
        stage.seek(tick)
        check_size(stage.frame.casts)
        for cast in stage.frame.casts:
            joints += cast.pose.translation.shape[0] * cast.pose.translation.shape[1]
            for row, actor in enumerate(cast.ids.tolist()):
                tracks.setdefault(actor, ActorTrack(tick)).rows.append((cast, row))
        if joints > MOST_JOINT_POSES:
            raise StageError(
                f"a span holds at most {MOST_JOINT_POSES} joint poses (joints x actors x ticks); tick "
                f"{tick} exceeds it: ask for fewer ticks"
            )
    return tracks
