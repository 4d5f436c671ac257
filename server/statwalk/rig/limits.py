"""The limits of a character's joints as arrays, and by how much poses leave them (SK6, FAQ Q13)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal, NamedTuple

import numpy as np

from statwalk.errors import UnknownNameError
from statwalk.maths import quat, vector
from statwalk.maths.arrays import Floats
from statwalk.maths.clamp_table import ClampTable, JointLimit, clamp_table
from statwalk.maths.pose import Pose
from statwalk.rig.joints import clamped_transform
from statwalk.rig.skeleton import Skeleton


class ClampedJoint(NamedTuple):
    """A joint that its limits changed: by how many radians and units of length."""

    joint: str
    angle: float
    distance: float
    by: Literal["motion", "solver"] = "motion"
    """what went beyond them: motion and blends, or inverse kinematics (in its last turn of the joint)"""


class Excess(NamedTuple):
    """By how much joints leave their limits."""

    angle: Floats
    """(…, L) radians"""
    distance: Floats
    """(…, L) units of length"""


def table_of(skeleton: Skeleton, rest: Pose, limits: Mapping[str, JointLimit]) -> ClampTable:
    """Returns the limits by joint name as a table for a character; `rest` is its rest pose (J, …).

    :raises UnknownNameError: when the skeleton has no joint of a name.
    """
    for name in limits:
        if name not in skeleton.names:
            raise UnknownNameError("joint", name, skeleton.names)
    return clamp_table({skeleton.index(name): limit for name, limit in limits.items()}, rest)


def excess(limits: Mapping[int, JointLimit], rest: Pose, pose: Pose) -> Excess:
    """Returns by how much poses (…, J, …) leave the limits of L joints, in ascending order of the joints;
    `rest` is the unbatched rest pose.
    """
    lead = pose.rotation.shape[:-2]
    out = Excess(np.zeros((*lead, len(limits))), np.zeros((*lead, len(limits))))
    for row, joint in enumerate(sorted(limits)):
        turned, moved = relative(rest, joint, pose)
        translation, rotation = clamped_transform(limits[joint], moved, turned)
        back = quat.mul(quat.conjugate(rotation), turned)
        out.angle[..., row] = vector.length(quat.to_rotation_vector(back))
        out.distance[..., row] = vector.length(moved - translation)
    return out


def relative(rest: Pose, joint: int, pose: Pose) -> tuple[Floats, Floats]:
    """Returns rotation (…, 4) and translation (…, 3) of a joint in poses (…, J, …) relative to the rest
    pose.
    """
    back = quat.conjugate(rest.rotation[joint].astype(np.float64))
    turned = quat.mul(back, pose.rotation[..., joint, :].astype(np.float64))
    way = pose.translation[..., joint, :].astype(np.float64) - rest.translation[joint]
    return turned, quat.rotate(back, way)
