"""The strongest influences of each vertex, in the form of glTF: four joints and their weights."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Floats

INFLUENCES = 4
SMALLEST = 1e-3
"""a share of a vertex that counts as none"""


def strongest(weights: Floats) -> tuple[NDArray[np.uint16], NDArray[np.float32]]:
    """Returns joints and weights (V,4) of weights (V,J): the four largest, largest first, with sums of 1; an
    unused influence has joint 0 and weight 0.

    A vertex without weights follows joint 0.
    """
    count = min(INFLUENCES, weights.shape[1])
    joints = np.argsort(-weights, 1, kind="stable")[:, :count]
    kept = np.take_along_axis(weights, joints, 1).astype(np.float64)
    kept[kept < SMALLEST * kept[:, :1]] = 0
    kept[kept[:, 0] <= 0, 0] = 1
    kept /= kept.sum(1, keepdims=True)
    padding = ((0, 0), (0, INFLUENCES - count))
    filled = np.pad(kept, padding).astype(np.float32)
    return np.where(filled > 0, np.pad(joints, padding), 0).astype(np.uint16), filled
