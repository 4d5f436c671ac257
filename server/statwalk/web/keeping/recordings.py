"""A piece of a stage's past as one animated GLB."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from statwalk.errors import StageError
from statwalk.files.glb.recording import Recorded, recording_glb
from statwalk.maths.pose import Pose
from statwalk.stage.frame import CastFrame
from statwalk.stage.stage import Stage
from statwalk.web.streaming.glbframes import check_size

MOST_TICKS = 3_600
MOST_JOINT_POSES = 500_000
"""joints of all actors in all ticks: a minute of two actors of 67 joints"""


@dataclass
class Seen:
    """An actor from the tick it was first seen at: for each tick its cast and its row there."""

    first: int
    rows: list[tuple[CastFrame, int]] = field(default_factory=list)


def recorded(stage: Stage, first: int, last: int) -> bytes:
    """The ticks `first` to `last` of a stage, poses as they were, time 0 at `first`. Moves the stage to `last`.

    :raises StageError: if the ticks are not there, or too many for one file.
    """
    if not first <= last < first + MOST_TICKS:
        raise StageError(f"a recording goes from a tick to a later one, {MOST_TICKS} ticks at most; not from {first} to {last}")
    seen: dict[int, Seen] = {}
    joints = 0
    for tick in range(first, last + 1):
        stage.seek(tick)
        check_size(stage.frame.casts)
        for cast in stage.frame.casts:
            joints += cast.pose.translation.shape[0] * cast.pose.translation.shape[1]
            for row, actor in enumerate(cast.ids.tolist()):
                seen.setdefault(actor, Seen(tick - first)).rows.append((cast, row))
        if joints > MOST_JOINT_POSES:
            raise StageError(f"{MOST_JOINT_POSES} poses of joints fit into a recording; tick {tick} is too many: ask for fewer ticks")
    names = {actor.id: actor.name for actor in stage.actors}
    return recording_glb([tracked(one, names.get(actor, f"actor {actor}")) for actor, one in seen.items()], stage.rate)


def tracked(seen: Seen, name: str) -> Recorded:
    """An actor's ticks as arrays."""
    poses = Pose(*(np.stack(arrays) for arrays in zip(*(cast.pose.take(row) for cast, row in seen.rows), strict=True)))
    places = np.stack([cast.root_position[row] for cast, row in seen.rows])
    headings = np.array([cast.heading[row] for cast, row in seen.rows])
    return Recorded(name, seen.rows[0][0].role.character, poses, places, headings, seen.first)
