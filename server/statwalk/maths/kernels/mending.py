"""The slow ways of skinning, for what a fast pass has found to be no number, or of no length; one number at a time."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import boolean

from statwalk.maths.kernels.compiling import FLOAT, LONG, inlined, kernel, read, write

BLOCK, TILE = 16, 128
XYZ = 3 * BLOCK
"""floats of a block's points: 16 x, 16 y, 16 z"""
RAW = 16 * BLOCK
"""where in the scratch the normals of a tile are, not yet of unit length, by blocks"""
LAST = RAW + 3 * TILE
"""where in it the last block of a part waits to be cut off"""
ONE, ZERO = np.float32(1), np.float32(0)
FINITE = np.float32(3.4028234663852886e38)
"""the largest number"""


@inlined
def size_of(x: Any, y: Any, z: Any) -> Any:
    """The largest component's size; 0 where one of them is no finite number."""
    x, y, z = abs(x), abs(y), abs(z)
    if x <= FINITE and y <= FINITE and z <= FINITE:
        return max(x, y, z)
    return ZERO


@kernel(write(FLOAT, 1), read(FLOAT, 1), LONG, write(FLOAT, 1), LONG, LONG)
def mended_normals(raw: Any, rest: Any, block: int, out: Any, at: int, count: int) -> None:
    """The normals of a tile once more, one by one and whatever they are: where one has no length, the vertex's normal at rest."""
    for vertex in range(count):
        lane = 3 * (vertex - vertex % BLOCK) + vertex % BLOCK
        row, other = RAW + lane, XYZ * block + lane
        x, y, z = raw[row], raw[row + 16], raw[row + 32]
        size = size_of(x, y, z)
        if size == ZERO:
            x, y, z = rest[other], rest[other + 16], rest[other + 32]
            size = size_of(x, y, z)
        if size == ZERO:
            x, y, z, size = ZERO, ZERO, ONE, ONE
        x, y, z = x / size, y / size, z / size
        length = np.sqrt(x * x + y * y + z * z)
        first = at + 3 * vertex
        out[first], out[first + 1], out[first + 2] = x / length, y / length, z / length


@kernel(write(FLOAT, 1), LONG, LONG, returns=boolean)
def mended_points(points: Any, at: int, count: int) -> bool:
    """Makes the coordinates finite, as numpy.nan_to_num does; False, for bounds found before are not to be trusted."""
    for row in range(at, at + count):
        value = points[row]
        points[row] = ZERO if np.isnan(value) else min(max(value, -FINITE), FINITE)
    return False


@kernel(write(FLOAT, 2), LONG, write(FLOAT, 1), LONG, LONG)
def bounded(bounds: Any, part: int, points: Any, first: int, count: int) -> None:
    """The bounds of a part from its finished points."""
    for axis in range(3):
        low = high = points[3 * first + axis]
        for vertex in range(first, first + count):
            low, high = min(low, points[3 * vertex + axis]), max(high, points[3 * vertex + axis])
        bounds[part, axis], bounds[part, axis + 3] = low, high
