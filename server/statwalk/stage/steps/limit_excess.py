"""What the limits of joints changed in the poses that a stage shows: SK6's report.

A tick keeps no record of it. The poses before the limits follow from the state of a cast: the motions, and
what is left of the offsets of transitions.
"""

from __future__ import annotations

import numpy as np

from statwalk.maths.arrays import Ints
from statwalk.maths.clamp_kinds import TOLERANCE
from statwalk.maths.pose import Pose
from statwalk.rig.limits import ClampedJoint, excess
from statwalk.stage.state.cast import Cast
from statwalk.stage.steps.sample import blended_poses


def clamped_joints(cast: Cast, rows: Ints) -> list[tuple[ClampedJoint, ...]]:
    """Returns, for the actors of some rows, the joints that the limits changed in this tick, after sampling
    and blending, and by how much.
    """
    limits = cast.role.limits
    if not limits:
        return [()] * len(rows)
    poses = blended_poses(cast).poses(rows)
    names, rest = cast.role.character.skeleton.names, cast.role.character.bind_pose
    joints = sorted(limits)
    by_actor = excess(limits, rest, Pose(*poses))
    found = (by_actor.angle > 2 * TOLERANCE) | (by_actor.distance > 2 * TOLERANCE)
    return [
        tuple(
            ClampedJoint(names[joints[at]], float(by_actor.angle[row, at]), float(by_actor.distance[row, at]))
            for at in np.flatnonzero(found[row])
        )
        for row in range(len(rows))
    ]
