"""Whom each member of a flock sees: the nearest ones in its field of view (FAQ Q34)."""

from __future__ import annotations

import numpy as np

from statwalk.maths.arrays import Floats, Ints
from statwalk.world.grid import Grid

BLOCK = 512
"""members looked at together, which bounds the memory where all are in one place"""
WIDER = 1.6
"""times the radius: the next look of those who have not found enough"""
BALL = 4.19
"""volume of a ball of radius 1"""
MOST_HALVINGS = 12
ENOUGH = 2.5
"""times those wanted: so many one hopes to find at the first look, as some are out of sight"""


def nearest_seen(position: Floats, forward: Floats, reach: float, sight_cos: float, count: int) -> tuple[Ints, Floats]:
    """Rows (N, count) and distances (N, count) metres of the nearest members seen, nearest first; beyond the last seen −1 and infinity.

    Seen is who stands within `reach`, and off `forward` (N, 3) by an angle whose cosine is `sight_cos` or more. Of equally near ones the
    lower row comes first.
    """
    rows, squares = np.full((len(position), count), -1), np.full((len(position), count), np.inf)
    todo, radius = np.arange(len(position)), first_look(position, reach, count)
    while len(todo):
        grid = Grid(position, radius)
        for start in range(0, len(todo), BLOCK):
            block = todo[start : start + BLOCK]
            rows[block], squares[block] = _nearest(*_seen(grid, block, position, forward, radius, sight_cos), len(block), count)
        todo = todo[np.isinf(squares[todo, -1])] if radius < reach else todo[:0]
        radius = min(WIDER * radius, reach)
    return rows, np.sqrt(squares)


def first_look(position: Floats, reach: float, count: int) -> float:
    """A guess how far one must look to find `count` others, from how closely the flock stands; it changes the work, not the answer."""
    size = reach
    for _ in range(MOST_HALVINGS):
        _, crowd = np.unique(Grid(position, size).keys, return_counts=True)
        company = float((crowd * crowd).sum() / max(len(position), 1))  # members in a member's own cube
        if company <= count:
            break
        size /= 2
    volume = ENOUGH * count / max(company, 1.0) * size * size * size
    return min(float((volume / BALL) ** (1 / 3)), reach)


def _seen(grid: Grid, block: Ints, position: Floats, forward: Floats, radius: float, sight_cos: float) -> tuple[Ints, Ints, Floats]:
    """Row of the block, member that it sees, and the square of their distance (P,), in order of the block's rows."""
    who, other = grid.around(position[block])
    me = block[who]
    x, y, z = (axis[other] - axis[me] for axis in np.ascontiguousarray(position.T))
    square = x * x + y * y + z * z
    near = ((square <= radius * radius) & (me != other)).nonzero()[0]
    who, other, square, me = who[near], other[near], square[near], me[near]
    if sight_cos > -1:
        ahead_x, ahead_y, ahead_z = (axis[me] for axis in np.ascontiguousarray(forward.T))
        ahead = x[near] * ahead_x + y[near] * ahead_y + z[near] * ahead_z
        visible = ahead >= sight_cos * np.sqrt(square)
        who, other, square = who[visible], other[visible], square[visible]
    return who, other, square


def _nearest(who: Ints, other: Ints, square: Floats, members: int, count: int) -> tuple[Ints, Floats]:
    """Of those that each member sees the nearest: rows and squares (members, count)."""
    seen = np.bincount(who, minlength=members)
    place = np.arange(len(who)) - (seen.cumsum() - seen)[who]
    table = np.full((members, max(int(seen.max(initial=0)), 1)), np.inf)
    rows = np.full(table.shape, np.iinfo(np.int64).max)
    table[who, place], rows[who, place] = square, other
    nearest, squares = np.full((members, count), -1), np.full((members, count), np.inf)
    for column in range(min(count, table.shape[1])):
        least = table.min(1)
        chosen = np.where(table == least[:, None], rows, np.iinfo(np.int64).max).min(1)
        is_seen = np.isfinite(least)
        nearest[:, column], squares[:, column] = np.where(is_seen, chosen, -1), least
        table[rows == chosen[:, None]] = np.inf
    return nearest, squares
