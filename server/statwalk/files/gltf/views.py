"""Buffers and buffer views: bytes, checked to exist before anything refers to them."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from statwalk.errors import ModelError
from statwalk.files.gltf import check
from statwalk.files.gltf.allowance import Allowance, blank_bytes
from statwalk.files.gltf.document import Document
from statwalk.files.gltf.resources import resource

SMALLEST_STRIDE, LARGEST_STRIDE = 4, 252


@dataclass
class Views:
    """The buffer views of a document; each is read on first use.

    binary    the binary chunk of a .glb (empty if it has none); None for a .gltf
    """

    document: Document
    binary: memoryview | None
    folder: Path | None
    buffers: dict[int, memoryview] = field(default_factory=dict)
    blank: Allowance = field(default_factory=blank_bytes)

    def open(self, row: int) -> tuple[memoryview, int]:
        """Returns the bytes of a view, and its stride (0: tightly packed).

        :raises ModelError: when the view does not fit into its buffer, or its stride is wrong.
        """
        place = f"/bufferViews/{row}"
        view = self.document["bufferViews"][row]
        buffer = self.buffer(
            check.required_reference(view, "buffer", place, self.document["buffers"], "buffer")
        )
        start = check.integer(view, "byteOffset", place, 0)
        length = check.integer(view, "byteLength", place)
        if start + length > len(buffer):
            raise ModelError(
                f"the view ends at byte {start + length}, but the buffer has {len(buffer)} bytes",
                place=f"{place}/byteLength",
            )
        return buffer[start : start + length], self.stride(view.get("byteStride"), place)

    def stride(self, value: object, place: str) -> int:
        """Returns a stride of 4…252 bytes; 0 if there is none."""
        if value is None:
            return 0
        if type(value) is not int or not SMALLEST_STRIDE <= value <= LARGEST_STRIDE:
            raise ModelError(
                f"byteStride is {check.shown(value)}; it must be 4 to 252", place=f"{place}/byteStride"
            )
        return value

    def buffer(self, row: int) -> memoryview:
        """Returns the bytes of a buffer, `byteLength` of them."""
        if row not in self.buffers:
            self.buffers[row] = self.opened(row)
        return self.buffers[row]

    def check_rest(self) -> None:
        """Reads the buffers with a URI that nothing has used, so that a broken one is reported as well."""
        for row, entry in enumerate(self.document["buffers"]):
            if "uri" in entry:
                self.buffer(row)

    def opened(self, row: int) -> memoryview:
        """Reads the bytes of a buffer, `byteLength` of them.

        :raises ModelError: when the buffer has no data, or too few.
        """
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
            raise ModelError(
                "the buffer has no uri; only the first buffer can be the binary chunk", place=place
            )
        if len(data) < length:
            raise ModelError(
                f"byteLength is {length}, but the buffer has {len(data)} bytes", place=f"{place}/byteLength"
            )
        return data[:length]

    def zeros(self, length: int, place: str) -> memoryview:
        """Returns the content of a .gltf's buffer without a URI. glTF leaves it undefined (3.6.1); like an
        accessor without a view it is zeros.
        """
        self.blank.take(length, f"{place}/byteLength")
        self.document.note("a buffer without a uri has no data: it is all zeros")
        return memoryview(bytes(length))
