"""The slow paths of skinning, for values that the fast pass found to be no finite number, or of no length;
one number at a time.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import boolean

from statwalk.maths.compiling import FLOAT, LONG, inlined, kernel, read, write
from statwalk.maths.simd.lanes import LANES

TILE = 128
XYZ = 3 * LANES
"""floats of a block's points: 16 x, 16 y, 16 z"""
MATRIX = 16
"""floats of a bone's matrix: three rows of four, and four zeros"""
NUMBERS = 12
"""numbers of a bone's matrix: three rows of four"""
RAW = MATRIX * LANES
"""index in the scratch of a tile's normals, not yet of unit length, in blocks"""
LAST = RAW + 3 * TILE
"""index in the scratch of the last block of a part, until it is cut off"""
SCRATCH = LAST + 2 * XYZ
"""floats of memory that `_kernels.skinned` needs"""
ONE, ZERO = np.float32(1), np.float32(0)
FINITE = np.float32(3.4028234663852886e38)
"""the largest float32"""


@inlined
def _size_of(x: Any, y: Any, z: Any) -> Any:
    """The size of the largest component; 0 if a component is not finite."""
    x, y, z = abs(x), abs(y), abs(z)
    if x <= FINITE and y <= FINITE and z <= FINITE:
        return max(x, y, z)
    return ZERO


@kernel(write(FLOAT, 1), read(FLOAT, 1), LONG, write(FLOAT, 1), LONG, LONG)
def mended_normals(raw: Any, rest: Any, block: int, out: Any, at: int, count: int) -> None:
    """Writes the normals of a tile again, one by one and for all values; a normal without length becomes the
    vertex's normal at rest.
    """
    for vertex in range(count):
        lane = 3 * (vertex - vertex % LANES) + vertex % LANES
        row, other = RAW + lane, XYZ * block + lane
        x, y, z = raw[row], raw[row + LANES], raw[row + 2 * LANES]
        size = _size_of(x, y, z)
        if size == ZERO:
            x, y, z = rest[other], rest[other + LANES], rest[other + 2 * LANES]
            size = _size_of(x, y, z)
        if size == ZERO:
            x, y, z, size = ZERO, ZERO, ONE, ONE
        x, y, z = x / size, y / size, z / size
        length = np.sqrt(x * x + y * y + z * z)
        first = at + 3 * vertex
        out[first], out[first + 1], out[first + 2] = x / length, y / length, z / length


@kernel(write(FLOAT, 1), LONG, LONG, returns=boolean)
def mended_points(points: Any, at: int, count: int) -> bool:
    """Makes the coordinates finite, as numpy.nan_to_num does; returns False, as bounds computed before are
    invalid.
    """
    for row in range(at, at + count):
        value = points[row]
        points[row] = ZERO if np.isnan(value) else min(max(value, -FINITE), FINITE)
    return False


@kernel(write(FLOAT, 2), LONG, write(FLOAT, 1), LONG, LONG)
def bounded(bounds: Any, part: int, points: Any, first: int, count: int) -> None:
    """Writes the bounds of a part from its finished points."""
    for axis in range(3):
        low = high = points[3 * first + axis]
        for vertex in range(first, first + count):
            low, high = min(low, points[3 * vertex + axis]), max(high, points[3 * vertex + axis])
        bounds[part, axis], bounds[part, axis + 3] = low, high
