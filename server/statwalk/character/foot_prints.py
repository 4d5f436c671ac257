"""What feet need on uneven ground: the prints of their soles, the joints that a foot moves, and where clips
put feet down.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from statwalk.character.body_bones import ancestors
from statwalk.character.character import Character
from statwalk.character.feet import Foot
from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.elementary import atan2, sincos
from statwalk.motion.single import Single
from statwalk.rig.evaluate import world_from_local

DECIMALS = 6
"""sums over the skin differ in their last bits from processor to processor; a tick needs the same bits"""
Contacts = tuple[Single, int, Sequence[tuple[float, float]]]
"""a motion of one clip, the number of a foot, and the spans of phase in which the foot stands"""
USUAL_LEG = 0.85
"""metres: a leg of this length has the unit 1"""


def foot_print(foot: Foot, rest: Floats, ahead: Floats) -> Floats:
    """Returns (4,) as `FootTables.print`, for matrices (J, 3, 4) of the joints at rest and the horizontal
    unit vector (3,) in which the foot points.
    """
    places = from_ankle(foot, rest, ahead, foot.skin.at(rest))
    ends = np.array([places.min(0), places.max(0)]).T
    return np.concatenate([ends.mean(1), np.diff(ends)[:, 0] / 2]).round(DECIMALS)


def from_ankle(foot: Foot, rest: Floats, ahead: Floats, points: Floats) -> Floats:
    """Returns how far (metres) points (K, 3) of a foot at rest are from its ankle: (K, 2) forward and to the
    left.
    """
    x, _, z = (points - rest[foot.ankle, :, 3]).T
    return np.stack([x * ahead[0] + z * ahead[2], x * ahead[2] - z * ahead[0]], -1)


def unit_of(lengths: Sequence[float]) -> float:
    """Returns the power of two (metres) that is nearest to the mean length of legs, for the walker's 1."""
    mean = sum(lengths) / max(len(lengths), 1)
    return 2.0 ** round(math.log2(mean / USUAL_LEG)) if mean > 0 else 1.0


def in_units(ground: NDArray[np.float64], unit: float) -> NDArray[np.float64]:
    """Returns pieces of ground (G, 7), in metres, in units: slopes stay."""
    scaled: NDArray[np.float64] = ground / np.array([unit] * 5 + [1.0, 1.0])
    return scaled


def beside(rest: Floats, feet: Sequence[Foot]) -> NDArray[np.int32]:
    """Returns (F,) the foot whose hip is nearest to that of each, if they are so mutually; else -1."""
    hips = rest[[foot.hip for foot in feet], :, 3]
    away = np.linalg.norm(hips[:, None] - hips, axis=-1) + np.where(np.eye(len(feet)) > 0, np.inf, 0.0)
    nearest = away.argmin(1) if len(feet) > 1 else np.zeros(len(feet), np.int64)
    mutual = nearest[nearest] == np.arange(len(feet)) if len(feet) > 1 else np.zeros(len(feet), bool)
    return np.where(mutual, nearest, -1).astype(np.int32)


def joints_below(character: Character, feet: Sequence[Foot], joints: Ints) -> list[Ints]:
    """Returns for each foot the rows of `joints` (n,) that are its ankle or below it."""
    skeleton = character.skeleton
    paths = [ancestors(skeleton, joint) for joint in joints.tolist()]
    return [np.flatnonzero([foot.ankle in path for path in paths]) for foot in feet]


def landings(
    character: Character,
    feet: Sequence[Foot],
    left: NDArray[np.float64],
    places: Sequence[Floats],
    contacts: Sequence[Contacts],
) -> NDArray[np.float64]:
    """Returns (spans, 3) as `FootTables.landing`; `left` (F, 3) the directions to the left of the feet in the
    frames of their ankles; `places` (K, 2) for each foot, where the points of its sole are on its print.
    """
    rows = [np.zeros((0, 3))]
    for motion, number, spans in contacts:
        times = np.array([down % 1.0 for down, _ in spans]) * motion.clip.duration
        if len(times):
            world = world_from_local(character.skeleton, motion.clip.sample(times)).astype(np.float64)
            to_left = (world[:, feet[number].ankle, :, :3] * left[number]).sum(-1)
            yaw = atan2(-to_left[:, 2], to_left[:, 0])
            sine, cosine = sincos(yaw)
            points = feet[number].skin.at(world)
            first = points[..., 1].round(DECIMALS).argmin(1)  # it rolls over the point that touches first
            touches = points[np.arange(len(times)), first]
            along, across = places[number][first].T
            x = touches[:, 0] - along * sine - across * cosine
            z = touches[:, 2] - along * cosine + across * sine
            rows.append(np.stack([x, z, yaw], -1))
    return np.concatenate(rows, dtype=np.float64).round(DECIMALS)
