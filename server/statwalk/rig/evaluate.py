"""Computes world transforms from local transforms, level by level (RTCA 2.1; glTF 3.5.3)."""

from __future__ import annotations

import numpy as np

from statwalk.maths import transform
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose
from statwalk.rig.skeleton import Skeleton


def world_from_local(skeleton: Skeleton, pose: Pose) -> Floats:
    """Returns the world transforms (…, J, 3, 4) of every joint: M_world(child) = M_world(parent) ·
    T·R·S(child).
    """
    return compose(skeleton, transform.from_trs(pose.translation, pose.rotation, pose.scale))


def compose(skeleton: Skeleton, local: Floats) -> Floats:
    """Returns the world transforms (…, J, 3, 4) of local transforms: a root keeps its own, a child's follows
    its parent's.
    """
    columns = np.ascontiguousarray(
        local.T
    )  # (4, 3, J, …): columns first, so that a crowd is long rows and not many short ones
    world = np.empty_like(columns)
    for joints, parents in skeleton.levels:
        below = columns.take(joints, 2)
        world[:, :, joints] = below if parents[0] < 0 else _after(world.take(parents, 2), below)
    return np.ascontiguousarray(world.T)


def _after(above: Floats, below: Floats) -> Floats:
    """The transforms `above` · `below`, both as columns (4, 3, J, …): `transform.mul` in the layout of
    `compose`.
    """
    product: Floats = above[0] * below[:, 0, None]
    product += above[1] * below[:, 1, None]
    product += above[2] * below[:, 2, None]
    product[3] += above[3]
    return product
