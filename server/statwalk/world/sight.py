"""Finds the nearest members in the field of view of each member of a flock (FAQ Q34)."""

from __future__ import annotations

import numpy as np

from statwalk.maths.arrays import Floats, Ints
from statwalk.world.grid import Grid

NOBODY = np.iinfo(np.int64).max
WIDER = 1.6
"""factor on the radius of the next search, for members that found too few neighbours"""
BALL = 4.19
"""volume of a ball of radius 1"""
MIXING = np.array([1.0, 1009.0, 1013021.0])
"""hashes a cube to one number; a collision only worsens a guess"""
MOST_HALVINGS = 12
ENOUGH = 2.5
"""factor on the wanted count: the number of members expected in the first search, as some are out of sight"""


def nearest_seen(
    position: Floats, forward: Floats, reach: float, sight_cos: float, count: int
) -> tuple[Ints, Floats]:
    """Returns rows (N, count) and distances (N, count) metres of the nearest visible members, nearest first;
    −1 and infinity beyond the last.

    A member is visible within `reach`, and at an angle off `forward` (N, 3) whose cosine is `sight_cos` or
    more. Of equally near members the lower row comes first.
    """
    rows, squares = np.full((len(position), count), -1), np.full((len(position), count), np.inf)
    todo, radius = np.arange(len(position)), first_look(position, reach, count)
    while len(todo):
        grid = Grid(position, radius)
        for near in grid.around(position[todo], radius):
            block = np.arange(
                near.first[0], near.first[-1] + 1
            )  # whole rows, and every member is near itself
            viewer, other, square = _seen(
                todo[near.first], near.second, position, forward, (radius, sight_cos)
            )
            rows[todo[block]], squares[todo[block]] = _nearest(viewer, other, square, todo[block], count)
        todo = todo[np.isinf(squares[todo, -1])] if radius < reach else todo[:0]
        radius = min(WIDER * radius, reach)
    return rows, np.sqrt(squares)


def first_look(position: Floats, reach: float, count: int) -> float:
    """Returns a radius in which a member probably finds `count` others, by the density of the flock; it
    changes the work, not the result.
    """
    size = reach
    for _ in range(MOST_HALVINGS):
        cubes = np.floor(position / size) * MIXING
        _, crowd = np.unique(cubes[:, 0] + cubes[:, 1] + cubes[:, 2], return_counts=True)
        company = float((crowd * crowd).sum() / max(len(position), 1))  # members in a member's own cube
        if company <= count:
            break
        size /= 2
    volume = ENOUGH * count / max(company, 1.0) * size * size * size
    return min(float((volume / BALL) ** (1 / 3)), reach)


def _seen(
    viewer: Ints, other: Ints, position: Floats, forward: Floats, limits: tuple[float, float]
) -> tuple[Ints, Ints, Floats]:
    """The pairs (P,) in which `me` sees `other`, and the squares of their distances; `limits` are reach and
    cosine.
    """
    reach, sight_cos = limits
    x, y, z = (axis[other] - axis[viewer] for axis in np.ascontiguousarray(position.T))
    square = x * x + y * y + z * z
    near = ((square <= reach * reach) & (viewer != other)).nonzero()[0]
    viewer, other, square = viewer[near], other[near], square[near]
    if sight_cos <= -1:
        return viewer, other, square
    ahead_x, ahead_y, ahead_z = (axis[viewer] for axis in np.ascontiguousarray(forward.T))
    visible = x[near] * ahead_x + y[near] * ahead_y + z[near] * ahead_z >= sight_cos * np.sqrt(square)
    return viewer[visible], other[visible], square[visible]


def _nearest(viewer: Ints, other: Ints, square: Floats, members: Ints, count: int) -> tuple[Ints, Floats]:
    """The nearest members that each of `members` (M,), which rise, sees: rows and squares (M, count).

    `viewer` rises too.
    """
    start = viewer.searchsorted(members)
    seen = viewer.searchsorted(members, "right") - start
    table = np.full((len(members), max(int(seen.max(initial=0)), 1)), np.inf)
    rows = np.full(table.shape, NOBODY)
    line = np.arange(len(members)).repeat(seen)
    place = np.arange(len(viewer)) - start[line]
    table[line, place], rows[line, place] = square, other
    nearest, squares = np.full((len(members), count), -1), np.full((len(members), count), np.inf)
    for column in range(min(count, table.shape[1])):
        least = table.min(1)
        chosen = np.where(table == least[:, None], rows, NOBODY).min(1)
        nearest[:, column], squares[:, column] = np.where(np.isfinite(least), chosen, -1), least
        table[rows == chosen[:, None]] = np.inf
    return nearest, squares
