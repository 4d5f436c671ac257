"""A clip that shows a new skin: every joint bends in turn, and back."""

from __future__ import annotations

import numpy as np

from statwalk.maths import quat, vector
from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.pose import Pose
from statwalk.motion.clip import Channel, Clip
from statwalk.rig.skeleton import Skeleton

ANGLE = np.radians(35)
SECONDS = 0.8
"""for each joint"""
WAVE = np.array([0.0, 1, 0, -1, 0])
"""the angle, a share of ANGLE, at equal times"""


def bend_clip(name: str, skeleton: Skeleton, pose: Pose, joints: Ints) -> Clip:
    """Returns a clip in which some joints bend one after the other, across their bones; their roots rest."""
    bending = [joint for joint in joints.tolist() if skeleton.parent[joint] in joints]
    bending = bending or joints.tolist()
    channels = [
        _channel(pose, joint, _axis(skeleton, pose, joint), row * SECONDS)
        for row, joint in enumerate(bending)
    ]
    return Clip(name, tuple(channels), len(bending) * SECONDS, pose, loop=True)


def _axis(skeleton: Skeleton, pose: Pose, joint: int) -> Floats:
    """The unit vector (3,) across a joint's bone, in the joint's space."""
    below = np.flatnonzero(skeleton.parent == joint)
    along = pose.translation[below].mean(0) if len(below) else _inward(pose, joint)
    unit = vector.unit(along.astype(np.float64))
    return vector.perpendicular(unit) if vector.length(unit) > 0 else np.array([1.0, 0, 0])


def _inward(pose: Pose, joint: int) -> Floats:
    """The way from the joint above, in the space of a last joint."""
    way: Floats = quat.rotate(quat.conjugate(pose.rotation[joint]), pose.translation[joint])
    return way


def _channel(pose: Pose, joint: int, axis: Floats, start: float) -> Channel:
    times = start + np.linspace(0, SECONDS, len(WAVE))
    rest = np.broadcast_to(pose.rotation[joint].astype(np.float64), (len(WAVE), 4))
    values = quat.mul(rest, quat.from_axis_angle(axis, ANGLE * WAVE))
    return Channel(joint, "rotation", times.astype(np.float32), values.astype(np.float32))
