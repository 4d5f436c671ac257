"""Obstacles of a flock: spheres and planes with a repelling force, and a surface that no member passes."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from statwalk.maths import vector
from statwalk.maths.arrays import Bools, Floats
from statwalk.maths.intersect import plane_value


class Obstacles(NamedTuple):
    """O obstacles; the space behind a plane is forbidden."""

    center: Floats
    """(O, 3) metres"""
    radius: Floats
    """(O,) of spheres"""
    normal: Floats
    """(O, 3) of planes, unit"""
    is_plane: Bools
    """(O,)"""


AHEAD_S, SOONEST_S = 2.0, 0.3
"""seconds that a member looks ahead; the shortest time to a collision that its evasion assumes"""
HEAD_ON = 1e-6

NO_OBSTACLES = Obstacles(np.zeros((0, 3)), np.zeros(0), np.zeros((0, 3)), np.zeros(0, bool))


def repulsion(obstacles: Obstacles, position: Floats, distance: float, strength: float) -> Floats:
    """Returns accelerations (N, 3) away from near surfaces, by the inverse square: `strength` at `distance`,
    0 at twice the distance.
    """
    total = np.zeros_like(position)
    for row in range(len(obstacles.radius)):
        gap, outwards = _surface(obstacles, row, position)
        near = np.maximum(gap, 0.1 * distance)
        part = distance / near
        force = np.where(gap < 2 * distance, strength * (part * part - 0.25) / 0.75, 0)
        total += outwards * force[:, None]
    return total


def evasion(obstacles: Obstacles, position: Floats, velocity: Floats, distance: float) -> Floats:
    """Returns accelerations (N, 3) to the side for members whose course leads into a sphere: just enough to
    pass it at `distance`.
    """
    total = np.zeros_like(position)
    speed = vector.length(velocity)
    course = velocity / np.where(speed > 0, speed, 1)[:, None]
    for row in (~obstacles.is_plane).nonzero()[0].tolist():
        away = position - obstacles.center[row]
        ahead = -vector.dot(away, course)
        nearest = away + course * ahead[:, None]
        missed = vector.length(nearest)
        wide = obstacles.radius[row] + distance
        seconds = np.maximum(ahead / np.where(speed > 0, speed, 1), SOONEST_S)
        meets = (speed > 0) & (ahead > 0) & (missed < wide) & (seconds < AHEAD_S)
        side = np.where(
            (missed > HEAD_ON * wide)[:, None], vector.unit(nearest), vector.perpendicular(course)
        )
        total += np.where(meets[:, None], side * (2 * (wide - missed) / (seconds * seconds))[:, None], 0)
    return total


def pushed_out(obstacles: Obstacles, position: Floats, velocity: Floats) -> tuple[Floats, Floats]:
    """Returns positions (N, 3) outside all obstacles, one obstacle after the other, and velocities (N, 3)
    that do not lead into an obstacle they touched.
    """
    for row in range(len(obstacles.radius)):
        gap, outwards = _surface(obstacles, row, position)
        inside = (gap < 0)[:, None]
        position = np.where(inside, position - outwards * gap[:, None], position)
        inwards = np.minimum(vector.dot(velocity, outwards), 0)
        velocity = np.where(inside, velocity - outwards * inwards[:, None], velocity)
    return position, velocity


def _surface(obstacles: Obstacles, row: int, position: Floats) -> tuple[Floats, Floats]:
    """Metres (N,) to an obstacle's surface, negative inside it, and the unit direction (N, 3) away
    from it.
    """
    if obstacles.is_plane[row]:
        normal = np.broadcast_to(obstacles.normal[row], position.shape)
        return plane_value(normal, obstacles.center[row], position), normal
    away = position - obstacles.center[row]
    size = vector.length(away)
    outwards = np.where(
        (size > 0)[:, None], away / np.where(size > 0, size, 1)[:, None], np.array([0.0, 1, 0])
    )
    return size - obstacles.radius[row], outwards
