"""Records ticks of a stage's past as one animated GLB."""

from __future__ import annotations

from collections.abc import Mapping

from statwalk.errors import StageError, UnknownNameError
from statwalk.files.gltf.recording import recording_glb
from statwalk.files.gltf.recording_draft import Recorded
from statwalk.machine.definition.framing import Framing
from statwalk.services.hosting.actor_tracks import ActorTrack, tracks_of
from statwalk.stage.stage import Stage


def recorded(stage: Stage, first: int, last: int, camera: tuple[Framing, int | None] | None = None) -> bytes:
    """Returns the ticks `first` to `last` of a stage as a GLB; time 0 is tick `first`.

    camera: a framing, and the actor that a camera follows (None: the first). Moves the stage to `last`.

    :raises StageError: when the stage does not have the ticks, when they are too many for one file, or when a
        camera finds no actor in them.
    :raises UnknownNameError: when the actor to be watched is not in these ticks.
    """
    tracks = tracks_of(stage, first, last)
    names = {actor.id: actor.name for actor in stage.actors}
    actors = {
        actor: _recorded(track, first, names.get(actor, f"actor {actor}")) for actor, track in tracks.items()
    }
    shot = (_watched(actors, camera[1]), camera[0]) if camera else None
    return recording_glb(list(actors.values()), stage.rate, stage.before_tick, shot)


def _watched(actors: Mapping[int, Recorded], watched: int | None) -> Recorded:
    """The actor with a number; None: the first."""
    if not actors:
        raise StageError("a camera needs an actor to follow, and there is none in these ticks")
    wanted = next(iter(actors)) if watched is None else watched
    if wanted not in actors:
        raise UnknownNameError("actor", str(wanted), map(str, actors))
    return actors[wanted]


def _recorded(track: ActorTrack, first: int, name: str) -> Recorded:
    character, roots = track.rows[0][0].role.character, track.roots()
    return Recorded(name, character, track.poses(), roots.positions, roots.headings, track.first - first)
