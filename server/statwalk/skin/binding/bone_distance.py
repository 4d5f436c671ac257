"""Which bone is nearest to a point, and which bones it sees through the inside of the body."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from statwalk.maths.arrays import Bools, Floats, Ints
from statwalk.skin.binding.volume import Volume

AT_ONCE = 1 << 20
"""distances in one block"""
CANDIDATES = 6
"""the nearest bones of a point of which one must be seen"""
SAMPLES = 12
"""points on a line of sight"""
HIDDEN = 2
"""of them may lie outside: voxels are coarse"""
FLESH = 0.8
"""share of the depth of the body around a bone that does not count as distance: a head is nearer to its own
bone in its middle than to an arm beside it
"""
THINNEST = 1e-3
"""share of a distance that always counts"""
TIE = 1e-4
"""relative difference of distances up to which two bones are equally near"""


class BoneLines(NamedTuple):
    """B straight bones: `start` and `end` (B,3), and `joint` (B,), the row of the joint that each belongs
    to.
    """

    start: Floats
    end: Floats
    joint: Ints

    def take(self, rows: Ints | Bools) -> BoneLines:
        """Returns some of the bones."""
        return BoneLines(self.start[rows], self.end[rows], self.joint[rows])


class Sight(NamedTuple):
    """What N points see.

    nearest    (N,) the nearest bone, seen or not
    distance   (N,B) the distance of each bone
    chosen     (N,B) the nearest of the bones that the point sees; several if they are equally near; none
               where the point sees no bone
    """

    nearest: Ints
    distance: Floats
    chosen: Bools


def distances(points: Floats, bones: BoneLines) -> Floats:
    """Returns (N,B): the distance of N points from B bones."""
    out = np.empty((len(points), len(bones.joint)))
    for rows in _blocks(len(points), len(bones.joint)):
        out[rows] = np.linalg.norm(points[rows, None] - _feet(points[rows], bones), axis=-1)
    return out


def sight(points: Floats, bones: BoneLines, volume: Volume) -> Sight:
    """Returns the nearest bones that N points see: the straight line to the bone stays in the body (Baran and
    Popović 2007, 4).
    """
    count = len(points), len(bones.joint)
    distance, chosen = np.empty(count), np.zeros(count, bool)
    for rows in _blocks(len(points), max(len(bones.joint), CANDIDATES * SAMPLES)):
        feet = _feet(points[rows], bones)
        distance[rows] = np.linalg.norm(points[rows, None] - feet, axis=-1)
        chosen[rows] = _chosen(points[rows], feet, distance[rows], volume)
    return Sight(distance.argmin(1), distance, chosen)


def _feet(points: Floats, bones: BoneLines) -> Floats:
    """(N,B,3) the point of each bone that is nearest to each of N points."""
    along = bones.end - bones.start
    squared = np.maximum((along**2).sum(-1), 1e-300)
    share = np.clip(((points[:, None] - bones.start) * along).sum(-1) / squared, 0, 1)
    feet: Floats = bones.start + share[..., None] * along
    return feet


def _chosen(points: Floats, feet: Floats, distance: Floats, volume: Volume) -> Bools:
    """(N,B) the nearest bones that points see, measured from the flesh around the bones."""
    apart = np.maximum(distance - FLESH * volume.depth_at(feet), THINNEST * distance)
    candidates = np.argsort(apart, 1, kind="stable")[:, :CANDIDATES]
    targets = np.take_along_axis(feet, candidates[..., None], 1)
    steps = np.linspace(0, 1, SAMPLES)[:, None, None, None]
    line = points[None, :, None] * (1 - steps) + targets[None] * steps
    is_seen = (~volume.holds(line)).sum(0) <= HIDDEN
    near = np.where(is_seen, np.take_along_axis(apart, candidates, 1), np.inf)
    chosen = np.zeros(distance.shape, bool)
    limit = near.min(1, keepdims=True) * (1 + TIE)
    np.put_along_axis(chosen, candidates, is_seen & (near <= limit), 1)
    return chosen


def _blocks(count: int, width: int) -> Iterator[slice]:
    step = max(1, AT_ONCE // max(width, 1))
    return (slice(start, start + step) for start in range(0, count, step))
