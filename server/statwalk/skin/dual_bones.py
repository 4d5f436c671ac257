"""The bones of a dual-quaternion skin as the vertices see them: once for each heaviest bone beside them.

A rotation has two quaternions, q and -q. Blended with another bone's, one of them goes the short way: the one
on the side of the vertex's heaviest bone. So the choice belongs to a pair of bones, and is made once a pose
for all vertices of the pair.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.simd import aligned
from statwalk.skin.dual_palette import BONE, SIGNS, dual_palette
from statwalk.skin.repair import MATRIX


class DualBones:
    """The pairs of bones that vertices use, and the memory of their dual quaternions."""

    def __init__(self, bones: NDArray[np.intp], weights: NDArray[np.float32], count: int) -> None:
        """Finds the pairs of bones and weights (V,I), of `count` bones."""
        heaviest = np.take_along_axis(bones, weights.argmax(1)[:, None], 1)
        pairs = heaviest * count + np.where(weights != 0, bones, heaviest)
        used, numbers = np.unique(pairs, return_inverse=True)
        self.pairs = np.stack(np.divmod(used, max(1, count)), axis=1).astype(np.int32)
        self.numbers: NDArray[np.intp] = numbers.reshape(bones.shape).astype(np.intp)
        """(V,I) the pair of each influence"""
        self.signs, self.rows = aligned.copy(SIGNS), aligned.zeros(BONE * count)
        self.turns = aligned.zeros(MATRIX * len(used))
        self.stretches = aligned.zeros(MATRIX * len(used))

    def pose(self, matrices: NDArray[np.float32]) -> int:
        """Writes `turns` and `stretches` for the matrices of the bones, 16 floats each; returns which of both
        the kernel of vertices needs.
        """
        return dual_palette(matrices, self.pairs, self.signs, self.rows, self.turns, self.stretches)
