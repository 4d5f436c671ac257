"""Solves tridiagonal systems by elimination (Thomas), the same bits on every processor."""

from __future__ import annotations

import numpy as np

from statwalk.maths.arrays import Floats


def solve(rows: Floats, right: Floats) -> Floats:
    """Returns x (K, n) with rows[k, 0] x[k-1] + rows[k, 1] x[k] + rows[k, 2] x[k+1] = right[k].

    rows (K, 3) are diagonally dominant, or totally positive as those of B-splines, so that no rows change
    places; rows[0, 0] and rows[-1, 2] have no effect.
    """
    upper, out = np.zeros(len(rows)), np.array(right, np.float64)
    for k, (before, here, after) in enumerate(rows.tolist()):
        pivot = here - (before * upper[k - 1] if k else 0.0)
        upper[k] = after / pivot
        out[k] = (out[k] - before * out[k - 1]) / pivot if k else out[k] / pivot
    for k in range(len(rows) - 2, -1, -1):
        out[k] -= upper[k] * out[k + 1]
    return out
