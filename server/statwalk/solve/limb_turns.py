"""Two-bone inverse kinematics of limbs given by three points: the code of a tick, called from Python."""

from __future__ import annotations

import numpy as np

from statwalk.maths import quat
from statwalk.maths.arrays import Floats
from statwalk.maths.clamp_table import clamp_table
from statwalk.maths.pose import Pose, rest
from statwalk.maths.pose_buffer import PoseBuffer
from statwalk.solve.chains import POLE_DIRECTION, Chain
from statwalk.solve.solve_poses import Goal, solve_poses

LIMB = rest(3)
PARENT = np.array([-1, 0, 1], np.int32)


def two_bone(root: Floats, mid: Floats, end: Floats, target: Floats, pole: Floats) -> tuple[Floats, Floats]:
    """Returns the turns (N, 4), float32, that bring `end` to `target`: world(root) becomes turn_root ·
    world(root), world(mid) becomes turn_mid · world(mid).

    Points (N, 3) are in one world space, metres; `pole` (N, 3) is the direction, from the root, in which the
    middle joint bends. The new end is root + turn_root·(mid − root) + turn_mid·(end − mid).
    """
    count = len(root)
    translation = np.stack([np.zeros_like(root), mid - root, end - mid], 1).astype(np.float32)
    parts = (np.repeat(part[None], count, 0) for part in LIMB[1:])
    poses = PoseBuffer.of(LIMB, Pose(translation, *parts))
    chain = Chain(solver="two-bone", joints=(0, 1, 2), pole_kind=POLE_DIRECTION)
    goal = Goal(target - root, np.ones(count), pole, quat.IDENTITY)
    solve_poses(poses, PARENT, clamp_table({}, LIMB), chain, goal)
    rotation = poses.poses().rotation
    return rotation[:, 0], quat.mul(rotation[:, 0], rotation[:, 1])
