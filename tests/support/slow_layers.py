"""Layers with NumPy, a pose after the other: what the kernels of `motion.layer_lanes` are held against."""

import numpy as np
from statwalk.maths import quat
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose
from statwalk.motion.layers import Mask


def lerp(a, b, f):
    """a·(1−f) + b·f on every component (…, n); f (…)."""
    part = np.asarray(f, a.dtype)[..., None]
    return a * (1 - part) + b * part


def part_of(mask, pose):
    """The part of poses (N, …) that a mask moves."""
    translation, rotation, scale = (array[:, mask.joints] for array in pose[:3])
    return Pose(translation, rotation, scale, pose.weights[:, mask.weights])


def put(mask, pose, part):
    """Poses (N, …) with that part replaced."""
    whole = pose.copy()
    for array, new in zip(whole[:3], part[:3], strict=True):
        array[:, mask.joints] = new
    whole.weights[:, mask.weights] = part.weights
    return whole


def offsets(mask, joints, weights):
    """(D,) which numbers of an offset of `motion.inertialize` a mask moves."""
    moved, morphed = np.zeros((joints, 3), bool), np.zeros(weights, bool)
    moved[mask.joints], morphed[mask.weights] = True, True
    return np.concatenate([moved.reshape(-1)] * 3 + [morphed])


def override(under: Pose, over: Pose, weight: Floats, mask: Mask) -> Pose:
    """Returns poses (N, …) blended towards the layer's poses by `weight` (N,) 0…1: translation and scale
    linearly, rotation by slerp.
    """
    old, new, part = part_of(mask, under), part_of(mask, over), weight.astype(np.float32)
    by_joint = part[:, None]
    blended = Pose(
        lerp(old.translation, new.translation, by_joint),
        quat.slerp(old.rotation, new.rotation, by_joint),
        lerp(old.scale, new.scale, by_joint),
        lerp(old.weights, new.weights, part),
    )
    return put(mask, under, blended)


def additive(under: Pose, over: Pose, first: Pose, weight: Floats, mask: Mask) -> Pose:
    """Poses (N, …) with the difference of a layer's to its `first` ones on top, `weight` (N,) 0…1 of it."""
    old, new, start, part = (
        part_of(mask, under),
        part_of(mask, over),
        part_of(mask, first),
        weight.astype(np.float32),
    )
    turned = quat.mul(old.rotation, quat.mul(quat.conjugate(start.rotation), new.rotation))
    summed = Pose(
        old.translation + (new.translation - start.translation) * part[:, None, None],
        quat.normalize(quat.slerp(old.rotation, turned, part[:, None])),
        old.scale + (new.scale - start.scale) * part[:, None, None],
        old.weights + (new.weights - start.weights) * part[:, None],
    )
    return put(mask, under, summed)
