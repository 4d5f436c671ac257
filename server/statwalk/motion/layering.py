"""Layers: a second motion on some joints of the same character, in place of what is below it or on top of it.

Additive motion is the difference to the first pose of its clip, in the space of each joint: rotations q · (first⁻¹ · now). That is
what three.js does (AnimationUtils.makeClipAdditive, PropertyMixer).
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from statwalk.maths import curves, quat
from statwalk.maths.arrays import Bools, Floats, Ints
from statwalk.maths.pose import Pose


@dataclass(frozen=True, eq=False)
class Mask:
    """What a layer moves of a pose of J joints and W morph weights."""

    joints: Ints
    """(j,) rows of the joints"""
    weights: Ints
    """(w,) columns of the morph weights"""

    def part(self, pose: Pose) -> Pose:
        """That part of poses (N, …)."""
        translation, rotation, scale = (array[:, self.joints] for array in pose[:3])
        return Pose(translation, rotation, scale, pose.weights[:, self.weights])

    def put(self, pose: Pose, part: Pose) -> Pose:
        """Poses (N, …) with that part replaced."""
        whole = pose.copy()
        for array, new in zip(whole[:3], part[:3], strict=True):
            array[:, self.joints] = new
        whole.weights[:, self.weights] = part.weights
        return whole

    def offsets(self, joints: int, weights: int) -> Bools:
        """(D,) which numbers of an offset of `motion.inertialize` belong to it."""
        moved, morphed = np.zeros((joints, 3), bool), np.zeros(weights, bool)
        moved[self.joints], morphed[self.weights] = True, True
        return np.concatenate([moved.reshape(-1)] * 3 + [morphed])


def below(parent: Ints, roots: Iterable[int]) -> Bools:
    """(J,) the joints `roots` and all that hang on them; `parent` (J,) comes before its children."""
    found = np.zeros(len(parent), bool)
    found[list(roots)] = True
    for joint, above in enumerate(parent.tolist()):
        found[joint] |= above >= 0 and found[above]
    return found


def override(under: Pose, over: Pose, weight: Floats, mask: Mask) -> Pose:
    """Poses (N, …) with those of a layer in place of them, as far as its `weight` (N,) 0…1 goes: straight, rotations by slerp."""
    old, new, part = mask.part(under), mask.part(over), weight.astype(np.float32)
    by_joint = part[:, None]
    blended = Pose(
        curves.lerp(old.translation, new.translation, by_joint),
        quat.slerp(old.rotation, new.rotation, by_joint),
        curves.lerp(old.scale, new.scale, by_joint),
        curves.lerp(old.weights, new.weights, part),
    )
    return mask.put(under, blended)


def additive(under: Pose, over: Pose, first: Pose, weight: Floats, mask: Mask) -> Pose:
    """Poses (N, …) with the difference of a layer's to its `first` ones on top, `weight` (N,) 0…1 of it."""
    old, new, start, part = mask.part(under), mask.part(over), mask.part(first), weight.astype(np.float32)
    turned = quat.mul(old.rotation, quat.mul(quat.conjugate(start.rotation), new.rotation))
    summed = Pose(
        old.translation + (new.translation - start.translation) * part[:, None, None],
        quat.normalize(quat.slerp(old.rotation, turned, part[:, None])),
        old.scale + (new.scale - start.scale) * part[:, None, None],
        old.weights + (new.weights - start.weights) * part[:, None],
    )
    return mask.put(under, summed)
