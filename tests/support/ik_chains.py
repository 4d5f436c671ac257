"""Chains to solve: random poses of a chain of joints under a turned and scaled parent, and where NumPy puts
their joints.
"""

import numpy as np
import slow_hierarchy
from statwalk.maths import quat
from statwalk.maths.clamp_table import clamp_table
from statwalk.maths.pose import Pose, rest
from statwalk.maths.pose_buffer import PoseBuffer
from statwalk.solve.chains import Chain
from statwalk.solve.solve_poses import Goal, solve_poses

IDENTITY = np.array([0.0, 0, 0, 1])


def parents(joints):
    """A root, and a chain of joints under it."""
    return np.arange(-1, joints, dtype=np.int32)


def random_poses(actors, joints, seed, bone=1.0):
    """Poses of a root of scale 0.5 to 2, and of a chain with bones of about `bone` metres."""
    chance = np.random.default_rng(seed)
    shape = actors, joints + 1
    translation = chance.normal(size=(*shape, 3)) * bone
    scale = np.ones((*shape, 3))
    scale[:, 0] = chance.uniform(0.5, 2, (actors, 1))
    rotation = quat.normalize(chance.normal(size=(*shape, 4)))
    return Pose(*(part.astype(np.float32) for part in (translation, rotation, scale, np.zeros((actors, 0)))))


def straight_pose(joints, bone=1.0):
    """One actor: a chain along +Y from the origin, each bone `bone` metres."""
    pose = rest(joints + 1)
    pose.translation[2:, 1] = bone
    return Pose(*(part[None] for part in pose))


def points(poses):
    """(N, J, 3) the places of the joints in model space."""
    return slow_hierarchy.worlds(parents(poses.rotation.shape[1] - 1), poses)[..., :3, 3]


def turns(poses):
    """(N, J, 3, 3) the joints' axes in model space, with scale."""
    return slow_hierarchy.worlds(parents(poses.rotation.shape[1] - 1), poses)[..., :3, :3]


def solved(
    poses, target, solver="two-bone", weight=1.0, pole=(0.0, 0, 0), rotation=IDENTITY, limits=None, **options
):
    """The poses afterwards, and how it went; the chain is all joints below the root."""
    count = poses.rotation.shape[1]
    buffer = PoseBuffer.of(rest(count), poses)
    chain = Chain(solver, tuple(range(1, count)), **options)
    goal = Goal(*(np.asarray(part, float) for part in (target, weight, pole, rotation)))
    clamps = clamp_table(limits or {}, rest(count))
    outcome = solve_poses(buffer, parents(count - 1), clamps, chain, goal)
    return buffer.poses(), outcome
