"""Soft skin: every vertex follows several bones, v' = Σ wᵢ · Mᵢ · v with Mᵢ = world · inverse bind (RTCA 2.3.2, Listings 4 and 5).

A rigid skin (RTCA 2.3.1) is the same with one influence of weight 1.
"""

from __future__ import annotations

import numpy as np

from statwalk.maths import transform
from statwalk.maths.arrays import Floats, Ints
from statwalk.skin.primitive import Skin
from statwalk.skin.rows import rows_of


def skin_rows(skin: Skin, world: Floats) -> Floats:
    """Rows (…,12,K) of the skin's matrices, world · inverse bind, for world matrices (…,J,3,4)."""
    return rows_of(transform.mul(world[..., skin.joints, :, :], skin.inverse_bind))


def blended_rows(rows: Floats, joints: Ints, weights: Floats) -> Floats:
    """Rows (…,12,V): for every vertex the weighted sum of its joints' rows (…,12,K); joints and weights (V,I)."""
    blended = np.take(rows, joints[:, 0], axis=-1)
    if joints.shape[1] == 1:
        return blended
    blended *= weights[:, 0]
    for influence in range(1, joints.shape[1]):
        blended += np.take(rows, joints[:, influence], axis=-1) * weights[:, influence]
    return blended
