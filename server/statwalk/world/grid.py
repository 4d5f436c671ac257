"""Who is near whom: a uniform grid, so that the work grows with the number of neighbours and not with the square of the crowd.

The order of what is found follows from places and rows alone.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from statwalk.maths.arrays import Bools, Floats, Ints

BLOCK = 1 << 20
"""candidates looked at together"""
MOST_PAIRS = 200_000

_FARTHEST = (1 << 20) - 2
"""cells from the origin: what lies beyond shares the outermost ones, which costs time but finds the same"""
_ROUNDING = 1 + 1e-9
_ROW = 2 * _FARTHEST + 3
_COLUMNS = np.array([[x, y] for x in (-1, 0, 1) for y in (-1, 0, 1)])


class Pairs(NamedTuple):
    """Rows that may be near each other, (P,) each."""

    first: Ints
    second: Ints


class Grid:
    """Points (N, 3) in cubes of `size` metres."""

    def __init__(self, points: Floats, size: float) -> None:
        self.size = size
        keys = _keys(self.cells(points))
        self.order = keys.argsort(kind="stable")
        self.keys = keys[self.order]

    def cells(self, points: Floats) -> Ints:
        """The cube (N, 3) that each point lies in."""
        cubes: Ints = np.floor(points / self.size).clip(-_FARTHEST, _FARTHEST).astype(np.int64)
        return cubes

    def around(self, points: Floats) -> Iterator[Pairs]:
        """For each of `points` (M, 3), in their order, the grid's points in its cube and the 26 around it: (row of `points`, grid's row).

        No point within `size` of it is missing. Of one cube, the lower rows come first. In blocks of whole rows, which bounds the memory.
        """
        cells = self.cells(points)[:, None, :].repeat(len(_COLUMNS), 1)
        cells[..., :2] += _COLUMNS  # nine columns of three cubes, whose keys follow each other
        cells[..., 2] -= 1
        lowest = _keys(cells)
        start = self.keys.searchsorted(lowest, "left")
        count = self.keys.searchsorted(lowest + 2, "right") - start
        found = count.sum(-1)
        block = (found.cumsum() - found) // BLOCK
        ends = np.append(np.flatnonzero(np.diff(block)) + 1, len(points))
        for begin, end in pairwise((0, *ends.tolist())):
            yield Pairs(
                np.arange(begin, end).repeat(found[begin:end]), self.order[_ranges(start[begin:end].ravel(), count[begin:end].ravel())]
            )


def _ranges(start: Ints, count: Ints) -> Ints:
    """start, start + 1, … of each range, one after the other."""
    begun = count.cumsum() - count
    numbers: Ints = np.arange(count.sum()) + (start - begun).repeat(count)
    return numbers


def _keys(cells: Ints) -> Ints:
    """One number for each cube (…, 3), in the order x, y, z."""
    x, y, z = cells[..., 0], cells[..., 1], cells[..., 2]
    keys: Ints = ((x + _FARTHEST + 1) * _ROW + (y + _FARTHEST + 1)) * _ROW + (z + _FARTHEST + 1)
    return keys


def overlapping(centers: Floats, reach: Floats, most: int = MOST_PAIRS) -> Pairs:
    """Pairs of balls (N, 3), (N,) that overlap, first < second, sorted. Balls of very different sizes lie in grids of their own.

    Where thousands lie in one heap it stops looking after about `most` pairs.
    """
    found = [np.zeros((2, 0), np.int64)]
    for pairs in _candidates(centers, reach):
        first, second = np.minimum(*pairs), np.maximum(*pairs)
        found.append(np.stack([first, second])[:, _overlap(centers, reach, first, second)])
        if sum(one.shape[1] for one in found) >= most:
            break
    first, second = np.concatenate(found, 1)
    order = (first * len(centers) + second).argsort(kind="stable")
    return Pairs(first[order], second[order])


def _candidates(centers: Floats, reach: Floats) -> Iterator[Pairs]:
    """Each pair of balls once whose cubes lie side by side."""
    level = (np.frexp(np.maximum(2 * reach, 1e-9))[1] + 1) // 2  # cubes of 4^level metres hold a ball
    for one in np.unique(level):
        rows = (level == one).nonzero()[0]
        smaller = (level <= one).nonzero()[0]
        for near in Grid(centers[rows], 4.0**one).around(centers[smaller]):
            first, second = smaller[near.first], rows[near.second]
            fresh = (level[first] < one) | (first < second)
            yield Pairs(first[fresh], second[fresh])


def _overlap(centers: Floats, reach: Floats, first: Ints, second: Ints) -> Bools:
    """Whether the balls of each pair overlap; those that miss each other by a rounding error count."""
    x, y, z = (axis[second] - axis[first] for axis in np.ascontiguousarray(centers.T))
    both = (reach[first] + reach[second]) * _ROUNDING
    return np.asarray(x * x + y * y + z * z <= both * both)
