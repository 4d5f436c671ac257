"""Sixteen vertices of dual-quaternion skin at a time, compiled: parts of `_kernels.skinned`; the bones are
those of `dual_palette`.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import inlined
from statwalk.maths.simd.lane_functions import fused, turned
from statwalk.maths.simd.lanes import broadcast
from statwalk.maths.simd.pose_lanes import load3
from statwalk.skin.vertex_lanes import cross, dot

TWO = np.float32(2)


@inlined
def _spun(axis: Any, w: Any, double: Any, vector: Any) -> Any:
    """Returns sixteen vectors turned by quaternions; `double` is 2 over the squares of their lengths."""
    bent = cross(axis, vector)
    again = cross(axis, bent)
    return (
        fused(double, fused(w, bent[0], again[0]), vector[0]),
        fused(double, fused(w, bent[1], again[1]), vector[1]),
        fused(double, fused(w, bent[2], again[2]), vector[2]),
    )


@inlined
def _shift(axis: Any, w: Any, double: Any, dual: Any) -> Any:
    """Returns the translations of sixteen dual quaternions."""
    bent = cross(axis, dual)
    return (
        double * (fused(w, dual[0], bent[0]) - dual[3] * axis[0]),
        double * (fused(w, dual[1], bent[1]) - dual[3] * axis[1]),
        double * (fused(w, dual[2], bent[2]) - dual[3] * axis[2]),
    )


@inlined
def carried(m: Any, positions: Any, rest_normals: Any, at: int) -> Any:
    """Returns sixteen points under blended rigid motions `m`, and their normals."""
    axis, w, dual = (m[0], m[1], m[2]), m[3], (m[4], m[5], m[6], m[7])
    double = broadcast(TWO) / fused(w, w, dot(axis, axis))
    x, y, z = _spun(axis, w, double, load3(positions, at))
    u, v, t = _spun(axis, w, double, load3(rest_normals, at))
    a, b, c = _shift(axis, w, double, dual)
    return x + a, y + b, z + c, u, v, t


@inlined
def stretched(m: Any, n: Any, positions: Any, rest_normals: Any, at: int) -> Any:
    """Returns sixteen points under blended motions that stretch, and their normals: the normals first under
    the inverse transpose of the blended stretch, times the size of its determinant.

    m: rotations, dual parts and stretches; n: what a vertex at rest adds to the dual parts
    """
    point, normal = load3(positions, at), load3(rest_normals, at)
    axis, w = (m[0], m[1], m[2]), m[3]
    double = broadcast(TWO) / fused(w, w, dot(axis, axis))
    dual = (
        m[4] + dot((n[0], n[1], n[2]), point),
        m[5] + dot((n[3], n[4], n[5]), point),
        m[6] + dot((n[6], n[7], n[8]), point),
        m[7] + dot((n[9], n[10], n[11]), point),
    )
    first, second, third = (m[8], m[9], m[10]), (m[9], m[11], m[12]), (m[10], m[12], m[13])
    a, b, c = cross(second, third), cross(third, first), cross(first, second)
    sign = dot(first, a)
    bent = turned(dot(a, normal), sign), turned(dot(b, normal), sign), turned(dot(c, normal), sign)
    x, y, z = _shift(axis, w, double, dual)
    u, v, t = _spun(axis, w, double, bent)
    return x, y, z, u, v, t
