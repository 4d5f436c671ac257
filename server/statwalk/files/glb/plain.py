"""The accessors that most of a file consists of: 32-bit floats, tightly packed. All of them checked in one pass, nothing copied.

Whatever is not plain, or not right, is left to `accessors`, which looks closer and says what is wrong.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from statwalk.files.glb import check
from statwalk.files.glb.columns import Codes, Column, codes, named, whole_numbers
from statwalk.files.glb.document import Document
from statwalk.files.glb.formats import FLOAT, FLOAT_BYTES
from statwalk.files.glb.views import Views
from statwalk.maths.kernels.choose import loaded

WIDTHS = Codes(("no type", "SCALAR", "VEC2", "VEC3", "VEC4"))
"""floats to an element; matrices are left to `accessors`"""
PIECE = 1 << 16
BOUNDS = np.nextafter(np.array([-check.LARGEST, check.LARGEST], np.float32), np.array([-np.inf, np.inf], np.float32))
Floats32 = NDArray[np.float32]
Bools = NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class PlainFloats:
    """Where the plain accessors of a document lie: accessor i is `count` elements of `width` floats from float `first` of its buffer on.

    usable    (A,) whether it is plain and all its numbers can be computed with
    numbers   by buffer, all its bytes as 32-bit floats
    """

    usable: Bools
    buffer: Column
    first: Column
    count: Column
    width: Column
    numbers: dict[int, Floats32]

    def array(self, row: int) -> Floats32 | None:
        """The array (count,) or (count, n) of an accessor, None where it is not usable."""
        if not self.usable[row]:
            return None
        values = self.numbers[int(self.buffer[row])][self.first[row] : self.last[row]]
        return values if self.width[row] == 1 else values.reshape(-1, int(self.width[row]))

    @cached_property
    def last(self) -> Column:
        """One beyond the last float of each accessor."""
        return self.first + self.count * self.width

    @property
    def bytes(self) -> int:
        """The bytes of all usable accessors, each counted for itself."""
        return FLOAT_BYTES * int((self.last - self.first)[self.usable].sum())


def plain_floats(document: Document, views: Views) -> PlainFloats:
    """All plain accessors of a document."""
    entries = document["accessors"]
    width, count = codes(entries, "type", WIDTHS), whole_numbers(entries, "count")
    offset, view = whole_numbers(entries, "byteOffset", 0), whole_numbers(entries, "bufferView")
    place = placed_views(document)
    plain = (width > 0) & (count > 0) & (offset >= 0) & (view >= 0) & (view < len(place.start))
    plain &= whole_numbers(entries, "componentType") == FLOAT
    plain &= ~named(entries, "sparse")
    view = np.where(plain, view, 0)
    start = place.start[view] + offset
    size = FLOAT_BYTES * count * width
    plain &= place.right[view] & (start % FLOAT_BYTES == 0) & (offset + size <= place.length[view])
    first, buffer = start // FLOAT_BYTES, place.buffer[view]
    numbers: dict[int, Floats32] = {}
    for row in np.flatnonzero(np.bincount(buffer[plain])).tolist():
        data = views.buffer(row)
        plain &= (buffer != row) | (place.start[view] + place.length[view] <= len(data))
        numbers[row] = np.frombuffer(data, "<f4", len(data) // FLOAT_BYTES)
    found = PlainFloats(plain, buffer, first, count, width, numbers)
    for row, whole in numbers.items():
        sift(plain, plain & (buffer == row), found, whole)
    return found


@dataclass(frozen=True, eq=False)
class PlacedViews:
    """Buffer views in columns (V,), one row that is not right where there are none.

    right    whether it is tightly packed, and in a buffer that is listed
    """

    right: Bools
    buffer: Column
    start: Column
    length: Column


def placed_views(document: Document) -> PlacedViews:
    """The buffer views of a document."""
    entries = document["bufferViews"] or [{}]
    buffer, length = whole_numbers(entries, "buffer"), whole_numbers(entries, "byteLength")
    start = whole_numbers(entries, "byteOffset", 0)
    right = (start >= 0) & (length >= 0) & (buffer >= 0) & (buffer < len(document["buffers"]))
    right &= ~named(entries, "byteStride")
    return PlacedViews(right, buffer, start, length)


def sift(usable: Bools, here: Bools, found: PlainFloats, whole: Floats32) -> None:
    """Of the accessors that lie `here` in one buffer, take those out of `usable` that share a run of floats with an unusable number."""
    rows = np.flatnonzero(here)
    if not len(rows):
        return
    rows = rows[np.argsort(found.first[rows], kind="stable")]
    first, reach = found.first[rows], np.maximum.accumulate(found.last[rows])
    starts = np.flatnonzero(np.append(True, first[1:] > reach[:-1]))
    for start, end in zip(starts, [*starts[1:], len(rows)], strict=True):
        if not is_usable(whole[first[start] : reach[end - 1]]):
            usable[rows[start:end]] = False


def is_usable(numbers: Floats32) -> bool:
    """Whether all are finite and none is beyond 1e24. Looked at in pieces that the cache still holds when they are looked at again."""
    compiled = loaded()
    if compiled is not None and numbers.flags.aligned:
        return compiled.within(numbers, *BOUNDS)
    pieces = (numbers[start : start + PIECE] for start in range(0, len(numbers), PIECE))
    return all(piece.min() >= -check.LARGEST and piece.max() <= check.LARGEST for piece in pieces)
