"""The poses in which the error of a coarser skin counts: rest, and frames of clips that differ most."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from statwalk.character.character import Character
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose
from statwalk.motion.clip import Clip
from statwalk.skin.primitive import Part

CANDIDATES, MOST_TARGETS, POINTS = 48, 32, 200
POSES = 6
"""frames besides the pose at rest"""
GAP = 0.2
"""seconds between frames in which errors are measured, if the work allows"""
MOST_FRAMES, MOST_WORK = 240, 800_000
"""in how many frames errors are measured, and about how many vertices in all of them together"""


class PosedSkin(NamedTuple):
    """What poses a character: its pose at rest, its clips, and the function that gives its vertices."""

    rest: Pose
    clips: Mapping[str, Clip]
    vertices: Callable[[Pose], list[Part]]

    def points(self, pose: Pose) -> Floats:
        """Returns the vertices (V,3) of all parts in a pose, metres."""
        return np.concatenate([part.positions for part in self.vertices(pose)]).astype(np.float64)


def posed_skin(character: Character) -> PosedSkin:
    """Returns what poses a character, with linear skinning."""
    return PosedSkin(character.bind_pose, character.clips, character.skinned("linear").vertices)


def frames(clips: Mapping[str, Clip], count: int) -> list[Pose]:
    """Returns `count` poses, spread evenly over the time of all clips; none if there is no clip."""
    listed = list(clips.values())
    ends = np.cumsum([max(clip.duration, 1e-6) for clip in listed])
    poses = []
    for number in range(count if listed else 0):
        moment = (number + 0.5) / count * ends[-1]
        row = int(np.searchsorted(ends, moment))
        poses.append(listed[row].sample(moment - ends[row] + listed[row].duration))
    return poses


def measured_poses(skin: PosedSkin, vertices: int) -> Iterator[Pose]:
    """Yields the poses in which the errors of so many vertices are measured: every morph target alone, and
    the middles of even parts of each clip; of some clips only if there are more clips than frames.
    """
    yield from _morphed(skin.rest)
    most = min(MOST_FRAMES, MOST_WORK // max(vertices, 1))
    if most < len(skin.clips):
        yield from frames(skin.clips, most)
        return
    gap = max(GAP, sum(clip.duration for clip in skin.clips.values()) / max(most, 1))
    for clip in skin.clips.values():
        count = max(1, round(clip.duration / gap))
        yield from (clip.sample((row + 0.5) / count * clip.duration) for row in range(count))


def telling_poses(skin: PosedSkin) -> list[Pose]:
    """Returns the pose at rest and up to POSES frames, each as different as can be from those before it; the
    targets of morphs count as frames.
    """
    candidates = [skin.rest, *frames(skin.clips, CANDIDATES), *_morphed(skin.rest)]
    whole = [skin.points(pose) for pose in candidates]
    every = max(1, len(whole[0]) // POINTS)
    sampled = np.array([points[::every] for points in whole])
    chosen = _furthest(sampled - sampled.mean(axis=1, keepdims=True), 1 + POSES)
    return [candidates[row] for row in chosen]


def _morphed(rest: Pose) -> list[Pose]:
    """The pose at rest with each of the first morph targets alone."""
    poses = []
    for row in range(min(MOST_TARGETS, len(rest.weights))):
        pose = rest.copy()
        pose.weights[:] = 0
        pose.weights[row] = 1
        poses.append(pose)
    return poses


def _furthest(points: Floats, count: int) -> Sequence[int]:
    """The rows of points (N,V,3), row 0 first, then each time the row that is furthest from those before."""
    chosen, away = [0], np.full(len(points), np.inf)
    while len(chosen) < count:
        apart = np.abs(points - points[chosen[-1]]).max(axis=(1, 2))
        away = np.minimum(away, apart)
        if away.max() <= 0:
            break
        chosen.append(int(away.argmax()))
    return chosen
