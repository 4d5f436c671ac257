"""The kernels that Python calls for vertices: skin weights, morph targets, bones and soft skin."""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import FLOAT, INT, LONG, kernel, read, write
from statwalk.maths.simd.lane_columns import columns, load_quads, store_xyz
from statwalk.maths.simd.lane_functions import (
    all_between,
    any_above,
    fused,
    highest_bits,
    least,
    lowest_bits,
    most,
    root,
)
from statwalk.maths.simd.lanes import LANES, broadcast, load, spread, store
from statwalk.maths.simd.pose_lanes import load3, store3
from statwalk.skin.repair import (
    FINITE,
    LAST,
    MATRIX,
    RAW,
    TILE,
    XYZ,
    bounded,
    mended_normals,
    mended_points,
)
from statwalk.skin.vertex_lanes import blend_matrices, bound, cut, moved, square

ONE = np.float32(1)
SMALLEST, LARGEST = np.float32(1e-30), np.float32(1e30)
"""bounds of squared lengths whose root is accurate"""


@kernel(read(FLOAT, 2), FLOAT, returns=LONG)
def normalised(weights: Any, tolerance: Any) -> Any:
    """Returns the number of columns of weights (V,4) in use; 0 unless all rows sum to 1 within a tolerance
    and fall without negative weights.
    """
    one, low, high, whole = (
        broadcast(FLOAT(1)),
        broadcast(-tolerance),
        broadcast(tolerance),
        weights.shape[0] // LANES * LANES,
    )
    off = used = 0
    zero = broadcast(FLOAT(0))
    risen = second = third = fourth = zero
    for row in range(0, whole, LANES):
        a, b, c, d = load_quads(weights, 4 * row)
        off += not all_between(a + b + c + d - one, low, high)
        risen = most(most(most(b - a, c - b), most(d - c, -d)), risen)
        second, third, fourth = most(b, second), most(c, third), most(d, fourth)
    off += any_above(risen, zero)
    used = any_above(second, zero) + any_above(third, zero) + any_above(fourth, zero)
    for row in range(whole, weights.shape[0]):
        e, f, g, h = weights[row, 0], weights[row, 1], weights[row, 2], weights[row, 3]
        off += not abs(e + f + g + h - FLOAT(1)) < tolerance
        off += not ((e >= f) & (f >= g) & (g >= h) & (h >= 0))
        used = max(used, (f > 0) + (g > 0) + (h > 0))
    return 0 if off else used + 1


@kernel(read(FLOAT, 1), read(FLOAT, 1), read(FLOAT, 1), read(LONG, 1), write(FLOAT, 1))
def morphed(base: Any, displacements: Any, weights: Any, starts: Any, out: Any) -> None:
    """Writes base (n,) + Σ weights (M,) · displacements (…,); target k has the n floats from starts (M,) on;
    n in blocks of 48.
    """
    for at in range(0, base.shape[0], 3 * LANES):
        x, y, z = load3(base, at)
        for target in range(weights.shape[0]):
            weight, row = spread(weights, target), starts[target] + at
            u, v, w = load3(displacements, row)
            x, y, z = fused(weight, u, x), fused(weight, v, y), fused(weight, w, z)
        store3(out, at, (x, y, z))


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
            for begin in range(tile, end, LANES):
                blend_matrices(bones, weights, blocks[block, 0], blocks[block, 1], palette, scratch)
                x, y, z, u, v, w = moved(columns(scratch, 0), positions, rest_normals, XYZ * block)
                lx, ly, lz, hx, hy, hz = (
                    least(x, lx),
                    least(y, ly),
                    least(z, lz),
                    most(x, hx),
                    most(y, hy),
                    most(z, hz),
                )
                store3(scratch, RAW + 3 * (begin - tile), (u, v, w))
                squared, block = square(u, v, w), block + 1
                shortest, longest = lowest_bits(shortest, squared), highest_bits(longest, squared)
                farthest, size = highest_bits(farthest, square(x, y, z)), one / root(squared)
                points, at, normals, normals_at = (
                    out_positions,
                    3 * (first + begin),
                    out_normals,
                    3 * (first + begin),
                )
                if end - begin < LANES:  # the part's last, which must not run into the next part
                    points, at, normals, normals_at = scratch, LAST, scratch, LAST + XYZ
                store_xyz(points, at, x, y, z)
                store_xyz(normals, normals_at, u * size, v * size, w * size)
            cut(out_positions, out_normals, 3 * (first + end), 3 * ((end - tile) % LANES), scratch)
            if not (all_between(shortest, smallest, largest) and all_between(longest, smallest, largest)):
                mended_normals(
                    scratch, rest_normals, first_block, out_normals, 3 * (first + tile), end - tile
                )
            if not all_between(farthest, smallest, largest):
                finite = mended_points(out_positions, 3 * (first + tile), 3 * (end - tile))
        bound(bounds, part, 0, lx, hx, scratch)
        bound(bounds, part, 1, ly, hy, scratch)
        bound(bounds, part, 2, lz, hz, scratch)
        if not finite:
            bounded(bounds, part, out_positions, first, count)
