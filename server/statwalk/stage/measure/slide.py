"""How feet hold the ground: how far soles slide over it, and how far the skin sinks into it."""

from __future__ import annotations

import numpy as np

from statwalk.character.feet import Foot
from statwalk.character.skin_points import SkinPoints
from statwalk.maths.arrays import Bools, Floats
from statwalk.stage.measure.trials import Recording, placed

NEAR = 0.006
"""metres: a sole point that is lower stands on the floor"""


def slides(recording: Recording, feet: tuple[Foot, ...], watched: Bools) -> Floats:
    """Returns (N,) metres: the farthest that a sole point moves over the floor in one contact of a foot.

    A contact lasts while any point of the sole is near the floor; a point counts from tick to tick while it
    is near itself: wholly on the floor, less above it (`2 - 2 ** (height / NEAR)`: Zhang et al.,
    *Mode-Adaptive Neural Networks*, 2018). `watched` (T, N): the ticks that count.
    """
    farthest = np.zeros(recording.heading.shape[1])
    for foot in feet:
        points = placed(
            foot.skin.at(recording.world).astype(np.float64), recording.position, recording.heading
        )
        is_near = (points[..., 1] < NEAR) & watched[..., None]
        higher = np.maximum(points[1:, ..., 1], points[:-1, ..., 1]).clip(0, NEAR)
        counts = (is_near[1:] & is_near[:-1]) * (2 - 2 ** (higher / NEAR))
        steps = np.linalg.norm(np.diff(points[..., ::2], axis=0), axis=-1) * counts
        way = np.zeros(points.shape[1:3])
        for near, step in zip(is_near[1:], steps, strict=True):
            way = np.where(near.any(-1)[:, None], way + step, 0)
            farthest = np.maximum(farthest, way.max(-1, initial=0))
    return farthest


def sinks(recording: Recording, skin: SkinPoints, watched: Bools) -> Floats:
    """Returns (N,) metres: how far the lowest point of the skin is below the floor."""
    if not skin.count:
        return np.zeros(recording.heading.shape[1])
    lowest = np.stack([skin.heights(world).min(-1) for world in recording.world]) + recording.position[..., 1]
    sunk: Floats = -np.where(watched, lowest, 0).min(0)
    return sunk.clip(0)
