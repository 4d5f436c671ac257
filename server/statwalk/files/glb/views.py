"""Buffers and buffer views: bytes, checked to be there before anything points at them."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from statwalk.errors import ModelError
from statwalk.files.glb import check
from statwalk.files.glb.allowance import Allowance, blank_bytes
from statwalk.files.glb.document import Document
from statwalk.files.glb.resources import resource

SMALLEST_STRIDE, LARGEST_STRIDE = 4, 252


@dataclass
class Views:
    """The buffer views of a document, opened when they are first asked for.

    binary    the binary chunk of a .glb (empty where it has none); None for a .gltf
    """

    document: Document
    binary: memoryview | None
    folder: Path | None
    buffers: dict[int, memoryview] = field(default_factory=dict)
    blank: Allowance = field(default_factory=blank_bytes)

    def open(self, row: int) -> tuple[memoryview, int]:
        """The bytes of a view, and its stride (0 = tightly packed)."""
        place = f"/bufferViews/{row}"
        view = self.document["bufferViews"][row]
        buffer = self.buffer(check.required_reference(view, "buffer", place, self.document["buffers"], "buffer"))
        start = check.integer(view, "byteOffset", place, 0)
        length = check.integer(view, "byteLength", place)
        if start + length > len(buffer):
            raise ModelError(f"it ends at byte {start + length}, but the buffer has {len(buffer)}", place=f"{place}/byteLength")
        return buffer[start : start + length], self.stride(view.get("byteStride"), place)

    def stride(self, value: object, place: str) -> int:
        """A stride of 4…252 bytes; 0 where there is none."""
        if value is None:
            return 0
        if type(value) is not int or not SMALLEST_STRIDE <= value <= LARGEST_STRIDE:
            raise ModelError(f"byteStride is {check.shown(value)}; it must be 4 to 252", place=f"{place}/byteStride")
        return value

    def buffer(self, row: int) -> memoryview:
        """The bytes of a buffer, as many as it says it has."""
        if row not in self.buffers:
            self.buffers[row] = self.opened(row)
        return self.buffers[row]

    def check_rest(self) -> None:
        """Open the buffers with an address that nothing used, so that a broken one is reported all the same."""
        for row, entry in enumerate(self.document["buffers"]):
            if "uri" in entry:
                self.buffer(row)

    def opened(self, row: int) -> memoryview:
        """The bytes a buffer points at, checked to be as many as it says."""
        place = f"/buffers/{row}"
        entry = self.document["buffers"][row]
        length = check.integer(entry, "byteLength", place)
        if "uri" in entry:
            data = memoryview(resource(check.text(entry, "uri", place), self.folder, f"{place}/uri"))
        elif self.binary is None:
            data = self.zeros(length, place)
        elif row == 0:
            data = self.binary
        else:
            raise ModelError("it has no uri; only the first buffer can be the binary chunk", place=place)
        if len(data) < length:
            raise ModelError(f"byteLength is {length}, but there are {len(data)} bytes", place=f"{place}/byteLength")
        return data[:length]

    def zeros(self, length: int, place: str) -> memoryview:
        """What a .gltf's buffer without an address holds. glTF leaves it undefined (3.6.1); like an accessor without a view it is zeros."""
        self.blank.take(length, f"{place}/byteLength")
        self.document.note("a buffer without a uri has no data: it is all zeros")
        return memoryview(bytes(length))
