"""The weights of muscles in a tick (DS9): a contraction is 0…1, and the morph targets of its square and its
cube follow it.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import inlined
from statwalk.maths.simd.lane_functions import least, most
from statwalk.maths.simd.lanes import broadcast, load, store
from statwalk.maths.simd.pose_layout import index_at
from statwalk.solve.expression_tables import NO_SLOT

ZERO, ONE = np.float32(0), np.float32(1)


@inlined
def contract_lanes(x: Any, pose: Any, at: int) -> None:
    """Writes contractions, squares and cubes in block `at` of `pose`, for sixteen actors at once; `x` has the
    channels of each muscle.
    """
    for muscle in range(x.contraction.shape[0]):
        first = index_at(pose, at, x.contraction[muscle, 0])
        once = least(most(load(pose, first), broadcast(ZERO)), broadcast(ONE))
        twice = once * once
        store(pose, first, once)
        if x.contraction[muscle, 1] != NO_SLOT:
            store(pose, index_at(pose, at, x.contraction[muscle, 1]), twice)
        if x.contraction[muscle, 2] != NO_SLOT:
            store(pose, index_at(pose, at, x.contraction[muscle, 2]), twice * once)
