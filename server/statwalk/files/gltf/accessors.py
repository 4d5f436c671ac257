"""Accessors: typed arrays over buffer views (glTF 2.0, 3.6.2).

Sizes are computed as Python ints and compared with the data before memory is allocated; an accessor without a
buffer view is all zeros and counts like any other. Plain accessors are views of the file's bytes, without a
copy.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.errors import ModelError
from statwalk.files.gltf import check
from statwalk.files.gltf.allowance import Allowance, accessor_bytes
from statwalk.files.gltf.check import Json
from statwalk.files.gltf.document import Document
from statwalk.files.gltf.formats import (
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
from statwalk.files.gltf.plain import plain_floats
from statwalk.files.gltf.views import Views

Array = NDArray[Any]


@dataclass
class Accessors:
    """The accessors of a document; each is read on first use."""

    document: Document
    views: Views
    arrays: dict[int, Array] = field(default_factory=dict)
    bytes: Allowance = field(default_factory=accessor_bytes)

    def __post_init__(self) -> None:
        self.entries = self.document["accessors"]
        self.plain = plain_floats(self.document, self.views)
        """the accessors whose numbers are all checked"""
        self.bytes.take(self.plain.bytes, "/accessors")

    def read(self, row: int, allowed: Allowed, place: str) -> Array:
        """Returns the raw array (count,) or (count, n) of an accessor.

        :raises ModelError: when the accessor's type is not allowed; `place` is the JSON pointer of the
            reference.
        """
        entry = self.entries[row]
        if entry.get("type") not in allowed[0] or entry.get("componentType") not in allowed[1]:
            actual = f"{check.shown(entry.get('type'))} of {check.shown(entry.get('componentType'))}"
            raise ModelError(
                f"accessor {row} is {actual}; it must be {' or '.join(allowed[0])} of {allowed[1]}",
                place=place,
            )
        return self.array(row)

    def floats(self, row: int, allowed: Allowed, place: str) -> NDArray[np.float32]:
        """Returns the array as finite float32; normalised integers become fractions of 1 (3.6.2.2).

        :raises ModelError: when the accessor's type is not allowed, or a number is not finite or too large.
        """
        if self.plain.usable[row] and self.entries[row]["type"] in allowed[0]:
            return self.array(row)
        raw = self.read(row, allowed, place)
        entry = self.entries[row]
        component = entry["componentType"]
        if component == FLOAT:
            return self.finite(raw, row)
        self.bytes.take(2 * raw.size * FLOAT_BYTES, f"/accessors/{row}/count")
        values = raw.astype(np.float32)
        if _is_normalized(entry, f"/accessors/{row}"):
            values = np.maximum(values / np.float32(LARGEST_INTEGER[component]), np.float32(-1))
        return values

    def finite(self, values: Array, row: int) -> Array:
        """Returns the values, none of them beyond 1e24.

        The sum of squares checks all values in one pass; only a huge sum needs a closer look.

        :raises ModelError: when a value is not finite or beyond 1e24.
        """
        flat = values.ravel()
        if not math.isfinite(np.dot(flat, flat)) and not np.abs(flat).max() <= check.LARGEST:
            raise ModelError(
                f"the accessor has a number that is not finite, or beyond {check.LARGEST:g}",
                place=f"/accessors/{row}",
            )
        return values

    def array(self, row: int) -> Array:
        """Returns the raw array of an accessor."""
        if row not in self.arrays:
            plain = self.plain.array(row)
            self.arrays[row] = self.opened(self.entries[row], f"/accessors/{row}") if plain is None else plain
        return self.arrays[row]

    def opened(self, entry: Json, place: str) -> Array:
        """Returns the array that an accessor describes, after all bounds are checked.

        :raises ModelError: when a field is wrong or the data are too short.
        """
        component = check.one_of(entry, "componentType", place, COMPONENTS)
        element_type = check.one_of(entry, "type", place, ELEMENTS)
        count = check.integer(entry, "count", place, minimum=1)
        size = element_bytes(element_type, component)
        self.bytes.take(count * size, f"{place}/count")
        if "bufferView" not in entry:
            values = np.zeros((count, size // COMPONENT_BYTES[component]), COMPONENTS[component])
        else:
            view = check.required_reference(
                entry, "bufferView", place, self.document["bufferViews"], "bufferView"
            )
            start = check.integer(entry, "byteOffset", place, 0)
            values = self.window(view, start, count, size, component, place)
        if "sparse" in entry:
            values = self._substituted(
                values, check.mapping(entry, "sparse", place), size, component, f"{place}/sparse"
            )
        return _shaped(values, element_type)

    def window(self, view: int, start: int, count: int, size: int, component: int, place: str) -> Array:
        """Returns (count, n) components of a buffer view from byte `start`; an element has `size` bytes, and
        elements follow at the view's stride.

        :raises ModelError: when the elements do not fit into the view.
        """
        data, stride = self.views.open(view)
        step = stride or size
        if step < size:
            raise ModelError(
                f"the view's byteStride is {stride}, less than an element of {size} bytes",
                place=f"{place}/bufferView",
            )
        end = start + step * (count - 1) + size
        if end > len(data):
            raise ModelError(
                f"the accessor ends at byte {end} of its buffer view, which has {len(data)} bytes",
                place=place,
            )
        width = COMPONENT_BYTES[component]
        return np.ndarray((count, size // width), COMPONENTS[component], data, start, (step, width))

    def _substituted(self, values: Array, sparse: Json, size: int, component: int, place: str) -> Array:
        """Returns a copy of the values with the elements of a sparse accessor replaced (3.6.2.3)."""
        count = check.integer(sparse, "count", place, minimum=1)
        if count > len(values):
            raise ModelError(
                f"count is {count}, more than the accessor's {len(values)}", place=f"{place}/count"
            )
        self.bytes.take(count * (size + 4), f"{place}/count")
        rows = self._sparse_rows(check.mapping(sparse, "indices", place), count, f"{place}/indices")
        if int(rows[-1]) >= len(values) or np.any(rows[1:] <= rows[:-1]):
            raise ModelError(f"the indices must rise and stay below {len(values)}", place=f"{place}/indices")
        source = check.mapping(sparse, "values", place)
        view = check.required_reference(
            source, "bufferView", f"{place}/values", self.document["bufferViews"], "bufferView"
        )
        start = check.integer(source, "byteOffset", f"{place}/values", 0)
        replaced = values.copy()
        replaced[rows] = self.window(view, start, count, size, component, f"{place}/values")
        return replaced

    def _sparse_rows(self, entry: Json, count: int, place: str) -> Array:
        """Returns the rows (count,) that a sparse accessor replaces."""
        component = check.one_of(entry, "componentType", place, INDICES[1])
        view = check.required_reference(
            entry, "bufferView", place, self.document["bufferViews"], "bufferView"
        )
        start = check.integer(entry, "byteOffset", place, 0)
        return self.window(view, start, count, COMPONENT_BYTES[component], component, place)[:, 0]

    def check_rest(self) -> None:
        """Reads the accessors that nothing has used, so that a broken one is reported as well."""
        for row in np.flatnonzero(~self.plain.usable).tolist():
            self.array(row)
        self.views.check_rest()


def _shaped(values: Array, element_type: str) -> Array:
    """Returns scalars as (count,), vectors as (count, n), matrices as (count, r, r) with rows first."""
    if element_type == "SCALAR":
        return values[:, 0]
    if element_type in MATRIX_ROWS and values.shape[1] == MATRIX_ROWS[element_type] ** 2:
        return values.reshape(len(values), MATRIX_ROWS[element_type], -1).swapaxes(1, 2)
    return values


def _is_normalized(entry: Json, place: str) -> bool:
    value = entry.get("normalized", False)
    if not isinstance(value, bool):
        raise ModelError(
            f"normalized is {check.shown(value)}; it must be true or false", place=f"{place}/normalized"
        )
    return value
