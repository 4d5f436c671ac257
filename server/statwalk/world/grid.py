"""A uniform grid that finds neighbours, so that the work grows with the number of neighbours and not with the
square of the crowd.

The order of the results depends on positions and rows alone.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from statwalk.maths.arrays import Bools, Floats, Ints

BLOCK = 1 << 18
"""candidates tested together"""
MOST_PAIRS = 50_000
"""most pairs to report; in a heap of thousands every member touches every other"""

_FARTHEST = (1 << 20) - 2
"""columns or slices from the origin; points beyond share the outermost ones, which costs time but gives the
same results
"""
ROUNDING = 1 + 1e-9
_ROW = 2 * _FARTHEST + 3
_SLICES = 8
_COLUMNS = np.array([[x, y] for x in range(3) for y in range(3)])


class Pairs(NamedTuple):
    """Rows that may be near each other, (P,) each."""

    first: Ints
    second: Ints


class Grid:
    """Points (N, 3) in upright columns along Z, `size` metres wide, each cut into thin slices."""

    def __init__(self, points: Floats, size: float) -> None:
        self.size = size
        cells = self._cells(points)
        keys = _keys(cells[0], cells[1], self._slices(points[:, 2]))
        self.order = keys.argsort(kind="stable")
        self.keys = keys[self.order]

    def around(self, points: Floats, radius: Floats | float) -> Iterator[Pairs]:
        """Yields, for each of `points` (M, 3) in their order, the grid's points that may lie within `radius`
        (M,), at most `size`.

        No point within the radius is missing. The pairs are (row of `points`, row of the grid), in blocks of
        whole rows, which bounds the memory.
        """
        x, y = self._cells(points)
        reach = np.broadcast_to(radius, len(points)) * ROUNDING
        across = (
            _outside(points[:, 0], x, self.size)[:, _COLUMNS[:, 0]]
            + _outside(points[:, 1], y, self.size)[:, _COLUMNS[:, 1]]
        )
        left = (reach * reach)[:, None] - across
        along = np.sqrt(np.maximum(left, 0))
        columns = x[:, None] + (_COLUMNS[:, 0] - 1), y[:, None] + (_COLUMNS[:, 1] - 1)
        start = self.keys.searchsorted(_keys(*columns, self._slices(points[:, 2, None] - along)), "left")
        end = self.keys.searchsorted(_keys(*columns, self._slices(points[:, 2, None] + along)), "right")
        count = np.where(left >= 0, end - start, 0)
        candidates = count.sum(-1)
        block = (candidates.cumsum() - candidates) // BLOCK
        ends = np.append(np.flatnonzero(np.diff(block)) + 1, len(points))
        for begin, stop in pairwise((0, *ends.tolist())):
            rows = np.arange(begin, stop).repeat(candidates[begin:stop])
            yield Pairs(rows, self.order[_ranges(start[begin:stop].ravel(), count[begin:stop].ravel())])

    def _cells(self, points: Floats) -> tuple[Ints, Ints]:
        """The column, in x and y, that each point lies in."""
        cells = np.floor(points[:, :2] / self.size).clip(-_FARTHEST, _FARTHEST).astype(np.int64)
        return cells[:, 0], cells[:, 1]

    def _slices(self, z: Floats) -> Ints:
        slices: Ints = np.floor(z * (_SLICES / self.size)).clip(-_FARTHEST, _FARTHEST).astype(np.int64)
        return slices


def _outside(place: Floats, cell: Ints, size: float) -> Floats:
    """Squares (M, 3) of the distances on one axis from a point to the cell before its own, to its own (0),
    and to the next.
    """
    into = place - cell * size
    squares: Floats = np.stack([np.maximum(into, 0), np.zeros_like(into), np.maximum(size - into, 0)], -1)
    return squares * squares


def _ranges(start: Ints, count: Ints) -> Ints:
    """start, start + 1, … of each range, one after the other."""
    begun = count.cumsum() - count
    numbers: Ints = np.arange(count.sum()) + (start - begun).repeat(count)
    return numbers


def _keys(x: Ints, y: Ints, z: Ints) -> Ints:
    """One number for each cell, in the order x, y, z."""
    keys: Ints = ((x + _FARTHEST + 1) * _ROW + (y + _FARTHEST + 1)) * _ROW + (z + _FARTHEST + 1)
    return keys


def overlapping(centers: Floats, reach: Floats, most: int = MOST_PAIRS) -> Pairs:
    """Returns the pairs of balls (N, 3), (N,) that overlap, first < second, sorted.

    Balls of very different sizes are in separate grids.

    The search stops after `most` pairs.
    """
    blocks = [np.zeros((2, 0), np.int64)]
    for pairs in _candidates(centers, reach):
        first, second = np.minimum(*pairs), np.maximum(*pairs)
        blocks.append(np.stack([first, second])[:, _overlap(centers, reach, first, second)])
        if sum(block.shape[1] for block in blocks) >= most:
            break
    first, second = np.concatenate(blocks, 1)[:, :most]
    order = (first * len(centers) + second).argsort(kind="stable")
    return Pairs(first[order], second[order])


def _candidates(centers: Floats, reach: Floats) -> Iterator[Pairs]:
    """Each pair of balls with adjacent cubes, once."""
    level = (np.frexp(np.maximum(2 * reach, 1e-9))[1] + 1) // 2  # cubes of 4^level metres hold a ball
    for size_level in np.unique(level):
        rows = (level == size_level).nonzero()[0]
        smaller = (level <= size_level).nonzero()[0]
        widest = reach[rows].max()
        for near in Grid(centers[rows], 4.0**size_level).around(
            centers[smaller], np.minimum(reach[smaller] + widest, 4.0**size_level)
        ):
            first, second = smaller[near.first], rows[near.second]
            is_new = (level[first] < size_level) | (first < second)
            yield Pairs(first[is_new], second[is_new])


def _overlap(centers: Floats, reach: Floats, first: Ints, second: Ints) -> Bools:
    """Whether the balls of each pair overlap; balls apart by a rounding error count."""
    x, y, z = (axis[second] - axis[first] for axis in np.ascontiguousarray(centers.T))
    both = (reach[first] + reach[second]) * ROUNDING
    return np.asarray(x * x + y * y + z * z <= both * both)
