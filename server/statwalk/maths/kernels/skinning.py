"""Soft skin, compiled: sixteen vertices at a time, from joint matrices to points, normals and bounds in one
pass.

The formulas are defined in `statwalk.skin.rows` and `.soft`. Here sums of products are fused, rounded once
instead of twice, so the last bit may differ.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import FLOAT, INT, LONG, inlined, kernel, read, write
from statwalk.maths.kernels.repair import (
    BLOCK,
    FINITE,
    LAST,
    RAW,
    TILE,
    XYZ,
    bounded,
    mended_normals,
    mended_points,
)
from statwalk.maths.simd.lane_columns import columns, store_xyz
from statwalk.maths.simd.lane_functions import (
    all_between,
    fused,
    highest_bits,
    least,
    lowest_bits,
    most,
    root,
    turned,
)
from statwalk.maths.simd.lanes import broadcast, load, load_at, spread, store

MATRIX = 16
"""floats of a bone's matrix: three rows of four, and four zeros"""
SCRATCH = LAST + 2 * XYZ
"""floats of memory that `skinned` needs"""
ONE = np.float32(1)
SMALLEST, LARGEST = np.float32(1e-30), np.float32(1e30)
"""bounds of squared lengths whose root is accurate"""


@kernel(read(FLOAT, 3), read(INT, 1), read(FLOAT, 3), write(FLOAT, 1))
def palette(world: Any, joints: Any, inverse_bind: Any, out: Any) -> None:
    """Writes the matrices world (J,3,4) · inverse bind (K,3,4) of the bones that follow `joints` (K,), 16
    floats each.
    """
    for bone in range(joints.shape[0]):
        joint = joints[bone]
        for row in range(3):
            a, b, c, d = (
                world[joint, row, 0],
                world[joint, row, 1],
                world[joint, row, 2],
                world[joint, row, 3],
            )
            for column in range(4):
                product = a * inverse_bind[bone, 0, column]
                product += b * inverse_bind[bone, 1, column]
                product += c * inverse_bind[bone, 2, column]
                out[MATRIX * bone + 4 * row + column] = product
            out[MATRIX * bone + 4 * row + 3] += d


@inlined
def blend(bones: Any, weights: Any, start: int, count: int, palette: Any, scratch: Any) -> None:
    """Writes the blended matrices of sixteen vertices, `count` influences each, row by row into the
    scratch.
    """
    at = start
    if count == 4:  # as in most files: without a loop
        for row in range(BLOCK):
            matrix = spread(weights, at) * load_at(palette, bones, at)
            matrix = fused(spread(weights, at + 1), load_at(palette, bones, at + 1), matrix)
            matrix = fused(spread(weights, at + 2), load_at(palette, bones, at + 2), matrix)
            matrix = fused(spread(weights, at + 3), load_at(palette, bones, at + 3), matrix)
            store(scratch, MATRIX * row, matrix)
            at += 4
        return
    for row in range(BLOCK):
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
def _moved(m: Any, positions: Any, rest_normals: Any, at: int) -> Any:
    """Sixteen points under the matrices `m`, and their normals under the inverse transposes, times the size
    of the determinants.
    """
    x, y, z = load(positions, at), load(positions, at + 16), load(positions, at + 32)
    u, v, w = load(rest_normals, at), load(rest_normals, at + 16), load(rest_normals, at + 32)
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
def _square(x: Any, y: Any, z: Any) -> Any:
    return fused(z, z, fused(y, y, x * x))


@inlined
def _keep(scratch: Any, at: int, x: Any, y: Any, z: Any) -> None:
    store(scratch, at, x)
    store(scratch, at + BLOCK, y)
    store(scratch, at + 2 * BLOCK, z)


@inlined
def cut(points: Any, normals: Any, end: int, count: int, scratch: Any) -> None:
    """Writes the part's last block from the scratch before `end`: `count` floats of points and of normals."""
    for number in range(count):
        points[end - count + number] = scratch[LAST + number]
        normals[end - count + number] = scratch[LAST + XYZ + number]


@inlined
def _bound(bounds: Any, part: int, axis: int, low: Any, high: Any, scratch: Any) -> None:
    """Writes the minimum and maximum of sixteen lanes as a part's bounds along an axis."""
    store(scratch, 0, low)
    store(scratch, BLOCK, high)
    smallest, largest = scratch[0], scratch[BLOCK]
    for lane in range(1, BLOCK):
        smallest, largest = min(smallest, scratch[lane]), max(largest, scratch[BLOCK + lane])
    bounds[part, axis], bounds[part, axis + 3] = smallest, largest


@kernel(
    read(FLOAT, 1), read(LONG, 2), read(LONG, 2), read(INT, 1), read(FLOAT, 1), read(FLOAT, 1),
    read(FLOAT, 1), write(FLOAT, 1), write(FLOAT, 1), write(FLOAT, 2), write(FLOAT, 1),
)  # fmt: skip
def skinned(
    palette: Any, spans: Any, blocks: Any, bones: Any, weights: Any, positions: Any, rest_normals: Any,
    out_positions: Any, out_normals: Any, bounds: Any, scratch: Any,
) -> None:  # fmt: skip
    """Poses all parts: writes points and unit normals (V,3), flat, and the bounds (P,6) of each part.

    spans (P,2) first vertex and number of vertices of each part; blocks (B,2) the first influence of a block
    and the number of influences of each vertex; bones (floats into the palette) and weights, vertex by
    vertex; points and normals at rest in blocks: 16 x, 16 y, 16 z.
    """
    block, one, smallest, largest = 0, broadcast(ONE), broadcast(SMALLEST), broadcast(LARGEST)
    for part in range(spans.shape[0]):
        lx = ly = lz = broadcast(FINITE)
        hx = hy = hz = broadcast(-FINITE)
        first, count, finite = spans[part, 0], spans[part, 1], True
        for tile in range(0, count, TILE):
            shortest, longest, farthest, first_block, end = one, one, one, block, min(tile + TILE, count)
            for begin in range(tile, end, BLOCK):
                blend(bones, weights, blocks[block, 0], blocks[block, 1], palette, scratch)
                x, y, z, u, v, w = _moved(columns(scratch, 0), positions, rest_normals, XYZ * block)
                lx, ly, lz, hx, hy, hz = (
                    least(x, lx),
                    least(y, ly),
                    least(z, lz),
                    most(x, hx),
                    most(y, hy),
                    most(z, hz),
                )
                _keep(scratch, RAW + 3 * (begin - tile), u, v, w)
                squared, block = _square(u, v, w), block + 1
                shortest, longest = lowest_bits(shortest, squared), highest_bits(longest, squared)
                farthest, size = highest_bits(farthest, _square(x, y, z)), one / root(squared)
                points, at, normals, normals_at = (
                    out_positions,
                    3 * (first + begin),
                    out_normals,
                    3 * (first + begin),
                )
                if end - begin < BLOCK:  # the part's last, which must not run into the next part
                    points, at, normals, normals_at = scratch, LAST, scratch, LAST + XYZ
                store_xyz(points, at, x, y, z)
                store_xyz(normals, normals_at, u * size, v * size, w * size)
            cut(out_positions, out_normals, 3 * (first + end), 3 * ((end - tile) % BLOCK), scratch)
            if not (all_between(shortest, smallest, largest) and all_between(longest, smallest, largest)):
                mended_normals(
                    scratch, rest_normals, first_block, out_normals, 3 * (first + tile), end - tile
                )
            if not all_between(farthest, smallest, largest):
                finite = mended_points(out_positions, 3 * (first + tile), 3 * (end - tile))
        _bound(bounds, part, 0, lx, hx, scratch)
        _bound(bounds, part, 1, ly, hy, scratch)
        _bound(bounds, part, 2, lz, hz, scratch)
        if not finite:
            bounded(bounds, part, out_positions, first, count)
