"""The faces of a .x mesh: polygons of any size, as triangles of corners."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from statwalk.files.directx.x_numbers import NumberReader
from statwalk.maths.arrays import Ints


class Faces(NamedTuple):
    """Polygons as written: `sizes` (F,) corners of each, `corners` (C,) what each corner refers to."""

    sizes: Ints
    corners: Ints

    def triangles(self) -> tuple[Ints, Ints]:
        """Returns triangles (T, 3) of indices into `corners`, each polygon as a fan, the other way round; and
        the polygon (T,) of each. A polygon with fewer than three corners has none.
        """
        count = np.maximum(self.sizes - 2, 0)
        face = np.repeat(np.arange(len(self.sizes)), count)
        within = np.arange(len(face)) - np.repeat(np.cumsum(count) - count, count)
        first = (np.cumsum(self.sizes) - self.sizes)[face]
        return np.stack([first, first + within + 2, first + within + 1], -1), face


def read_faces(numbers: NumberReader, below: int, what: str) -> Faces:
    """Reads a number of faces, and each face: a number of corners, and an index below `below` for each.

    :raises TextError: when a number is wrong.
    """
    count = numbers.count(what, 2)
    first = numbers.at
    sizes = _same_sizes(numbers, count)
    if sizes is None:
        sizes = _sizes(numbers, count, what)
    numbers.at = first + count + int(sizes.sum())
    is_corner = np.ones(numbers.at - first, bool)
    is_corner[np.cumsum(sizes + 1) - sizes - 1] = False
    corners = numbers.values[first : numbers.at][is_corner]
    wrong = np.flatnonzero((corners < 0) | (corners >= below) | (corners != np.floor(corners)))
    if len(wrong):
        numbers.at = first + int(np.flatnonzero(is_corner)[wrong[0]])
        numbers.indices(1, below, f"a corner of {what}")
    return Faces(sizes, corners.astype(np.int64))


def _same_sizes(numbers: NumberReader, count: int) -> Ints | None:
    """Returns the sizes (F,) of faces that all have the size of the first; None if they differ."""
    first = float(numbers.values[numbers.at]) if count else 0.0
    if first != int(first) or first < 0 or count * (first + 1) > numbers.left:
        return None
    width = int(first) + 1
    sizes = numbers.values[numbers.at : numbers.at + count * width : width]
    return sizes.astype(np.int64) if (sizes == first).all() else None


def _sizes(numbers: NumberReader, count: int, what: str) -> Ints:
    """Returns the sizes (F,) of faces, one by one."""
    sizes = np.empty(count, np.int64)
    values, at, last = numbers.values, numbers.at, len(numbers.values)
    for row in range(count):
        size = values[at] if at < last else -1.0
        if not 0 <= size < last - at or size != int(size):
            numbers.at = min(at, last)
            numbers.count(f"corners of a face of {what}")
        sizes[row] = size
        at += 1 + int(size)
    return sizes
