"""What the limits of joints changed in the poses that a stage shows: SK6's report.

After blending: the poses before the limits follow from the state of a cast, the motions and what is left of
the offsets of transitions. After inverse kinematics: the solvers note in their memory what limits cut.
"""

from __future__ import annotations

import numpy as np

from statwalk.character.solvers import CUT
from statwalk.maths.arrays import Ints
from statwalk.maths.clamp_kinds import TOLERANCE
from statwalk.maths.pose import Pose
from statwalk.rig.limits import ClampedJoint, excess
from statwalk.solve.chains import cut_angle
from statwalk.stage.state.cast import Cast
from statwalk.stage.steps.sample import Clock, blended_poses


def clamped_joints(cast: Cast, rows: Ints, clock: Clock) -> list[tuple[ClampedJoint, ...]]:
    """Returns, for the actors of some rows, the joints that the limits changed in the tick `clock`, and by
    how much: first those after blending and expressions, then those in solvers.
    """
    if not cast.role.limits:
        return [()] * len(rows)
    after = zip(_after_blending(cast, rows, clock), _in_solvers(cast, rows), strict=True)
    return [moved + solved for moved, solved in after]


def _in_solvers(cast: Cast, rows: Ints) -> list[tuple[ClampedJoint, ...]]:
    solvers, names = cast.role.solvers, cast.role.character.skeleton.names
    if not solvers.limited:
        return [()] * len(rows)
    first = solvers.memory.first(CUT)
    angles = cut_angle(cast.solver_memory[rows, first : first + len(solvers.limited)])
    return [
        tuple(
            ClampedJoint(names[joint], angle, 0.0, "solver")
            for joint, angle in zip(solvers.limited, row, strict=True)
            if angle > 2 * TOLERANCE
        )
        for row in angles.tolist()
    ]


def _after_blending(cast: Cast, rows: Ints, clock: Clock) -> list[tuple[ClampedJoint, ...]]:
    limits = cast.role.limits
    poses = blended_poses(cast, clock).poses(rows)
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
