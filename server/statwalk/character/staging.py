"""Staging: a camera that frames a character and follows it (FAQ Q1, KF9)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from statwalk.character.character import Character
from statwalk.errors import ContentError, UnknownNameError
from statwalk.machine.definition.framing import FRAMINGS, Framing
from statwalk.maths import quat
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose

PART = {"upper body": 0.5, "face": 0.2}
"""the part of the height, from the top, that a framing shows"""
WIDE, BROADEST = 2.5, 1.2
"""sizes of the character that `wide` shows; widths of a part, relative to its height"""
FIELD, AROUND, ABOVE, ROOM = np.deg2rad(32), 0.52, 0.14, 1.14
"""radians: the field of view from top to bottom, the angles to the side and from above; the air around"""
LAG, CUT = 0.18, 0.8
"""seconds in which the camera makes up most of its way; heights that the root cannot go within a tick"""


class Shot(NamedTuple):
    """What a camera shows for T ticks, as glTF has it: it looks along its own -Z; metres and radians."""

    position: Floats
    """(T, 3)"""
    rotation: Floats
    """(4,) x y z w: it does not turn"""
    field: float
    """from top to bottom"""
    near: float
    far: float


def staging(
    character: Character,
    pose: Pose,
    path: ArrayLike = ((0.0, 0.0, 0.0),),
    framing: Framing = "whole",
    *,
    heading: float = 0.0,
    rate: float = 60.0,
    aspect: float = 16 / 9,
) -> Shot:
    """Returns the camera that frames a character in a pose, from the front, a little from the side and from
    above, and follows the `path` (T, 3) of its root, `rate` ticks a second, without haste.

    framing: "whole", "upper body", "face" or "wide", of the character turned by `heading` (radians). aspect:
    width of the picture by height.

    :raises UnknownNameError: when there is no framing of this name.
    :raises ContentError: when the path is not T finite places, or rate or aspect are not positive.
    """
    places = np.asarray(path, np.float64)
    if places.ndim != 2 or places.shape[1] != 3 or not len(places) or not np.isfinite(places).all():
        raise ContentError(f"path: places (T, 3) of finite numbers are needed, not {places.shape}")
    if not (0 < rate < np.inf and 0 < aspect < np.inf):
        raise ContentError(f"rate and aspect are above 0, not {rate:g} and {aspect:g}")
    whole = _box(character, pose, heading)
    low, high = framed(*whole, framing)
    radius = max(float(np.linalg.norm(high - low)) / 2, 1e-3)
    narrow = min(FIELD / 2, float(np.arctan(np.tan(FIELD / 2) * aspect)))
    side, up = np.array([0.0, 1.0, 0.0]), np.array([1.0, 0.0, 0.0])
    rotation = quat.mul(quat.from_axis_angle(side, AROUND), quat.from_axis_angle(up, -ABOVE))
    away = quat.rotate(rotation, np.array([0.0, 0.0, radius / np.sin(narrow) * ROOM]))
    roots = followed(places, max(float((high - low)[1]), 1e-3), rate)
    return Shot(roots + (low + high) / 2 + away, rotation, float(FIELD), radius / 60, radius * 80)


def framed(low: Floats, high: Floats, framing: Framing) -> tuple[Floats, Floats]:
    """Returns the lowest and the highest corner of what a framing shows of a box.

    :raises UnknownNameError: when there is no framing of this name.
    """
    if framing not in FRAMINGS:
        raise UnknownNameError("framing", framing, FRAMINGS)
    size, centre = high - low, (low + high) / 2
    if framing == "wide":
        return centre - WIDE / 2 * size, centre + WIDE / 2 * size
    if framing == "whole":
        return low, high
    tall = PART[framing] * size[1]
    broad = min(max(size[0], size[2]), BROADEST * tall)
    centre[1] = high[1] - tall / 2
    half = np.array([broad, tall, broad]) / 2
    return centre - half, centre + half


def followed(path: Floats, height: float, rate: float) -> Floats:
    """Returns the places (T, 3) of what follows a path (T, 3): it makes up a part of the way in each tick. A
    jump of most of the `height` is a cut.
    """
    places, share = path.copy(), 1 - np.exp(-1 / (rate * LAG))
    for tick in range(1, len(path)):
        way = path[tick] - places[tick - 1]
        if np.linalg.norm(path[tick] - path[tick - 1]) <= CUT * height:
            places[tick] = places[tick - 1] + share * way
    return places


def _box(character: Character, pose: Pose, heading: float) -> tuple[Floats, Floats]:
    """The corners of the character around its root: of its skin, or of its joints where it has none."""
    parts = [part.positions for part in character.vertices(pose)]
    points = np.concatenate(parts) if parts else character.world(pose)[:, :3, 3]
    turn = quat.from_axis_angle(np.array([0.0, 1.0, 0.0]), heading)
    turned = quat.rotate(turn, points.astype(np.float64))
    return turned.min(0), turned.max(0)
