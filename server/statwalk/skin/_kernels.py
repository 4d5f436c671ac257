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
from statwalk.skin.dual_lanes import carried, stretched
from statwalk.skin.dual_palette import LINEAR, RIGID
from statwalk.skin.repair import (
    FINITE,
    LAST,
    MATRIX,
    NUMBERS,
    RAW,
    TILE,
    XYZ,
    bounded,
    mended_normals,
    mended_points,
)
from statwalk.skin.vertex_lanes import blend_lanes, blend_matrices, bound, cut, moved, square, write_bone

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
        write_bone(world, joints[bone], inverse_bind, bone, out, MATRIX * bone, 1)


@kernel(read(FLOAT, 4), read(INT, 1), read(FLOAT, 3), write(FLOAT, 1))
def palette_lanes(world: Any, joints: Any, inverse_bind: Any, out: Any) -> None:
    """Writes `palette` for world matrices (N,J,3,4) of up to sixteen actors, 12 times 16 floats a bone; the
    last actor fills all further lanes.
    """
    for bone in range(joints.shape[0]):
        for lane in range(LANES):
            actor = min(lane, world.shape[0] - 1)
            at = NUMBERS * LANES * bone + lane
            write_bone(world[actor], joints[bone], inverse_bind, bone, out, at, LANES)


@kernel(
    LONG, read(FLOAT, 1), read(FLOAT, 1), read(LONG, 2), read(LONG, 2), read(INT, 1), read(FLOAT, 1),
    read(FLOAT, 1), read(FLOAT, 1), write(FLOAT, 1), write(FLOAT, 1), write(FLOAT, 2), write(FLOAT, 1),
)  # fmt: skip
def skinned(
    way: int, palette: Any, stretches: Any, spans: Any, blocks: Any, bones: Any, weights: Any,
    positions: Any, rest_normals: Any, out_positions: Any, out_normals: Any, bounds: Any, scratch: Any,
) -> None:  # fmt: skip
    """Poses all parts: writes points and unit normals (V,3), flat, and the bounds (P,6) of each part.

    way LINEAR: the palette has matrices; RIGID and STRETCHED: dual quaternions, as `dual_palette` writes them
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
                m = columns(scratch, 0)
                if way == LINEAR:
                    x, y, z, u, v, w = moved(
                        m, load3(positions, XYZ * block), load3(rest_normals, XYZ * block)
                    )
                elif way == RIGID:
                    x, y, z, u, v, w = carried(m, positions, rest_normals, XYZ * block)
                else:
                    blend_matrices(bones, weights, blocks[block, 0], blocks[block, 1], stretches, scratch)
                    n = columns(scratch, 0)
                    x, y, z, u, v, w = stretched(m, n, positions, rest_normals, XYZ * block)
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


@kernel(
    read(LONG, 1), read(INT, 1), read(FLOAT, 1), read(FLOAT, 1), read(FLOAT, 1), write(FLOAT, 1),
    returns=LONG,
)  # fmt: skip
def skinned_crowd(starts: Any, bones: Any, weights: Any, at_rest: Any, palette: Any, out: Any) -> Any:
    """Poses one mesh for sixteen actors: writes points and unit normals (V,6,16), flat; returns whether all
    lengths are such that their roots are accurate.

    starts (V + 1,) the first influence of each vertex; bones (floats into the palette) and weights, vertex by
    vertex; at_rest (V,6) points and normals, flat; palette (K,12,16) matrices of sixteen actors, flat.
    """
    one, smallest, largest = broadcast(ONE), broadcast(SMALLEST), broadcast(LARGEST)
    shortest, longest, farthest = one, one, one
    for vertex in range(starts.shape[0] - 1):
        at = 6 * vertex
        point = spread(at_rest, at), spread(at_rest, at + 1), spread(at_rest, at + 2)
        normal = spread(at_rest, at + 3), spread(at_rest, at + 4), spread(at_rest, at + 5)
        m = blend_lanes(bones, weights, starts[vertex], starts[vertex + 1], palette)
        x, y, z, u, v, w = moved(m, point, normal)
        squared = square(u, v, w)
        shortest, longest = lowest_bits(shortest, squared), highest_bits(longest, squared)
        farthest, size = highest_bits(farthest, square(x, y, z)), one / root(squared)
        store3(out, at * LANES, (x, y, z))
        store3(out, (at + 3) * LANES, (u * size, v * size, w * size))
    is_accurate = all_between(shortest, smallest, largest) and all_between(longest, smallest, largest)
    return LONG(1) if is_accurate and all_between(farthest, smallest, largest) else LONG(0)
