"""Skin weights: normalised, sorted, and trimmed to the influences that matter."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Floats, Ints

TOLERANCE = 2e-3


def normalised(joints: Ints, weights: Floats) -> tuple[NDArray[np.uint16], NDArray[np.float32], int]:
    """Joints and weights (V,I) with sums of 1 and the largest influence first, unused columns left out; and how many vertices were off.

    A vertex without any weight follows the first of its joints. Sums within quantisation error (8-bit weights) are not counted.
    """
    exact = weights.astype(np.float64)
    sums = exact.sum(axis=1)
    off = int(np.count_nonzero(np.abs(sums - 1) > TOLERANCE))
    empty = sums <= 0
    exact[empty, 0], sums[empty] = 1, 1
    order = np.argsort(-exact, axis=1, kind="stable")
    exact = np.take_along_axis(exact / sums[:, None], order, axis=1)
    used = max(1, int(np.count_nonzero(exact.any(axis=0))))
    sorted_joints = np.take_along_axis(joints, order, axis=1)
    return sorted_joints[:, :used].astype(np.uint16), exact[:, :used].astype(np.float32), off
