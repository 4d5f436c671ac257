"""How feet hold the ground: how far soles slide over it, and how far the skin sinks into it.

`ground`: the pieces of uneven ground; without any, the floor is at 0.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from statwalk.character.feet import Foot
from statwalk.character.skin_points import SkinPoints
from statwalk.machine.definition.ground_definition import GroundDefinition
from statwalk.maths.arrays import Bools, Floats
from statwalk.stage.measure.measured_ground import depths, heights_at
from statwalk.stage.measure.trials import Recording, placed

NEAR = 0.006
"""metres: a sole point that is lower stands on the floor"""


def slides(
    recording: Recording, feet: tuple[Foot, ...], watched: Bools, ground: Sequence[GroundDefinition] = ()
) -> Floats:
    """Returns (N,) metres: the farthest that a sole point moves over the floor in one contact of a foot.

    A contact lasts while any point of the sole is near the floor; a point counts from tick to tick while it
    is near itself: wholly on the floor, less above it (`2 - 2 ** (height / NEAR)`: Zhang et al.,
    *Mode-Adaptive Neural Networks*, 2018). `watched` (T, N): the ticks that count.
    """
    farthest = np.zeros(recording.heading.shape[1])
    for foot in feet:
        points = soles(recording, foot)
        below = heights_at(ground, points[..., 0], points[..., 2])
        above = points[..., 1] - below
        is_inside = (above < -NEAR) & (below > 0)  # of a step: it came in from the side, and sinks
        is_near = (above < NEAR) & ~is_inside & watched[..., None]
        higher = np.maximum(above[1:], above[:-1]).clip(0, NEAR)
        counts = (is_near[1:] & is_near[:-1]) * (2 - 2 ** (higher / NEAR))
        steps = np.linalg.norm(np.diff(points[..., ::2], axis=0), axis=-1) * counts
        way = np.zeros(points.shape[1:3])
        for near, step in zip(is_near[1:], steps, strict=True):
            way = np.where(near.any(-1)[:, None], way + step, 0)
            farthest = np.maximum(farthest, way.max(-1, initial=0))
    return farthest


def soles(recording: Recording, foot: Foot) -> Floats:
    """Returns the points (T, N, K, 3) of a sole on the stage."""
    return placed(foot.skin.at(recording.world).astype(np.float64), recording.position, recording.heading)


def soles_above(recording: Recording, foot: Foot, ground: Sequence[GroundDefinition] = ()) -> Floats:
    """Returns (T, N, K) metres: how high the points of a sole are above the ground below them."""
    points = soles(recording, foot)
    above: Floats = points[..., 1] - heights_at(ground, points[..., 0], points[..., 2])
    return above


def sinks(
    recording: Recording, skin: SkinPoints, watched: Bools, ground: Sequence[GroundDefinition] = ()
) -> Floats:
    """Returns (N,) metres: how far the deepest point of the skin is below the ground; in a step, from its
    side if that is nearer.
    """
    if not skin.count:
        return np.zeros(recording.heading.shape[1])
    ticks = zip(recording.world, recording.position, recording.heading, watched, strict=True)
    sunk = np.zeros(recording.heading.shape[1])
    for world, position, heading, rows in ticks:
        known = sunk[rows]
        if ground:
            points = placed(skin.at(world[rows]), position[rows], heading[rows])
            deepest = depths(ground, points, known[:, None]).max(-1)
        else:
            deepest = -(skin.heights(world[rows]).min(-1) + position[rows, 1])
        sunk[rows] = np.maximum(known, deepest)
    return sunk
