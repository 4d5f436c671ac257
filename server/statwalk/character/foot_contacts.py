"""Foot contacts: the spans of a clip in which a foot stands on the ground, found from the clip.

A point of the sole stands where it is low, and slow over the ground; both with hysteresis, relative to the
length of the leg and the speed of the clip. A clip that walks on the spot has its own ground: the one that
runs back under the feet.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np

from statwalk.character.character import Character
from statwalk.character.feet import Foot
from statwalk.machine.definition.feet_definition import Span
from statwalk.maths.arrays import Bools, Floats
from statwalk.motion.clip import Clip
from statwalk.rig.evaluate import world_from_local

RATE = 120
"""poses a second that are looked at"""
MOST_POSES = 4096
LOW = 0.025, 0.045
"""of the leg's length above the ground: a point below the first stands, and stands until it is above the
second
"""
SLOW = 0.25, 0.5
"""leg lengths a second over the ground, likewise"""
SHARE = 0.15, 0.3
"""of the feet's own speed in the clip: the limits of speed are at least these"""
SHORTEST = 0.04
"""seconds: shorter contacts and shorter gaps are none"""
ON_THE_SPOT = 0.35
"""leg lengths a second: if low feet often run alike, at more than this, the ground runs under them"""
ALIKE, VOTES, MOST_VOTES = 0.2, 0.2, 512
"""the share by which alike speeds differ, the share of ticks that have them, how many ticks are compared"""
ROUND = 0.4
"""of the leg's length: how far the joints at the end of a walk are from where they begin, on average; a run
that is cut a frame short of its cycle comes to 0.3
"""


@dataclass(frozen=True)
class FootContact:
    """The spans in which a foot stands, and in which its heel and its ball do."""

    foot: str
    planted: tuple[Span, ...]
    heel: tuple[Span, ...]
    ball: tuple[Span, ...]


@dataclass(frozen=True)
class ClipContacts:
    """The contacts of all feet in a clip; phases 0…1, in the order of the feet."""

    clip: str
    feet: tuple[FootContact, ...]
    drift: tuple[float, float] = (0.0, 0.0)
    """x, z (m/s) of the ground under a clip that walks on the spot: feet that stand move with it"""


def joined(spans: Sequence[Span]) -> tuple[Span, ...]:
    """Returns the spans of a clip that loops: a span at its end and one at its beginning are one, which ends
    beyond 1.
    """
    if len(spans) < 2 or spans[0][0] > 0 or spans[-1][1] < 1:
        return tuple(spans)
    return (*spans[1:-1], (spans[-1][0], 1 + spans[0][1]))


def contacts_of(character: Character, feet: tuple[Foot, ...]) -> dict[str, ClipContacts]:
    """Returns the contacts of all clips of a character, by clip; found once for the same feet."""
    known_feet, known = _known.get(character, (None, {}))
    if known_feet != feet:
        ground, grounds = _grounds(character, feet) if feet else (0.0, [])
        known = {
            name: _contacts(character, clip, feet, ground, grounds) for name, clip in character.clips.items()
        }
        _known[character] = feet, known
    return known


_known: WeakKeyDictionary[Character, tuple[tuple[Foot, ...] | None, dict[str, ClipContacts]]] = (
    WeakKeyDictionary()
)


def _grounds(character: Character, feet: tuple[Foot, ...]) -> tuple[float, list[float]]:
    """The height of the ground: the middle of the lowest heights of the soles in all clips, at rest without
    clips; and for each foot: of more than two each has its own, as paws are not as thick in front as behind.
    """
    rest = world_from_local(character.skeleton, character.bind_pose)[None]
    worlds = [_worlds(character, clip) for clip in character.clips.values()] or [rest]
    lowest = np.array([[foot.skin.heights(world).min() for foot in feet] for world in worlds])
    ground = float(np.median(lowest.min(1)))
    return ground, np.median(lowest, 0).tolist() if len(feet) > 2 else [ground] * len(feet)


def _times(clip: Clip) -> Floats:
    """Times (T,) at which a clip is looked at, both ends among them."""
    return np.linspace(0, clip.duration, min(max(round(clip.duration * RATE), 2) + 1, MOST_POSES))


def _worlds(character: Character, clip: Clip) -> Floats:
    """(T, J, 3, 4) the joints through a clip."""
    return world_from_local(character.skeleton, clip.sample(_times(clip)))


def _contacts(
    character: Character, clip: Clip, feet: tuple[Foot, ...], ground: float, grounds: list[float]
) -> ClipContacts:
    """The contacts of one clip."""
    if not feet or clip.duration <= 0:
        return ClipContacts(clip.name, tuple(FootContact(foot.name, (), (), ()) for foot in feet))
    world, step = _worlds(character, clip), clip.duration / (len(_times(clip)) - 1)
    points = [foot.skin.at(world).astype(np.float64) for foot in feet]
    legs = [foot.length(world[0]) for foot in feet]
    speeds = [np.gradient(track[..., ::2], step, axis=0) for track in points]
    drift = _drift(world, points, speeds, (ground, max(legs), step))
    stands = [
        _stands(track[..., 1] - own, np.linalg.norm(speed - drift, axis=-1), leg)
        for track, own, speed, leg in zip(points, grounds, speeds, legs, strict=True)
    ]
    least = round(SHORTEST / step)
    return ClipContacts(
        clip.name,
        tuple(_foot_contact(foot, track, least) for foot, track in zip(feet, stands, strict=True)),
        (float(drift[0]), float(drift[1])),
    )


def _drift(
    world: Floats, points: Sequence[Floats], speeds: Sequence[Floats], scale: tuple[float, float, float]
) -> Floats:
    """(2,) how fast the ground runs under a clip that walks on the spot: as the lowest points do, if they run
    steadily, the clip comes round, and the character as a whole stays where it is; else 0.
    """
    ground, leg, step = scale
    heights, moving = (np.concatenate(tracks, 1) for tracks in ([track[..., 1] for track in points], speeds))
    lowest, ticks = heights.argmin(1), np.arange(len(heights))
    low = heights[ticks, lowest] < ground + LOW[1] * leg
    if not low.any():
        return np.zeros(2)
    velocity = moving[ticks, lowest][low]
    velocity = velocity[:: -(-len(velocity) // MOST_VOTES)]
    apart = np.linalg.norm(velocity[:, None] - velocity, axis=-1)
    near = apart < np.maximum(ALIKE * np.linalg.norm(velocity, axis=-1), ALIKE * leg)[:, None]
    most = near[int(near.sum(1).argmax())]
    drift: Floats = velocity[most].mean(0)
    pace = _size(drift)
    middle = world[:, :, ::2, 3].mean(1)
    travel = _size(middle[-1] - middle[0]) / (step * (len(world) - 1))
    apart_at_end = float(np.linalg.norm(world[-1, ..., 3] - world[0, ..., 3], axis=-1).mean())
    is_steady = pace > ON_THE_SPOT * leg and most.mean() > VOTES
    runs = is_steady and apart_at_end < ROUND * leg and travel < pace / 4
    return drift if runs else np.zeros(2)


def _size(way: Floats) -> float:
    """The length of a way (2,)."""
    return float(np.sqrt(way[0] * way[0] + way[1] * way[1]))


def _stands(height: Floats, speed: Floats, leg: float) -> Bools:
    """(T, K) whether each point stands: low and slow, with hysteresis."""
    usual = float(np.quantile(speed, 0.9))
    slow = [max(limit * leg, share * usual) for limit, share in zip(SLOW, SHARE, strict=True)]
    begins = (height < LOW[0] * leg) & (speed < slow[0])
    lasts = (height < LOW[1] * leg) & (speed < slow[1])
    stands = begins.copy()
    for tick in range(1, len(stands)):
        stands[tick] |= stands[tick - 1] & lasts[tick]
    return stands


def _foot_contact(foot: Foot, stands: Bools, least: int) -> FootContact:
    """The spans of a foot, of its heel and of its ball."""
    front = foot.is_front
    parts = (stands, stands[:, ~front], stands[:, front])
    return FootContact(foot.name, *(_spans(np.asarray(part.any(1)), least) for part in parts))


def _spans(stands: Bools, least: int) -> tuple[Span, ...]:
    """The spans of phase in which something stands (T,); gaps and spans of fewer than `least` ticks are
    none.
    """
    for value in (True, False):  # first gaps, then contacts
        for first, past in _runs(stands == (not value)):
            if past - first < least and first > 0 and past < len(stands):
                stands[first:past] = value
    last = len(stands) - 1
    return tuple((first / last, min(past, last) / last) for first, past in _runs(stands))


def _runs(flags: Bools) -> list[tuple[int, int]]:
    """First and past of each run of true flags (T,)."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], flags, [False]])))
    return [(int(first), int(past)) for first, past in edges.reshape(-1, 2)]
