"""The uneven ground of a machine as its measure sees it: its height, what is inside it, and where trials
begin on it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from statwalk.machine.definition.ground_definition import GroundDefinition
from statwalk.maths.arrays import Floats
from statwalk.solve.foot_targets import MEAN_STEP, MEAN_STEPS

DEEP = 0.001
"""metres: a point that is less deep below the ground is not looked for at its sides"""
STEP, FARTHEST = 0.001, 0.15
"""metres: how finely, and how far, the way out of the ground is looked for at the sides"""


class Spot(NamedTuple):
    """Where a trial begins: metres on the stage, and radians."""

    x: float = 0.0
    z: float = 0.0
    heading: float = 0.0

    def plain(self) -> dict[str, float]:
        """Returns the place as files and answers have it, to the millimetre and in degrees."""
        turn = float(np.degrees(self.heading))
        return {"x": round(self.x, 3), "z": round(self.z, 3), "heading_deg": round(turn, 1)}

    @property
    def words(self) -> str:
        """Returns the place for people: `x 0, z 1.65, heading 180°`."""
        return "x {x:g}, z {z:g}, heading {heading_deg:g}°".format(**self.plain())


def places_on(pieces: Sequence[GroundDefinition]) -> list[Spot]:
    """Returns where trials begin: at the origin, and in the middle of every piece, with both headings along
    the longer side of the whole ground.
    """
    if not pieces:
        return [Spot()]
    low = np.min([piece.corner for piece in pieces], 0)
    width, length = np.max([piece.opposite for piece in pieces], 0) - low
    ahead = 0.0 if length >= width else np.pi / 2
    middles = [np.mean([piece.corner, piece.opposite], 0).tolist() for piece in pieces]
    return [Spot(), *(Spot(x, z, ahead + turn) for x, z in middles for turn in (0.0, np.pi))]


def heights_at(pieces: Sequence[GroundDefinition], x: Floats, z: Floats) -> Floats:
    """Returns the heights of the ground at places: where pieces overlap the highest counts, beside them the
    floor is at 0.
    """
    heights: Floats = np.zeros(np.shape(x))
    for x0, z0, x1, z1, level, along_x, along_z in (piece.numbers for piece in pieces):
        inside = (x >= x0) & (x <= x1) & (z >= z0) & (z <= z1)
        heights = np.where(inside, np.maximum(heights, level + along_x * x + along_z * z), heights)
    return heights


def mean_heights(pieces: Sequence[GroundDefinition], places: Sequence[Spot], unit: float) -> Floats:
    """Returns (N,) the heights that roots have at places: the mean of the ground before and behind them."""
    x, z, heading = np.array(places).T[..., None]
    steps = np.arange(-MEAN_STEPS, MEAN_STEPS + 1)
    away, weights = steps * MEAN_STEP * unit, MEAN_STEPS + 1 - abs(steps)
    ground = heights_at(pieces, x + away * np.sin(heading), z + away * np.cos(heading))
    means: Floats = (weights * ground).sum(-1) / weights.sum()
    return means


def depths(pieces: Sequence[GroundDefinition], points: Floats, known: Floats | float = 0.0) -> Floats:
    """Returns how far points (…, 3) are from the nearest place outside the ground: upwards, or to a side.

    `known` (…,): for points that are no deeper than this no way out to a side is looked for.
    """
    depth = (heights_at(pieces, points[..., 0], points[..., 2]) - points[..., 1]).clip(0)
    is_deep = depth > np.maximum(known, DEEP)
    depth[is_deep] = _least(pieces, points[is_deep], depth[is_deep])
    return depth


def _least(pieces: Sequence[GroundDefinition], points: Floats, depth: Floats) -> Floats:
    """(K,) the depths of points (K, 3) that are as far below the ground as `depth`, or less to a side."""
    left = np.arange(len(points))
    for away in np.arange(STEP, min(FARTHEST, depth.max(initial=0)), STEP):
        left = left[depth[left] > away]
        x, y, z = points[left].T
        sides = ((away, 0), (-away, 0), (0, away), (0, -away))
        is_out = np.any([heights_at(pieces, x + u, z + v) <= y for u, v in sides], 0)
        depth[left[is_out]] = away
    return depth
