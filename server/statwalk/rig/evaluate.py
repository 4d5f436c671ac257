"""Computes the transforms of joints from their local transforms (`hierarchy`)."""

from __future__ import annotations

from math import prod

import numpy as np

from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose
from statwalk.rig import _kernels
from statwalk.rig.skeleton import Skeleton

WIDTHS = 3, 4, 3
"""numbers of a translation, a rotation and a scale"""
FLOAT32, FLOAT64 = np.dtype(np.float32), np.dtype(np.float64)


def world_from_local(skeleton: Skeleton, pose: Pose) -> Floats:
    """Returns the transforms (…, J, 3, 4) of every joint in the character's space: M(child) = M(parent) ·
    T·R·S(child); float32 for a float32 pose, else float64.

    :raises ValueError: when the pose has another number of joints.
    """
    lead, joints = pose.rotation.shape[:-2], len(skeleton)
    if any(array.shape != (*lead, joints, width) for array, width in zip(pose[:3], WIDTHS, strict=True)):
        raise ValueError(f"a pose of {pose.translation.shape} for a skeleton of {joints} joints")
    is_single = all(array.dtype == FLOAT32 for array in pose[:3])
    kind = FLOAT32 if is_single else FLOAT64
    worlds = np.empty((prod(lead), joints, 3, 4), kind)
    translation, rotation, scale = (
        np.ascontiguousarray(array, kind).reshape(len(worlds), joints, width)
        for array, width in zip(pose[:3], WIDTHS, strict=True)
    )
    kernel = _kernels.world if is_single else _kernels.exact_world
    kernel(skeleton.parent, translation, rotation, scale, worlds)
    return worlds.reshape(*lead, joints, 3, 4)


def stage_from_local(skeleton: Skeleton, pose: Pose, roots: Floats) -> Floats:
    """Returns the transforms (N, J, 3, 4) of every joint of N actors under their `roots` (N, 3, 4), float32.

    Each joint is computed within its actor first, then the actor is placed as a whole: far from the origin no
    precision is lost along the joints.

    :raises ValueError: when the pose has another number of actors or joints.
    """
    if len(pose.rotation) != len(roots):
        raise ValueError(f"a pose of {pose.translation.shape} for {len(roots)} actors")
    worlds = world_from_local(skeleton, Pose(*(np.asarray(array, np.float32) for array in pose)))
    _kernels.place(np.ascontiguousarray(roots, np.float32), worlds)
    return worlds
