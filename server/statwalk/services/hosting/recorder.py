"""Records ticks of a stage's past as one animated GLB."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from statwalk.errors import StageError
from statwalk.files.gltf.recording import recording_glb
from statwalk.files.gltf.recording_draft import Recorded
from statwalk.maths.pose import Pose
from statwalk.services.publish.gltf_frames import check_size
from statwalk.stage.stage import Stage
from statwalk.stage.state.frame import CastFrame

MOST_TICKS = 3_600
MOST_JOINT_POSES = 500_000
"""joints of all actors in all ticks: one minute at 60 Hz of two actors with 67 joints"""


@dataclass
class ActorTrack:
    """The ticks of one actor from tick `first` of the recording on: for each its cast, and its row in it."""

    first: int
    rows: list[tuple[CastFrame, int]] = field(default_factory=list)


def recorded(stage: Stage, first: int, last: int) -> bytes:
    """Returns the ticks `first` to `last` of a stage as a GLB; time 0 is tick `first`.

    Moves the stage to `last`.

    :raises StageError: when the stage does not have the ticks, or when they are too many for one file.
    """
    if not first <= last < first + MOST_TICKS:
        raise StageError(
            f"a recording goes from a tick to the same or a later tick, {MOST_TICKS} ticks at most; not from "
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
                tracks.setdefault(actor, ActorTrack(tick - first)).rows.append((cast, row))
        if joints > MOST_JOINT_POSES:
            raise StageError(
                f"a recording holds at most {MOST_JOINT_POSES} joint poses (joints x actors x ticks); tick "
                f"{tick} exceeds it: ask for fewer ticks"
            )
    names = {actor.id: actor.name for actor in stage.actors}
    return recording_glb(
        [_recorded_actor(track, names.get(actor, f"actor {actor}")) for actor, track in tracks.items()],
        stage.rate,
        stage.before_tick,
    )


def _recorded_actor(track: ActorTrack, name: str) -> Recorded:
    rows = track.rows
    poses = Pose(
        *(np.stack(arrays) for arrays in zip(*(cast.pose.take(row) for cast, row in rows), strict=True))
    )
    positions = np.stack([cast.root_position[row] for cast, row in rows])
    headings = np.array([cast.heading[row] for cast, row in rows])
    return Recorded(name, rows[0][0].role.character, poses, positions, headings, track.first)
