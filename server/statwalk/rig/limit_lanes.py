"""The step "limit" of a tick: clamps the joints of sixteen actors to their limits (SK6)."""

from __future__ import annotations

from typing import Any

from statwalk.maths.reference import called
from statwalk.maths.simd.joint_lanes import clamp_joint
from statwalk.maths.simd.pose_lanes import ROTATION, joint_at, load3, load4, store3, store4


@called
def limit_block(limits: Any, values: Any, block: int) -> None:
    """Clamps the joints of a block of poses; `limits` is a ClampTable. Joints inside their limits keep their
    bits.
    """
    for row in range(limits.joint.shape[0]):
        at = joint_at(values, block, limits.joint[row])
        translation, rotation = clamp_joint(limits, row, load3(values, at), load4(values, at + ROTATION))
        store3(values, at, translation)
        store4(values, at + ROTATION, rotation)
