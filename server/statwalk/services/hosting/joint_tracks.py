"""Says where the joints of each actor are over a span of a stage's past, as plain data."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from statwalk.maths import quat, transform
from statwalk.rig.evaluate import world_from_local
from statwalk.services.hosting.actor_tracks import ActorTrack, tracks_of
from statwalk.services.hosting.stage_replies import JointTrack
from statwalk.stage.stage import Stage


def joint_tracks(stage: Stage, first: int, last: int) -> Iterator[JointTrack]:
    """Yields a track for each actor of the ticks `first` to `last`; moves the stage to `last`.

    :raises StageError: when the stage does not have the ticks, or when they are too many.
    """
    tracks = tracks_of(stage, first, last)
    names = {actor.id: actor.name for actor in stage.actors}
    for actor, track in tracks.items():
        stage.before_tick()
        yield _joints(actor, names.get(actor, f"actor {actor}"), track)


def _joints(actor: int, name: str, track: ActorTrack) -> JointTrack:
    skeleton, pose, roots = track.rows[0][0].role.character.skeleton, track.poses(), track.roots()
    joints = world_from_local(skeleton, pose)[..., :, 3].astype(np.float64)
    turns = quat.from_axis_angle((0.0, 1.0, 0.0), roots.headings)
    places = transform.from_trs(roots.positions, turns, np.ones(3))
    return JointTrack(
        actor,
        name,
        tuple(skeleton.names),
        track.first,
        transform.apply(places[:, None], joints),
        pose.rotation.astype(np.float64),
        roots.positions,
        roots.headings,
    )
