"""From local transforms to world transforms, level by level (RTCA 2.1; glTF 3.5.3)."""

from __future__ import annotations

import numpy as np

from statwalk.maths import transform
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose
from statwalk.rig.skeleton import Skeleton


def world_from_local(skeleton: Skeleton, pose: Pose) -> Floats:
    """World transforms (…, J, 3, 4) of every joint: M_world(child) = M_world(parent) · T·R·S(child)."""
    return compose(skeleton, transform.from_trs(pose.translation, pose.rotation, pose.scale))


def compose(skeleton: Skeleton, local: Floats) -> Floats:
    """World transforms (…, J, 3, 4) of local ones: a root's are its own, a child's come after its parent's."""
    world = np.empty_like(local)
    for joints, parents in skeleton.levels:
        below = local.take(joints, -3)
        world[..., joints, :, :] = below if parents[0] < 0 else transform.mul(world.take(parents, -3), below)
    return world
