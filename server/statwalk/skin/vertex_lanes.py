"""Sixteen vertices at a time, compiled: the parts of `_kernels.skinned`.

`rows` and `soft` define the formulas. Here sums of products are fused, rounded once instead of twice, so the
last bit may differ.
"""

from __future__ import annotations

from typing import Any

from statwalk.maths.compiling import inlined
from statwalk.maths.simd.lane_functions import fused, turned
from statwalk.maths.simd.lanes import LANES, load, load_at, spread, store
from statwalk.skin.repair import LAST, MATRIX, XYZ


@inlined
def write_bone(world: Any, joint: int, inverse_bind: Any, bone: int, out: Any, at: int, step: int) -> None:
    """Writes the 12 numbers of the matrix world (J,3,4) · inverse bind (K,3,4) of a bone, `step` apart."""
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
            out[at + (4 * row + column) * step] = product
        out[at + (4 * row + 3) * step] += d


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
def blend_lanes(bones: Any, weights: Any, first: int, end: int, palette: Any) -> Any:
    """Returns the blended matrix of one vertex for sixteen actors, row by row; its influences go from
    `first` to before `end`, and the palette has sixteen lanes.
    """
    m = _scaled(palette, bones[first], spread(weights, first))
    for influence in range(first + 1, end):
        m = _blended(palette, bones[influence], spread(weights, influence), m)
    return m


@inlined
def _scaled(palette: Any, at: int, weight: Any) -> Any:
    return (
        weight * load(palette, at),
        weight * load(palette, at + LANES),
        weight * load(palette, at + 2 * LANES),
        weight * load(palette, at + 3 * LANES),
        weight * load(palette, at + 4 * LANES),
        weight * load(palette, at + 5 * LANES),
        weight * load(palette, at + 6 * LANES),
        weight * load(palette, at + 7 * LANES),
        weight * load(palette, at + 8 * LANES),
        weight * load(palette, at + 9 * LANES),
        weight * load(palette, at + 10 * LANES),
        weight * load(palette, at + 11 * LANES),
    )


@inlined
def _blended(palette: Any, at: int, weight: Any, m: Any) -> Any:
    return (
        fused(weight, load(palette, at), m[0]),
        fused(weight, load(palette, at + LANES), m[1]),
        fused(weight, load(palette, at + 2 * LANES), m[2]),
        fused(weight, load(palette, at + 3 * LANES), m[3]),
        fused(weight, load(palette, at + 4 * LANES), m[4]),
        fused(weight, load(palette, at + 5 * LANES), m[5]),
        fused(weight, load(palette, at + 6 * LANES), m[6]),
        fused(weight, load(palette, at + 7 * LANES), m[7]),
        fused(weight, load(palette, at + 8 * LANES), m[8]),
        fused(weight, load(palette, at + 9 * LANES), m[9]),
        fused(weight, load(palette, at + 10 * LANES), m[10]),
        fused(weight, load(palette, at + 11 * LANES), m[11]),
    )


@inlined
def cross(a: Any, b: Any) -> Any:
    """Returns the cross products of sixteen pairs of vectors."""
    x, y, z = a[2] * b[1], a[0] * b[2], a[1] * b[0]
    return fused(a[1], b[2], -x), fused(a[2], b[0], -y), fused(a[0], b[1], -z)


@inlined
def dot(a: Any, b: Any) -> Any:
    """Returns the dot products of sixteen pairs of vectors."""
    return fused(a[2], b[2], fused(a[1], b[1], a[0] * b[0]))


@inlined
def moved(m: Any, point: Any, normal: Any) -> Any:
    """Returns sixteen points under the matrices `m`, and their normals under the inverse transposes, times
    the size of the determinants.
    """
    first, second, third = (m[0], m[1], m[2]), (m[4], m[5], m[6]), (m[8], m[9], m[10])
    a, b, c = cross(second, third), cross(third, first), cross(first, second)
    sign = dot(first, a)  # a mirror's is negative
    return (
        dot(first, point) + m[3],
        dot(second, point) + m[7],
        dot(third, point) + m[11],
        turned(dot(a, normal), sign),
        turned(dot(b, normal), sign),
        turned(dot(c, normal), sign),
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
