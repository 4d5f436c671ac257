"""Vectors of sixteen actors at a time: tuples x y z of lanes (`maths.vector` in lanes; sums are in
`lane_quat`).
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import inlined
from statwalk.maths.simd.lane_functions import fused, most, root, size, where_below
from statwalk.maths.simd.lane_quat import scaled, vector_square
from statwalk.maths.simd.lanes import broadcast

ZERO, ONE = np.float32(0), np.float32(1)
SMALLEST = np.float32(1e-30)
"""squared length below which a vector counts as zero"""


@inlined
def dot(a: Any, b: Any) -> Any:
    """Returns a · b."""
    return fused(a[2], b[2], fused(a[1], b[1], a[0] * b[0]))


@inlined
def cross(a: Any, b: Any) -> Any:
    """Returns a × b."""
    return (
        fused(a[1], b[2], -(a[2] * b[1])),
        fused(a[2], b[0], -(a[0] * b[2])),
        fused(a[0], b[1], -(a[1] * b[0])),
    )


@inlined
def times(a: Any, b: Any) -> Any:
    """Returns the products of the components."""
    return a[0] * b[0], a[1] * b[1], a[2] * b[2]


@inlined
def added(a: Any, b: Any, factor: Any) -> Any:
    """Returns a + b · factor."""
    return fused(b[0], factor, a[0]), fused(b[1], factor, a[1]), fused(b[2], factor, a[2])


@inlined
def length(a: Any) -> Any:
    """Returns |a|."""
    return root(vector_square(a))


@inlined
def per_root(x: Any) -> Any:
    """Returns 1 / √x."""
    return broadcast(ONE) / root(x)


@inlined
def unit(a: Any) -> Any:
    """Returns a / |a|; vectors shorter than 1e-15 shrink towards zero instead."""
    return scaled(a, per_root(most(vector_square(a), broadcast(SMALLEST))))


@inlined
def where3_below(a: Any, b: Any, x: Any, y: Any) -> Any:
    """Returns the vector x in lanes with a < b, else y."""
    return where_below(a, b, x[0], y[0]), where_below(a, b, x[1], y[1]), where_below(a, b, x[2], y[2])


@inlined
def perpendicular(a: Any) -> Any:
    """Returns a vector at right angles to `a`: a × the axis along which `a` is smallest; at least 0.8 |a|
    long.
    """
    x, y, z = size(a[0]), size(a[1]), size(a[2])
    zero = broadcast(ZERO)
    across_z, across_y, across_x = (a[1], -a[0], zero), (-a[2], zero, a[0]), (zero, a[2], -a[1])
    of_y_and_z = where3_below(y, z, across_y, across_z)
    return where3_below(x, where_below(y, z, y, z), across_x, of_y_and_z)
