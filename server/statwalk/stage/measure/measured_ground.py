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
STEP, FARTHEST = 0.002, 0.15
"""metres: how finely, and how far, the way out of the ground is looked for at the sides"""


class Spot(NamedTuple):
    """Where a trial begins: metres on the stage, and radians."""

    x: float = 0.0
    z: float = 0.0
    heading: float = 0.0


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


def depths(pieces: Sequence[GroundDefinition], points: Floats) -> Floats:
    """Returns how far points (…, 3) are from the nearest place outside the ground: upwards, or to a side."""
    flat = points.reshape(-1, 3)
    depth = (heights_at(pieces, flat[:, 0], flat[:, 2]) - flat[:, 1]).clip(0)
    rows = np.flatnonzero(depth > DEEP)
    x, y, z = flat[rows].T
    for u, v in ((1, 0), (-1, 0), (0, 1), (0, -1)):
        for away in np.arange(STEP, min(FARTHEST, depth[rows].max(initial=0)), STEP):
            is_out = (heights_at(pieces, x + away * u, z + away * v) <= y) & (away < depth[rows])
            depth[rows] = np.where(is_out, away, depth[rows])
    found: Floats = depth.reshape(points.shape[:-1])
    return found
