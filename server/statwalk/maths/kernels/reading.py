"""What a reader of files does with all numbers of a model, compiled: each is looked at once, and nothing is set aside."""

from __future__ import annotations

from math import sqrt
from typing import Any

from numba import types

from statwalk.maths.kernels.compiling import FLOAT, LONG, kernel, read, write
from statwalk.maths.kernels.laneops import all_between
from statwalk.maths.kernels.lanes import WIDTH, broadcast, load


@kernel(read(FLOAT, 1), FLOAT, FLOAT, returns=types.boolean)
def within(numbers: Any, low: Any, high: Any) -> Any:
    """Whether low < x < high for all numbers (n,); no for what is not a number."""
    first, last, whole = broadcast(low), broadcast(high), numbers.shape[0] // WIDTH * WIDTH
    out = 0
    for at in range(0, whole, WIDTH):
        out += not all_between(load(numbers, at), first, last)
    for at in range(whole, numbers.shape[0]):
        out += not low < numbers[at] < high
    return out == 0


@kernel(read(FLOAT, 2), FLOAT, returns=types.boolean)
def unit_length(vectors: Any, tolerance: Any) -> Any:
    """Whether the squares of all vectors (V,3) are within a tolerance of 1."""
    off = 0
    for row in range(vectors.shape[0]):
        x, y, z = vectors[row, 0], vectors[row, 1], vectors[row, 2]
        off += not abs(x * x + y * y + z * z - FLOAT(1)) < tolerance
    return off == 0


@kernel(read(FLOAT, 2), FLOAT, returns=LONG)
def normalised(weights: Any, tolerance: Any) -> Any:
    """How many columns of weights (V,4) have any; 0 where not all rows sum to 1 within a tolerance, and fall."""
    off = used = 0
    for row in range(weights.shape[0]):
        a, b, c, d = weights[row, 0], weights[row, 1], weights[row, 2], weights[row, 3]
        off += not abs(a + b + c + d - FLOAT(1)) <= tolerance
        off += not ((a >= b) & (b >= c) & (c >= d))
        used = max(used, (b > 0) + (c > 0) + (d > 0))
    return 0 if off else used + 1


@kernel(read(FLOAT, 1), read(LONG, 1), read(LONG, 1), write(FLOAT, 1))
def gathered(numbers: Any, starts: Any, counts: Any, out: Any) -> None:
    """out (…,): the counts[i] numbers from starts[i] on, for all i one after the other."""
    at = 0
    for row in range(starts.shape[0]):
        for k in range(counts[row]):
            out[at + k] = numbers[starts[row] + k]
        at += counts[row]


@kernel(read(FLOAT, 2), read(LONG, 1), write(FLOAT, 2))
def lines(values: Any, ends: Any, rows: Any) -> None:
    """rows (S,2n): each key of values (S,n) and the way to the next; a channel's last key, before one of its `ends`, has none."""
    width, first = values.shape[1], 0
    for channel in range(ends.shape[0]):
        last = ends[channel] - 1
        for row in range(first, last):
            for k in range(width):
                rows[row, k] = values[row, k]
                rows[row, width + k] = values[row + 1, k] - values[row, k]
        for k in range(width):
            rows[last, k] = values[last, k]
            rows[last, width + k] = FLOAT(0)
        first = last + 1


@kernel(read(FLOAT, 2), read(LONG, 1), write(FLOAT, 2))
def turns(values: Any, ends: Any, rows: Any) -> None:
    """rows (S,8): each quaternion of values (S,4) at unit length, and the next one on its side; the last of a channel follows itself."""
    first = 0
    for channel in range(ends.shape[0]):
        last = ends[channel] - 1
        px = py = pz = pw = 0.0
        for row in range(first, last + 1):
            x, y = types.float64(values[row, 0]), types.float64(values[row, 1])
            z, w = types.float64(values[row, 2]), types.float64(values[row, 3])
            size = sqrt(x * x + y * y + z * z + w * w)
            if size == 0:
                x, y, z, w = 0.0, 0.0, 0.0, 1.0
            else:
                x, y, z, w = x / size, y / size, z / size, w / size
            rows[row, 0], rows[row, 1], rows[row, 2], rows[row, 3] = x, y, z, w
            if row > first:
                sign = -1.0 if px * x + py * y + pz * z + pw * w < 0 else 1.0
                rows[row - 1, 4], rows[row - 1, 5] = sign * x, sign * y
                rows[row - 1, 6], rows[row - 1, 7] = sign * z, sign * w
            px, py, pz, pw = x, y, z, w
        rows[last, 4], rows[last, 5], rows[last, 6], rows[last, 7] = px, py, pz, pw
        first = last + 1
