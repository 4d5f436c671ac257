"""The vector pool: every array of the object once, in a VECT chunk; other chunks name it by its number."""

from __future__ import annotations

from math import prod
from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.files.chunk.chunk_tree import Chunk, joined, refuse
from statwalk.files.chunk.records import KINDS, NONE, VECT
from statwalk.files.gltf.check import LARGEST

MOST_DIMENSIONS = 3
Array = NDArray[Any]


class PoolWriter:
    """Collects arrays; equal arrays are written once."""

    def __init__(self) -> None:
        self.chunks: list[bytes] = []
        self.rows: dict[bytes, int] = {}

    def add(self, values: Array | None) -> int:
        """Returns the number of an array in the pool, NONE for no array."""
        if values is None:
            return NONE
        kind = KINDS.index(values.dtype.newbyteorder("<"))
        flat = np.ascontiguousarray(values, KINDS[kind])
        sizes = np.array(values.shape, "<u4").tobytes()
        content = VECT.pack(kind, values.ndim, 0) + sizes + flat.tobytes()
        if content not in self.rows:
            self.rows[content] = len(self.chunks)
            self.chunks.append(joined("VECT", content))
        return self.rows[content]


class ArrayPool:
    """The arrays of a file, in the order of their VECT chunks."""

    def __init__(self) -> None:
        self.arrays: list[Array] = []

    def take(self, chunk: Chunk) -> None:
        """Reads a VECT chunk; its dimensions must fit its length before any memory is taken.

        :raises ModelError: when type, dimensions or length are wrong, or a number is not finite.
        """
        kind, dimensions, _ = chunk.record(VECT)
        if kind >= len(KINDS) or not 1 <= dimensions <= MOST_DIMENSIONS:
            raise refuse(chunk, f"an array has a type 0…{len(KINDS) - 1} and 1…{MOST_DIMENSIONS} dimensions")
        sizes = chunk.numbers(VECT.size, dimensions)
        start, size = VECT.size + 4 * dimensions, prod(sizes) * KINDS[kind].itemsize
        if start + size != len(chunk.content):
            raise refuse(
                chunk, f"{' × '.join(map(str, sizes))} numbers take {size} bytes, not "
                f"{len(chunk.content) - start}"
            )  # fmt: skip
        values = (
            np.frombuffer(chunk.content[start:], KINDS[kind])
            .reshape(sizes)
            .astype(KINDS[kind].newbyteorder("="))
        )
        if values.dtype.kind == "f" and not (np.abs(values) <= LARGEST).all():
            raise refuse(chunk, f"a number is not finite, or larger than {LARGEST:g}")
        self.arrays.append(values)

    def array(self, chunk: Chunk, row: int, what: str, kinds: str, shape: tuple[int | None, ...]) -> Array:
        """Returns an array that a chunk names; `kinds`: the letters of its type's kinds and sizes (`f4 f8`);
        `shape`: its dimensions, None where any number is right.

        :raises ModelError: when there is no such array, or it has another type or shape.
        """
        if row >= len(self.arrays):
            raise refuse(chunk, f"{what} is array {row}; the pool has {len(self.arrays)}")
        values = self.arrays[row]
        right = len(shape) == values.ndim and all(
            size in (None, own) for size, own in zip(shape, values.shape, strict=True)
        )
        if not right or values.dtype.str[1:] not in kinds.split():
            wanted = " × ".join("any" if size is None else str(size) for size in shape)
            raise refuse(
                chunk,
                f"{what} is {' × '.join(map(str, values.shape))} {values.dtype}; it must be {wanted} {kinds}",
            )
        return values

    def optional(
        self, chunk: Chunk, row: int, what: str, kinds: str, shape: tuple[int | None, ...]
    ) -> Array | None:
        """Returns the same, or None for NONE.

        :raises ModelError: as `array`.
        """
        return None if row == NONE else self.array(chunk, row, what, kinds, shape)


def largest(values: Array) -> int:
    """Returns the largest of whole numbers; -1 of none."""
    return int(values.max()) if values.size else -1


def below(chunk: Chunk, value: int, count: int, what: str) -> int:
    """Returns a row that a chunk names.

    :raises ModelError: when the row is not below `count`.
    """
    if not 0 <= value < count:
        raise refuse(chunk, f"{what} is {value}; there are {count}")
    return value
