"""Plain accessors, which most of a file consists of: 32-bit floats, tightly packed.

All of them are checked in one pass, without a copy.

Every other accessor, and every wrong one, is left to `accessors`, which checks it and reports what is wrong.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from statwalk.files.gltf import _kernels, check
from statwalk.files.gltf.columns import Codes, Column, codes, named, whole_numbers
from statwalk.files.gltf.document import Document
from statwalk.files.gltf.formats import FLOAT, FLOAT_BYTES
from statwalk.files.gltf.views import Views

WIDTHS = Codes(("no type", "SCALAR", "VEC2", "VEC3", "VEC4"))
"""floats to an element; matrices are left to `accessors`"""
BOUNDS = np.nextafter(
    np.array([-check.LARGEST, check.LARGEST], np.float32), np.array([-np.inf, np.inf], np.float32)
)
Floats32 = NDArray[np.float32]
Bools = NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class PlainFloats:
    """The places of the plain accessors of a document: accessor i is `count` elements of `width` floats, from
    float `first` of its buffer.

    usable    (A,) whether the accessor is plain and all its numbers are usable
    numbers   by buffer, all its bytes as 32-bit floats
    """

    usable: Bools
    buffer: Column
    first: Column
    count: Column
    width: Column
    numbers: dict[int, Floats32]

    def array(self, row: int) -> Floats32 | None:
        """Returns the array (count,) or (count, n) of an accessor; None if it is not usable."""
        if not self.usable[row]:
            return None
        values = self.numbers[int(self.buffer[row])][self.first[row] : self.last[row]]
        return values if self.width[row] == 1 else values.reshape(-1, int(self.width[row]))

    @cached_property
    def last(self) -> Column:
        """The index after the last float of each accessor (A,)."""
        return self.first + self.count * self.width

    @property
    def bytes(self) -> int:
        """The bytes of all usable accessors; bytes that accessors share count for each of them."""
        return FLOAT_BYTES * int((self.last - self.first)[self.usable].sum())


def plain_floats(document: Document, views: Views) -> PlainFloats:
    """Returns all plain accessors of a document."""
    entries = document["accessors"]
    width, count = codes(entries, "type", WIDTHS), whole_numbers(entries, "count")
    offset, view = whole_numbers(entries, "byteOffset", 0), whole_numbers(entries, "bufferView")
    placed_views = _placed_views(document)
    plain = (width > 0) & (count > 0) & (offset >= 0) & (view >= 0) & (view < len(placed_views.start))
    plain &= whole_numbers(entries, "componentType") == FLOAT
    plain &= ~named(entries, "sparse")
    view = np.where(plain, view, 0)
    start = placed_views.start[view] + offset
    size = FLOAT_BYTES * count * width
    plain &= (
        placed_views.right[view] & (start % FLOAT_BYTES == 0) & (offset + size <= placed_views.length[view])
    )
    first, buffer = start // FLOAT_BYTES, placed_views.buffer[view]
    numbers: dict[int, Floats32] = {}
    for row in np.flatnonzero(np.bincount(buffer[plain])).tolist():
        data = views.buffer(row)
        plain &= (buffer != row) | (placed_views.start[view] + placed_views.length[view] <= len(data))
        numbers[row] = np.frombuffer(data, "<f4", len(data) // FLOAT_BYTES)
    plain_accessors = PlainFloats(plain, buffer, first, count, width, numbers)
    for row, buffer_numbers in numbers.items():
        _sift(plain, plain & (buffer == row), plain_accessors, buffer_numbers)
    return plain_accessors


@dataclass(frozen=True, eq=False)
class PlacedViews:
    """Buffer views in columns (V,); a single invalid row if the document has none.

    right    whether the view is tightly packed, in an existing buffer
    """

    right: Bools
    buffer: Column
    start: Column
    length: Column


def _placed_views(document: Document) -> PlacedViews:
    entries = document["bufferViews"] or [{}]
    buffer, length = whole_numbers(entries, "buffer"), whole_numbers(entries, "byteLength")
    start = whole_numbers(entries, "byteOffset", 0)
    right = (start >= 0) & (length >= 0) & (buffer >= 0) & (buffer < len(document["buffers"]))
    right &= ~named(entries, "byteStride")
    return PlacedViews(right, buffer, start, length)


def _sift(usable: Bools, in_buffer: Bools, accessors: PlainFloats, numbers: Floats32) -> None:
    """Clears `usable` of the accessors in one buffer that share a run of floats with an unusable number.

    in_buffer    (A,) the accessors of the buffer
    """
    rows = np.flatnonzero(in_buffer)
    if not len(rows):
        return
    rows = rows[np.argsort(accessors.first[rows], kind="stable")]
    first, reach = accessors.first[rows], np.maximum.accumulate(accessors.last[rows])
    starts = np.flatnonzero(np.append(True, first[1:] > reach[:-1]))
    for start, end in zip(starts, [*starts[1:], len(rows)], strict=True):
        if not is_usable(numbers[first[start] : reach[end - 1]]):
            usable[rows[start:end]] = False


def is_usable(numbers: Floats32) -> bool:
    """Returns whether all numbers are finite and none is beyond 1e24."""
    return bool(_kernels.within(np.require(numbers, requirements=["C", "A"]), *BOUNDS))
