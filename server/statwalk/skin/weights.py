"""Skin weights: normalised, sorted, and trimmed to the influences that matter."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Floats, Ints
from statwalk.skin import _kernels

TOLERANCE, EXACT = 2e-3, 1.2e-7
"""largest deviation from a sum of 1: of quantised weights, and of 32-bit floats"""


def normalised(joints: Ints, weights: Floats) -> tuple[NDArray[np.uint16], NDArray[np.float32], int]:
    """Returns joints and weights (V,I) with sums of 1 and the largest influence first, without unused
    columns; and the number of vertices that needed a correction.

    Negative weights count as 0. A vertex without any weight follows the first of its joints. Sums within
    quantisation error (8-bit weights) do not count as corrected.
    """
    used = used_where_normalised(weights)
    if used:
        return (
            joints[:, :used].astype(np.uint16, copy=False),
            weights[:, :used].astype(np.float32, copy=False),
            0,
        )
    sorted_joints, exact = joints.astype(np.uint16), np.maximum(weights, 0, dtype=np.float64)
    sums = _summed(exact)
    off = int(np.count_nonzero(np.abs(sums - 1) > TOLERANCE))
    empty = sums <= 0
    if empty.any():
        exact[empty, 0], sums[empty] = 1, 1
    exact /= sums[:, None]
    _sort_rows(sorted_joints, exact)
    used = _used_columns(exact)
    return sorted_joints[:, :used], exact[:, :used].astype(np.float32), off


def used_where_normalised(weights: Floats) -> int:
    """Returns the number of columns in use, if all rows (V,I) sum to 1 within float32 precision and fall
    without negative weights, as in most files; else 0.
    """
    if weights.shape[1] == 4 and _is_plain(weights):
        return int(_kernels.normalised(weights, np.float32(EXACT)))
    columns = np.ascontiguousarray(weights.T)
    sums = columns.sum(0)
    right = (
        np.abs(sums - 1).max(initial=0) < EXACT
        and (columns[1:] <= columns[:-1]).all()
        and columns[-1].min(initial=0) >= 0
    )
    return _used_columns(weights) if right else 0


def _is_plain(values: Floats) -> bool:
    """Whether compiled kernels accept the array."""
    return values.dtype == np.float32 and values.flags.aligned and values.flags.c_contiguous


def _summed(weights: Floats) -> Floats:
    """(V,) the sums of the rows."""
    sums = weights[:, 0].copy()
    for column in range(1, weights.shape[1]):
        sums += weights[:, column]
    return sums


def _rising(weights: Floats) -> NDArray[np.bool_]:
    """(V,) whether a row is not sorted by falling weight. The rows of most files are sorted."""
    is_rising = np.zeros(len(weights), bool)
    for column in range(1, weights.shape[1]):
        is_rising |= weights[:, column] > weights[:, column - 1]
    return is_rising


def _sort_rows(joints: NDArray[np.uint16], weights: NDArray[np.float64]) -> None:
    """Sorts both (V,I) in place by falling weight."""
    rows = np.flatnonzero(_rising(weights))
    if len(rows):
        order = np.argsort(-weights[rows], axis=1, kind="stable")
        weights[rows] = np.take_along_axis(weights[rows], order, axis=1)
        joints[rows] = np.take_along_axis(joints[rows], order, axis=1)


def _used_columns(weights: Floats) -> int:
    """The number of columns of sorted weights (V,I) with any weight."""
    return next(
        (column for column in range(weights.shape[1], 1, -1) if weights[:, column - 1].max(initial=0) > 0), 1
    )
