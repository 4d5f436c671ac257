"""The kernels for the keys of clips: each number is read once, and nothing is allocated."""

from __future__ import annotations

from math import sqrt
from typing import Any

from numba import types

from statwalk.maths.compiling import FLOAT, LONG, kernel, read, write
from statwalk.maths.simd.lanes import LANES, load, store


@kernel(read(FLOAT, 1), read(LONG, 1), read(LONG, 1), write(FLOAT, 1))
def gathered(numbers: Any, starts: Any, counts: Any, out: Any) -> None:
    """Writes out (…,): counts[i] numbers from starts[i] on, for all i one after the other."""
    at = 0
    for row in range(starts.shape[0]):
        first, count = starts[row], counts[row]
        whole = count // LANES * LANES
        for k in range(0, whole, LANES):
            store(out, at + k, load(numbers, first + k))
        for k in range(whole, count):
            out[at + k] = numbers[first + k]
        at += count


@kernel(read(FLOAT, 2), read(LONG, 1), write(types.boolean, 1))
def constant(values: Any, ends: Any, out: Any) -> None:
    """Writes out (C,): whether all keys of a channel are equal; the keys in values (S,n) end before the
    channel's entry of `ends`.
    """
    first, width = 0, values.shape[1]
    for channel in range(ends.shape[0]):
        last = ends[channel]
        same, row = True, first + 1
        while same and row < last:
            for k in range(width):
                same &= values[row, k] == values[first, k]
            row += 1
        out[channel] = same
        first = last


@kernel(read(FLOAT, 2), read(LONG, 1), write(FLOAT, 2))
def lines(values: Any, ends: Any, rows: Any) -> None:
    """Writes rows (S,2n): each key of values (S,n) and the difference to the next; 0 for a channel's last
    key, before its entry of `ends`.
    """
    width, first = values.shape[1], 0
    for channel in range(ends.shape[0]):
        last = ends[channel] - 1
        if width == 3:
            for row in range(first, last):
                x, y, z = values[row, 0], values[row, 1], values[row, 2]
                rows[row, 0], rows[row, 1], rows[row, 2] = x, y, z
                rows[row, 3], rows[row, 4], rows[row, 5] = (
                    values[row + 1, 0] - x,
                    values[row + 1, 1] - y,
                    values[row + 1, 2] - z,
                )
        else:
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
    """Writes rows (S,8): each quaternion of values (S,4) at unit length, and the next one on its side; a
    channel's last key follows itself.
    """
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
