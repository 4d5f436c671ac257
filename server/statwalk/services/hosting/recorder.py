"""Records ticks of a stage's past as one animated GLB."""

from __future__ import annotations

from statwalk.files.gltf.recording import recording_glb
from statwalk.files.gltf.recording_draft import Recorded
from statwalk.services.hosting.actor_tracks import ActorTrack, tracks_of
from statwalk.stage.stage import Stage


def recorded(stage: Stage, first: int, last: int) -> bytes:
    """Returns the ticks `first` to `last` of a stage as a GLB; time 0 is tick `first`.

    Moves the stage to `last`.

    :raises StageError: when the stage does not have the ticks, or when they are too many for one file.
    """
    tracks = tracks_of(stage, first, last)
    names = {actor.id: actor.name for actor in stage.actors}
    return recording_glb(
        [_recorded(track, first, names.get(actor, f"actor {actor}")) for actor, track in tracks.items()],
        stage.rate,
        stage.before_tick,
    )


def _recorded(track: ActorTrack, first: int, name: str) -> Recorded:
    character, roots = track.rows[0][0].role.character, track.roots()
    return Recorded(name, character, track.poses(), roots.positions, roots.headings, track.first - first)
