"""Morph targets and in-betweens, compiled: limited by memory, so every number is read once."""

from __future__ import annotations

from typing import Any

from statwalk.maths.compiling import FLOAT, LONG, kernel, read, write
from statwalk.maths.simd.lane_functions import fused
from statwalk.maths.simd.lanes import LANES, broadcast, load, spread, store


@kernel(read(FLOAT, 1), read(FLOAT, 1), read(FLOAT, 1), read(LONG, 1), write(FLOAT, 1))
def morphed(base: Any, displacements: Any, weights: Any, starts: Any, out: Any) -> None:
    """Writes base (n,) + Σ weights (M,) · displacements (…,); target k has the n floats from starts (M,) on;
    n in blocks of 48.
    """
    for at in range(0, base.shape[0], 3 * LANES):
        x, y, z = load(base, at), load(base, at + LANES), load(base, at + 2 * LANES)
        for target in range(weights.shape[0]):
            weight, row = spread(weights, target), starts[target] + at
            x = fused(weight, load(displacements, row), x)
            y = fused(weight, load(displacements, row + LANES), y)
            z = fused(weight, load(displacements, row + 2 * LANES), z)
        store(out, at, x)
        store(out, at + LANES, y)
        store(out, at + 2 * LANES, z)


@kernel(read(FLOAT, 1), read(FLOAT, 1), FLOAT, write(FLOAT, 1))
def inbetween(start: Any, end: Any, fraction: Any, out: Any) -> None:
    """Writes start (n,) + (end (n,) - start) · fraction."""
    part, whole = broadcast(fraction), start.shape[0] // (4 * LANES) * (4 * LANES)
    for first in range(0, whole, 4 * LANES):
        for at in range(first, first + 4 * LANES, LANES):
            value = load(start, at)
            store(out, at, fused(load(end, at) - value, part, value))
    for at in range(whole, start.shape[0]):
        out[at] = start[at] + (end[at] - start[at]) * fraction
