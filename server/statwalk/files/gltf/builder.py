"""Collects binary data with its buffer views and accessors for a GLB."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.files.gltf.check import Json
from statwalk.files.gltf.formats import COMPONENT_OF_DTYPE, ELEMENT_OF_WIDTH

VERTICES, INDICES = 34962, 34963
GENERATOR = "statwalk"


@dataclass
class Builder:
    """The binary data, buffer views and accessors so far; an array that is added again is not written
    twice.
    """

    binary: bytearray = field(default_factory=bytearray)
    views: list[Json] = field(default_factory=list)
    accessors: list[Json] = field(default_factory=list)
    written: dict[int, tuple[int, Any]] = field(default_factory=dict)

    def view(self, size: int, target: int | None = None, stride: int | None = None) -> int:
        """Adds room for `size` bytes at a multiple of 4, as a buffer view; returns the view's index."""
        self.binary += b"\0" * (-len(self.binary) % 4)
        view: Json = {"buffer": 0, "byteOffset": len(self.binary), "byteLength": size}
        if target is not None:
            view["target"] = target
        if stride is not None:
            view["byteStride"] = stride
        self.binary += b"\0" * size
        self.views.append(view)
        return len(self.views) - 1

    def data(self, content: bytes) -> int:
        """Adds bytes as a buffer view; returns the view's index."""
        row = self.view(len(content))
        start = self.views[row]["byteOffset"]
        self.binary[start : start + len(content)] = content
        return row

    def array(self, values: NDArray[Any], target: int | None = None, *, bounds: bool = False) -> int:
        """Adds an array (count,) or (count, n) as an accessor; returns the accessor's index.

        Elements of vertices are padded to multiples of 4 bytes.
        """
        if id(values) in self.written:
            return self.written[id(values)][0]
        flat = values.reshape(len(values), -1)
        size = flat.shape[1] * flat.itemsize
        stride = -(-size // 4) * 4 if target == VERTICES else size
        view = self.view(len(flat) * stride, target, stride if stride != size else None)
        start = self.views[view]["byteOffset"]
        np.ndarray(flat.shape, flat.dtype, self.binary, start, (stride, flat.itemsize))[:] = flat
        row = self.accessor(view, flat, bounds=bounds)
        self.written[id(values)] = row, values
        return row

    def accessor(self, view: int, flat: NDArray[Any], *, bounds: bool, offset: int = 0) -> int:
        """Adds an accessor for elements like the rows of `flat` (count, n), from byte `offset` of a view;
        returns the accessor's index.
        """
        accessor: Json = {
            "bufferView": view,
            "byteOffset": offset,
            "componentType": COMPONENT_OF_DTYPE[flat.dtype.newbyteorder("<")],
            "count": len(flat),
            "type": ELEMENT_OF_WIDTH[flat.shape[1]],
        }
        if bounds:
            accessor |= {"min": flat.min(axis=0).tolist(), "max": flat.max(axis=0).tolist()}
        self.accessors.append(accessor)
        return len(self.accessors) - 1

    def finished(self, root: Json) -> Json:
        """Returns the document with the collected data; empty collections are left out, as glTF requires."""
        buffers = [{"byteLength": len(self.binary)}] if self.binary else []
        document = {**root, "buffers": buffers, "bufferViews": self.views, "accessors": self.accessors}
        return {key: value for key, value in document.items() if value or value == 0}


def index_array(indices: NDArray[np.uint32], vertices: int) -> NDArray[Any]:
    """Returns vertex numbers in the smallest type that holds them (the largest value of a type would mean
    primitive restart).
    """
    return indices.astype("<u2" if vertices < 0xFFFF else "<u4")
