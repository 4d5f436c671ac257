"""Sixteen vertices at a time, compiled: the parts of `_kernels.skinned`.

`rows` and `soft` define the formulas. Here sums of products are fused, rounded once instead of twice, so the
last bit may differ.
"""

from __future__ import annotations

from typing import Any

from statwalk.maths.compiling import inlined
from statwalk.maths.simd.lane_functions import fused, turned
from statwalk.maths.simd.lanes import LANES, load_at, spread, store
from statwalk.maths.simd.pose_lanes import load3
from statwalk.skin.repair import LAST, MATRIX, XYZ


@inlined
def blend_matrices(bones: Any, weights: Any, start: int, count: int, palette: Any, scratch: Any) -> None:
    """Writes the blended matrices of sixteen vertices, `count` influences each, row by row into the
    scratch.
    """
    at = start
    if count == 4:  # as in most files: without a loop
        for row in range(LANES):
            matrix = spread(weights, at) * load_at(palette, bones, at)
            matrix = fused(spread(weights, at + 1), load_at(palette, bones, at + 1), matrix)
            matrix = fused(spread(weights, at + 2), load_at(palette, bones, at + 2), matrix)
            matrix = fused(spread(weights, at + 3), load_at(palette, bones, at + 3), matrix)
            store(scratch, MATRIX * row, matrix)
            at += 4
        return
    for row in range(LANES):
        matrix = spread(weights, at) * load_at(palette, bones, at)
        for influence in range(at + 1, at + count):
            matrix = fused(spread(weights, influence), load_at(palette, bones, influence), matrix)
        store(scratch, MATRIX * row, matrix)
        at += count


@inlined
def _cross(a: Any, b: Any) -> Any:
    x, y, z = a[2] * b[1], a[0] * b[2], a[1] * b[0]
    return fused(a[1], b[2], -x), fused(a[2], b[0], -y), fused(a[0], b[1], -z)


@inlined
def _dot(row: Any, x: Any, y: Any, z: Any) -> Any:
    return fused(row[2], z, fused(row[1], y, row[0] * x))


@inlined
def moved(m: Any, positions: Any, rest_normals: Any, at: int) -> Any:
    """Returns sixteen points under the matrices `m`, and their normals under the inverse transposes, times
    the size of the determinants.
    """
    x, y, z = load3(positions, at)
    u, v, w = load3(rest_normals, at)
    first, second, third = (m[0], m[1], m[2]), (m[4], m[5], m[6]), (m[8], m[9], m[10])
    a, b, c = _cross(second, third), _cross(third, first), _cross(first, second)
    sign = _dot(first, a[0], a[1], a[2])  # a mirror's is negative
    return (
        _dot(first, x, y, z) + m[3],
        _dot(second, x, y, z) + m[7],
        _dot(third, x, y, z) + m[11],
        turned(_dot(a, u, v, w), sign),
        turned(_dot(b, u, v, w), sign),
        turned(_dot(c, u, v, w), sign),
    )


@inlined
def square(x: Any, y: Any, z: Any) -> Any:
    """Returns the squared lengths of sixteen vectors."""
    return fused(z, z, fused(y, y, x * x))


@inlined
def cut(points: Any, normals: Any, end: int, count: int, scratch: Any) -> None:
    """Writes the part's last block from the scratch before `end`: `count` floats of points and of normals."""
    for number in range(count):
        points[end - count + number] = scratch[LAST + number]
        normals[end - count + number] = scratch[LAST + XYZ + number]


@inlined
def bound(bounds: Any, part: int, axis: int, low: Any, high: Any, scratch: Any) -> None:
    """Writes the minimum and maximum of sixteen lanes as a part's bounds along an axis."""
    store(scratch, 0, low)
    store(scratch, LANES, high)
    smallest, largest = scratch[0], scratch[LANES]
    for lane in range(1, LANES):
        smallest, largest = min(smallest, scratch[lane]), max(largest, scratch[LANES + lane])
    bounds[part, axis], bounds[part, axis + 3] = smallest, largest
