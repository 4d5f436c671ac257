"""Accessors: typed arrays over buffer views (glTF 2.0, 3.6.2).

Sizes are computed in Python ints and held against what is there before memory is taken; an accessor without a buffer view is all
zeros and counts like any other. Plain ones come as views of the file's bytes, without a copy.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.errors import ModelError
from statwalk.files.glb import check
from statwalk.files.glb.allowance import Allowance, accessor_bytes
from statwalk.files.glb.check import Json
from statwalk.files.glb.document import Document
from statwalk.files.glb.formats import (
    COMPONENT_BYTES,
    COMPONENTS,
    ELEMENTS,
    FLOAT,
    FLOAT_BYTES,
    INDICES,
    LARGEST_INTEGER,
    MATRIX_ROWS,
    Allowed,
    element_bytes,
)
from statwalk.files.glb.plain import plain_floats
from statwalk.files.glb.views import Views

Array = NDArray[Any]


@dataclass
class Accessors:
    """The accessors of a document, read when they are first asked for."""

    document: Document
    views: Views
    arrays: dict[int, Array] = field(default_factory=dict)
    bytes: Allowance = field(default_factory=accessor_bytes)

    def __post_init__(self) -> None:
        self.entries = self.document["accessors"]
        self.plain = plain_floats(self.document, self.views)
        """those whose numbers were all looked at"""
        self.bytes.take(self.plain.bytes, "/accessors")

    def read(self, row: int, allowed: Allowed, place: str) -> Array:
        """The raw array (count,) or (count, n) of an accessor, which must be of an allowed type; `place` is who asks."""
        entry = self.entries[row]
        if entry.get("type") not in allowed[0] or entry.get("componentType") not in allowed[1]:
            found = f"{check.shown(entry.get('type'))} of {check.shown(entry.get('componentType'))}"
            raise ModelError(f"accessor {row} is {found}; it must be {' or '.join(allowed[0])} of {allowed[1]}", place=place)
        return self.array(row)

    def floats(self, row: int, allowed: Allowed, place: str) -> NDArray[np.float32]:
        """The array as finite float32; normalised integers become fractions of 1 (3.6.2.2)."""
        if self.plain.usable[row] and self.entries[row]["type"] in allowed[0]:
            return self.array(row)
        raw = self.read(row, allowed, place)
        entry = self.entries[row]
        component = entry["componentType"]
        if component == FLOAT:
            return self.finite(raw, row)
        self.bytes.take(2 * raw.size * FLOAT_BYTES, f"/accessors/{row}/count")
        values = raw.astype(np.float32)
        if check_normalized(entry, f"/accessors/{row}"):
            values = np.maximum(values / np.float32(LARGEST_INTEGER[component]), np.float32(-1))
        return values

    def finite(self, values: Array, row: int) -> Array:
        """The values, none of them beyond 1e24. A sum of squares tells it in one pass; only a huge one needs a closer look."""
        flat = values.ravel()
        if not math.isfinite(np.dot(flat, flat)) and not np.abs(flat).max() <= check.LARGEST:
            raise ModelError(f"it holds a number that is not finite, or beyond {check.LARGEST:g}", place=f"/accessors/{row}")
        return values

    def array(self, row: int) -> Array:
        """The raw array of an accessor."""
        if row not in self.arrays:
            plain = self.plain.array(row)
            self.arrays[row] = self.opened(self.entries[row], f"/accessors/{row}") if plain is None else plain
        return self.arrays[row]

    def opened(self, entry: Json, place: str) -> Array:
        """The array an accessor describes, after every bound was checked."""
        component = check.one_of(entry, "componentType", place, COMPONENTS)
        kind = check.one_of(entry, "type", place, ELEMENTS)
        count = check.integer(entry, "count", place, minimum=1)
        size = element_bytes(kind, component)
        self.bytes.take(count * size, f"{place}/count")
        if "bufferView" not in entry:
            values = np.zeros((count, size // COMPONENT_BYTES[component]), COMPONENTS[component])
        else:
            view = check.required_reference(entry, "bufferView", place, self.document["bufferViews"], "bufferView")
            start = check.integer(entry, "byteOffset", place, 0)
            values = self.window(view, start, count, size, component, place)
        if "sparse" in entry:
            values = self.substituted(values, check.mapping(entry, "sparse", place), size, component, f"{place}/sparse")
        return shaped(values, kind)

    def window(self, view: int, start: int, count: int, size: int, component: int, place: str) -> Array:
        """(count, n) components in a buffer view, from byte `start`, elements of `size` bytes at the view's stride."""
        data, stride = self.views.open(view)
        step = stride or size
        if step < size:
            raise ModelError(f"the view's byteStride is {stride}, less than an element of {size} bytes", place=f"{place}/bufferView")
        end = start + step * (count - 1) + size
        if end > len(data):
            raise ModelError(f"it ends at byte {end} of its buffer view, which has {len(data)}", place=place)
        width = COMPONENT_BYTES[component]
        return np.ndarray((count, size // width), COMPONENTS[component], data, start, (step, width))

    def substituted(self, values: Array, sparse: Json, size: int, component: int, place: str) -> Array:
        """A copy of the values with some elements replaced (3.6.2.3)."""
        count = check.integer(sparse, "count", place, minimum=1)
        if count > len(values):
            raise ModelError(f"count is {count}, more than the accessor's {len(values)}", place=f"{place}/count")
        self.bytes.take(count * (size + 4), f"{place}/count")
        rows = self.sparse_rows(check.mapping(sparse, "indices", place), count, f"{place}/indices")
        if int(rows[-1]) >= len(values) or np.any(rows[1:] <= rows[:-1]):
            raise ModelError(f"the indices must rise and stay below {len(values)}", place=f"{place}/indices")
        source = check.mapping(sparse, "values", place)
        view = check.required_reference(source, "bufferView", f"{place}/values", self.document["bufferViews"], "bufferView")
        start = check.integer(source, "byteOffset", f"{place}/values", 0)
        whole = values.copy()
        whole[rows] = self.window(view, start, count, size, component, f"{place}/values")
        return whole

    def sparse_rows(self, entry: Json, count: int, place: str) -> Array:
        """The (count,) rows that a sparse accessor replaces."""
        component = check.one_of(entry, "componentType", place, INDICES[1])
        view = check.required_reference(entry, "bufferView", place, self.document["bufferViews"], "bufferView")
        start = check.integer(entry, "byteOffset", place, 0)
        return self.window(view, start, count, COMPONENT_BYTES[component], component, place)[:, 0]

    def check_rest(self) -> None:
        """Open the accessors that nothing used, so that a broken one is reported all the same."""
        for row in np.flatnonzero(~self.plain.usable).tolist():
            self.array(row)
        self.views.check_rest()


def shaped(values: Array, kind: str) -> Array:
    """Scalars as (count,); all else as (count, n), 4 x 4 matrices as (count, 4, 4) with rows first."""
    if kind == "SCALAR":
        return values[:, 0]
    if kind in MATRIX_ROWS and values.shape[1] == MATRIX_ROWS[kind] ** 2:
        return values.reshape(len(values), MATRIX_ROWS[kind], -1).swapaxes(1, 2)
    return values


def check_normalized(entry: Json, place: str) -> bool:
    """The `normalized` flag."""
    value = entry.get("normalized", False)
    if not isinstance(value, bool):
        raise ModelError(f"normalized is {check.shown(value)}; it must be true or false", place=f"{place}/normalized")
    return value
