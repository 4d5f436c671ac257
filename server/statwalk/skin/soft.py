"""Soft skin: every vertex follows several bones, v' = Σ wᵢ · Mᵢ · v with Mᵢ = world · inverse bind (RTCA
2.3.2, Listings 4 and 5).

A rigid skin (RTCA 2.3.1) is the same with one influence of weight 1; a rigid part (RTCA 2.1, FAQ Q20) is a
rigid skin whose inverse bind is the identity.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray


class Palette(NamedTuple):
    """The bones that vertices follow: `joints` (K,) of the skeleton, `inverse_bind` (K,3,4)."""

    joints: NDArray[np.int32]
    inverse_bind: NDArray[np.float32]
