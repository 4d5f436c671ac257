"""The kernels that check all numbers of a model: each number is read once, and nothing is allocated."""

from __future__ import annotations

from typing import Any

from numba import types

from statwalk.maths.compiling import FLOAT, kernel, read
from statwalk.maths.simd.lane_columns import load_xyz
from statwalk.maths.simd.lane_functions import all_between
from statwalk.maths.simd.lanes import LANES, broadcast, load


@kernel(read(FLOAT, 1), FLOAT, FLOAT, returns=types.boolean)
def within(numbers: Any, low: Any, high: Any) -> Any:
    """Returns whether low < x < high for all numbers (n,); false for NaN."""
    first, last, whole = broadcast(low), broadcast(high), numbers.shape[0] // LANES * LANES
    out = 0
    for at in range(0, whole, LANES):
        out += not all_between(load(numbers, at), first, last)
    for at in range(whole, numbers.shape[0]):
        out += not low < numbers[at] < high
    return out == 0


@kernel(read(FLOAT, 2), FLOAT, returns=types.boolean)
def unit_length(vectors: Any, tolerance: Any) -> Any:
    """Returns whether the squared lengths of all vectors (V,3) are within a tolerance of 1."""
    one, low, high, whole = (
        broadcast(FLOAT(1)),
        broadcast(-tolerance),
        broadcast(tolerance),
        vectors.shape[0] // LANES * LANES,
    )
    off = 0
    for row in range(0, whole, LANES):
        x, y, z = load_xyz(vectors, 3 * row)
        off += not all_between(x * x + y * y + z * z - one, low, high)
    for row in range(whole, vectors.shape[0]):
        a, b, c = vectors[row, 0], vectors[row, 1], vectors[row, 2]
        off += not abs(a * a + b * b + c * c - FLOAT(1)) < tolerance
    return off == 0
