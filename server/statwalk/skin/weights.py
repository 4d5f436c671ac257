"""Skin weights: normalised, sorted, and trimmed to the influences that matter."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.kernels.choose import loaded

TOLERANCE, EXACT = 2e-3, 1.2e-7
"""off a sum of 1: what quantised weights are, and what 32-bit floats are"""


def normalised(joints: Ints, weights: Floats) -> tuple[NDArray[np.uint16], NDArray[np.float32], int]:
    """Joints and weights (V,I) with sums of 1 and the largest influence first, unused columns left out; and how many vertices were off.

    What is below 0 counts as 0. A vertex without any weight follows the first of its joints. Sums within quantisation error (8-bit
    weights) are not counted.
    """
    used = used_where_normalised(weights)
    if used:
        return joints[:, :used].astype(np.uint16, copy=False), weights[:, :used].astype(np.float32, copy=False), 0
    found, exact = joints.astype(np.uint16), np.maximum(weights, 0, dtype=np.float64)
    sums = summed(exact)
    off = int(np.count_nonzero(np.abs(sums - 1) > TOLERANCE))
    empty = sums <= 0
    if empty.any():
        exact[empty, 0], sums[empty] = 1, 1
    exact /= sums[:, None]
    sort_rows(found, exact)
    used = used_columns(exact)
    return found[:, :used], exact[:, :used].astype(np.float32), off


def used_where_normalised(weights: Floats) -> int:
    """How many columns have any, where all rows (V,I) sum to 1, as exactly as 32-bit floats can, and fall to no less than 0, as in most
    files; else 0.
    """
    compiled = loaded() if weights.shape[1] == 4 and is_plain(weights) else None
    if compiled is not None:
        return int(compiled.normalised(weights, np.float32(EXACT)))
    columns = np.ascontiguousarray(weights.T)
    sums = columns.sum(0)
    right = np.abs(sums - 1).max(initial=0) < EXACT and (columns[1:] <= columns[:-1]).all() and columns[-1].min(initial=0) >= 0
    return used_columns(weights) if right else 0


def is_plain(values: Floats) -> bool:
    """Whether compiled kernels take the array."""
    return values.dtype == np.float32 and values.flags.aligned and values.flags.c_contiguous


def summed(weights: Floats) -> Floats:
    """(V,) the sums of the rows."""
    sums = weights[:, 0].copy()
    for column in range(1, weights.shape[1]):
        sums += weights[:, column]
    return sums


def rising(weights: Floats) -> NDArray[np.bool_]:
    """(V,) whether a row is not sorted by falling weight. Most files have them so already."""
    found = np.zeros(len(weights), bool)
    for column in range(1, weights.shape[1]):
        found |= weights[:, column] > weights[:, column - 1]
    return found


def sort_rows(joints: NDArray[np.uint16], weights: NDArray[np.float64]) -> None:
    """Sort both (V,I) in place by falling weight."""
    rows = np.flatnonzero(rising(weights))
    if len(rows):
        order = np.argsort(-weights[rows], axis=1, kind="stable")
        weights[rows] = np.take_along_axis(weights[rows], order, axis=1)
        joints[rows] = np.take_along_axis(joints[rows], order, axis=1)


def used_columns(weights: Floats) -> int:
    """How many columns of sorted weights (V,I) have any."""
    return next((column for column in range(weights.shape[1], 1, -1) if weights[:, column - 1].max(initial=0) > 0), 1)
