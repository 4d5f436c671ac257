"""How a foot lies on uneven ground: on a slope as the slope, over the edge of a step level.

`f` FootTables; x and z the middle of the sole on the stage, `sine` and `cosine` of the foot's yaw.
"""

from __future__ import annotations

import math
from typing import Any

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.solve.foot_tables import HALF_LENGTH, HALF_WIDTH
from statwalk.solve.ground import ground_at

STEEPEST = 0.57735
"""the tangent of 30°: a foot lies no steeper; an ankle bends no more for the ground"""
BUMP = 0.015
"""metres by which the ground may differ from a slope under a foot; under one that differs more a foot is
level
"""
SUPPORTED, MARGIN, TOE_ROOM = 0.02, 0.012, 0.045
"""metres: a point of a sole has ground below it if that is so near; room that is wanted round a foot, and
before its toes: they come forward when the heel rises
"""
WALL, CALF_ROOM, CRAMPED = 0.2, 0.075, 5
"""metres by which ground behind a foot must be higher to be in the way of the calf; metres of room that the
calf wants there; how many supported points of a sole this room is worth
"""


@inlined
def slope_under(f: Any, foot: int, x: float, z: float, sine: float, cosine: float) -> Any:
    """Returns by how much a foot there rises for each metre along x and along z."""
    middle = ground_at(f.ground, x, z, 0.0)
    along = _incline(f, middle, x, z, f.print[foot, HALF_LENGTH] * sine, f.print[foot, HALF_LENGTH] * cosine)
    along = along / max(f.print[foot, HALF_LENGTH], 1e-6)
    across = _incline(f, middle, x, z, f.print[foot, HALF_WIDTH] * cosine, -f.print[foot, HALF_WIDTH] * sine)
    across = across / max(f.print[foot, HALF_WIDTH], 1e-6)
    size = math.sqrt(along * along + across * across)
    part = STEEPEST / size if size > STEEPEST else 1.0
    return (along * sine + across * cosine) * part, (along * cosine - across * sine) * part


@inlined
def _incline(f: Any, middle: float, x: float, z: float, u: float, v: float) -> Any:
    """How much higher the ground is at `u`, `v` from the middle; 0 if it is no slope there."""
    front, back = ground_at(f.ground, x + u, z + v, 0.0), ground_at(f.ground, x - u, z - v, 0.0)
    return 0.5 * (front - back) if abs(middle - 0.5 * (front + back)) < BUMP else 0.0


@called
def height_over(
    f: Any, foot: int, x: float, z: float, sine: float, cosine: float, slope_x: float, slope_z: float,
    front: float, back: float, wider: float,
) -> Any:  # fmt: skip
    """Returns how high (metres) the middle of a foot with this slope lies, that is on or above the ground
    everywhere; the foot is taken for longer by `front` and `back`, and for wider on both sides.
    """
    middle, half = 0.5 * (front - back), f.print[foot, HALF_LENGTH] + 0.5 * (front + back)
    wide, height = f.print[foot, HALF_WIDTH] + wider, 0.0
    for step in range(-2, 3):
        for side in range(-1, 2):
            away = middle + 0.5 * step * half
            u, v = away * sine + side * wide * cosine, away * cosine - side * wide * sine
            height = max(height, ground_at(f.ground, x + u, z + v, 0.0) - slope_x * u - slope_z * v)
    return height


@called
def height_under(
    f: Any, foot: int, x: float, z: float, sine: float, cosine: float, slope_x: float, slope_z: float
) -> Any:
    """Returns how high (metres) the middle of a flat foot with this slope lies: no point of its sole is below
    the ground.
    """
    height = -1e9
    for point in range(f.first_point[foot], f.first_point[foot + 1]):
        along, across = f.on_print[point, 0], f.on_print[point, 1]
        u, v = along * sine + across * cosine, along * cosine - across * sine
        height = max(height, ground_at(f.ground, x + u, z + v, 0.0) - slope_x * u - slope_z * v)
    return height


@called
def points_supported(f: Any, foot: int, x: float, z: float, sine: float, cosine: float) -> Any:
    """Returns how many of fifteen points of a sole have ground below them there; CRAMPED fewer if a wall is
    close behind.
    """
    slope_x, slope_z = slope_under(f, foot, x, z, sine, cosine)
    height = height_over(f, foot, x, z, sine, cosine, slope_x, slope_z, TOE_ROOM, MARGIN, MARGIN)
    middle, half = 0.5 * (TOE_ROOM - MARGIN), f.print[foot, HALF_LENGTH] + 0.5 * (TOE_ROOM + MARGIN)
    wide, count = f.print[foot, HALF_WIDTH] + MARGIN, 0
    for step in range(-2, 3):
        for side in range(-1, 2):
            away = middle + 0.5 * step * half
            u, v = away * sine + side * wide * cosine, away * cosine - side * wide * sine
            gap = height + slope_x * u + slope_z * v - ground_at(f.ground, x + u, z + v, 0.0)
            count += 1 if gap < SUPPORTED else 0
    return count - (CRAMPED if _wall_behind(f, foot, x, z, sine, cosine, height) else 0)


@inlined
def _wall_behind(
    f: Any, foot: int, x: float, z: float, sine: float, cosine: float, height: float
) -> Any:  # fmt: skip
    """Whether ground close behind a foot is much higher than its middle."""
    away, wide, highest = -f.print[foot, HALF_LENGTH] - CALF_ROOM, f.print[foot, HALF_WIDTH], 0.0
    for side in range(-1, 2):
        u, v = away * sine + side * wide * cosine, away * cosine - side * wide * sine
        highest = max(highest, ground_at(f.ground, x + u, z + v, 0.0))
    return highest - height > WALL
