"""The rotation closest to a matrix, compiled: the bone's turn without its stretch.

The unit quaternion q with the largest sum over R(q)·M is the first eigenvector of a symmetric 4 x 4 matrix
(Horn 1987). Squaring that matrix, twice for a rotation and more often for a stretch, leaves this
eigenvector. No inverse is needed, so a flat matrix has an answer too.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import inlined

MOST_SQUARINGS = 24
ENOUGH = 1 - 1e-6
"""the trace of the square, for a trace of 1: the next square is exact to float32"""

FLAT = 1e-6
"""a determinant below this, for a matrix of size 1, is rounding"""


@inlined
def closest_rotation(m: Any) -> Any:
    """Returns the unit quaternion (x, y, z, w) closest to a 3 x 3 matrix, nine float64 row by row; for a
    mirror (negative determinant) closest to the negative matrix; for zeros and NaN the identity.
    """
    a, b, c, d, e, f, g, h, i = m
    size = np.sqrt((a * a + b * b + c * c + d * d + e * e + f * f + g * g + h * h + i * i) / 3)
    if a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g) < -FLAT * size * size * size:
        a, b, c, d, e, f, g, h, i = -a, -b, -c, -d, -e, -f, -g, -h, -i
    if not 0 < size < np.inf:
        return 0.0, 0.0, 0.0, 1.0
    xx, yy, zz, ww = size + a - e - i, size - a + e - i, size - a - e + i, size + a + e + i
    xy, xz, yz, xw, yw, zw = b + d, c + g, f + h, h - f, c - g, d - b
    trace, total = 0.0, 4 * size
    for step in range(MOST_SQUARINGS):
        xx, yy, zz, ww = xx / total, yy / total, zz / total, ww / total
        xy, xz, yz, xw, yw, zw = xy / total, xz / total, yz / total, xw / total, yw / total, zw / total
        trace = xx * xx + yy * yy + zz * zz + ww * ww
        trace += 2 * (xy * xy + xz * xz + yz * yz + xw * xw + yw * yw + zw * zw)
        xx, xy, xz, xw, yy, yz, yw, zz, zw, ww = (
            xx * xx + xy * xy + xz * xz + xw * xw,
            xx * xy + xy * yy + xz * yz + xw * yw,
            xx * xz + xy * yz + xz * zz + xw * zw,
            xx * xw + xy * yw + xz * zw + xw * ww,
            xy * xy + yy * yy + yz * yz + yw * yw,
            xy * xz + yy * yz + yz * zz + yw * zw,
            xy * xw + yy * yw + yz * zw + yw * ww,
            xz * xz + yz * yz + zz * zz + zw * zw,
            xz * xw + yz * yw + zz * zw + zw * ww,
            xw * xw + yw * yw + zw * zw + ww * ww,
        )
        total = trace
        if step and trace > ENOUGH:  # the first square has no negative eigenvalue
            break
    x, y, z, w, longest = xw, yw, zw, ww, ww  # every column is the eigenvector: the longest is taken
    if xx > longest:
        x, y, z, w, longest = xx, xy, xz, xw, xx
    if yy > longest:
        x, y, z, w, longest = xy, yy, yz, yw, yy
    if zz > longest:
        x, y, z, w, longest = xz, yz, zz, zw, zz
    length = np.sqrt(x * x + y * y + z * z + w * w)
    return x / length, y / length, z / length, w / length
