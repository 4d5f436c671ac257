"""The points of a foot's skin that a tick looks at: the lowest ones; over uneven ground also points all over
the sole and round the heel, since the edge of a step may come between the lowest ones.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from statwalk.character.character import Character
from statwalk.character.feet import Foot
from statwalk.character.foot_prints import DECIMALS
from statwalk.character.skin_points import SkinPoints, bound_points, outermost
from statwalk.maths import transform
from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.elementary import sincos

SLOPES, ROUND = (0.25, 1.2), 8
"""how far the directions lean in which the lowest points are looked for, and how many are all round"""
SLOPES_ON_GROUND, ROUND_ON_GROUND = (0.25, 1.2, 5.0), 16
"""the same on uneven ground, where any corner of the sole may come over the edge of a step"""
SPACING, HIGHEST = 0.025, 0.08
"""metres, for a leg of 0.6 to 1.2 metres: on uneven ground every point of the skin has a chosen one so near,
if it is no farther above the lowest point than HIGHEST
"""
MOST = 120
"""points of a foot at most: a tick looks at all of them"""


class SolePoints(NamedTuple):
    """K points of a foot's skin, the lowest ones first."""

    carriers: Ints
    """(K,) the joints that carry them"""
    places: Floats
    """(K, 3) in the frames of these joints"""
    lowest: int
    """how many of them lie lowest, in the pose of rest or in a foot that leans to some side"""
    spread: int
    """how many of them are all over the sole: the last ones lie foremost, or outermost to another side, in a
    foot that is steep
    """


def sole_points(character: Character, foot: Foot, rest: Floats, unit: float | None) -> SolePoints:
    """Returns the chosen points of a foot's skin.

    `rest` (J, 3, 4): the joints in the pose of rest; `unit`: `FootTables.unit` on uneven ground, None on a
    level floor.
    """
    skin = bound_points(character, foot.joints)
    skin = skin if skin.count else SkinPoints.of_joints_themselves(foot.joints, len(character.skeleton))
    points = skin.at(rest)
    lowest = _lowest(points, is_uneven=unit is not None)
    spread = lowest if unit is None else _spread(points.round(DECIMALS), lowest, unit)
    chosen = spread if unit is None else np.append(spread, _outermost(points, spread, unit))
    carriers = skin.carriers[chosen]
    places = transform.apply(transform.invert(rest[carriers]), points[chosen])
    return SolePoints(carriers, places, len(lowest), len(spread))


def _lowest(points: Floats, *, is_uneven: bool) -> Ints:
    """The rows of the points (V, 3) that lie lowest in the pose of rest and in feet that lean to any side."""
    slopes, count = (SLOPES_ON_GROUND, ROUND_ON_GROUND) if is_uneven else (SLOPES, ROUND)
    straight = [[0.0], [-1.0], [0.0]]
    return outermost(points, np.hstack([straight, _directions(slopes, count, -1.0)]))


def _outermost(points: Floats, chosen: Ints, unit: float) -> Ints:
    """The rows of the low points that lie farthest out in directions that lean upwards, but for `chosen`."""
    low = _low(points, unit)
    directions = _directions(SLOPES_ON_GROUND, ROUND_ON_GROUND, 1.0)
    return np.setdiff1d(low[outermost(points[low], directions)], chosen)[: MOST - len(chosen)]


def _directions(slopes: tuple[float, ...], count: int, up: float) -> Floats:
    """(3, S) directions all round that lean by each of the slopes from the vertical; `up`: 1, for down -1."""
    sine, cosine = sincos(np.arange(count) * (2 * np.pi / count))
    directions = [(c * lean, up, s * lean) for lean in slopes for s, c in zip(sine, cosine, strict=True)]
    return np.array(directions).T


def _low(points: Floats, unit: float) -> Ints:
    """The rows of the points that are no farther above the lowest one than HIGHEST."""
    return np.flatnonzero(points[:, 1] < points[:, 1].min() + HIGHEST * unit)


def _spread(points: Floats, chosen: Ints, unit: float) -> Ints:
    """The rows `chosen` and more: always the point that is farthest from all of them, until all are near."""
    low = _low(points, unit)
    rows = chosen.tolist()
    away = np.min([_distances(points[low], points[row]) for row in rows], 0)
    while away.max() > SPACING * unit and len(rows) < MOST:
        rows.append(int(low[away.argmax()]))
        away = np.minimum(away, _distances(points[low], points[rows[-1]]))
    return np.array(rows, np.int64)


def _distances(points: Floats, point: Floats) -> Floats:
    """(V,) how far points (V, 3) are from one; the same bits on every processor."""
    x, y, z = (points - point).T
    distances: Floats = np.sqrt(x * x + y * y + z * z)
    return distances
