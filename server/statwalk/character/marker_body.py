"""The bones of a body that markers show, turned by rule 8, as a skeleton with a clip.

Rest is the T-pose: spine up, legs down, arms along ±X, feet along +Z; lengths are the medians of the capture.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from statwalk.character.body_bones import SIDES
from statwalk.maths import pose as poses
from statwalk.maths import quat, vector
from statwalk.maths.arrays import Floats
from statwalk.maths.filters import continuous
from statwalk.maths.pose import Pose
from statwalk.motion.clip import Channel, Clip
from statwalk.rig.skeleton import Skeleton
from statwalk.solve.rules import find_matrix

X, Y = np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0])


class Segment(NamedTuple):
    """A bone between two points of the body, along `direction` at rest."""

    bone: str
    parent: str
    start: str
    end: str
    direction: tuple[float, float, float]


def _limbs(side: str, left: float) -> tuple[Segment, ...]:
    return (
        Segment(side + "UpperLeg", "Hips", side + "UpperLeg", side + "LowerLeg", (0, -1, 0)),
        Segment(side + "LowerLeg", side + "UpperLeg", side + "LowerLeg", side + "Foot", (0, -1, 0)),
        Segment(side + "Foot", side + "LowerLeg", side + "Foot", side + "Toes", (0, 0, 1)),
        Segment(side + "UpperArm", "Spine", side + "UpperArm", side + "LowerArm", (left, 0, 0)),
        Segment(side + "LowerArm", side + "UpperArm", side + "LowerArm", side + "Hand", (left, 0, 0)),
        Segment(side + "Hand", side + "LowerArm", side + "Hand", side + "HandEnd", (left, 0, 0)),
    )


SEGMENTS = (
    Segment("Head", "Spine", "Neck", "Head", (0, 1, 0)),
    *_limbs("Left", 1),
    *_limbs("Right", -1),
)
_ENDS = {side + bone: side + end for side in SIDES for bone, end in (("Foot", "Toes"), ("LowerArm", "Hand"))}
"""the joint at the end of a bone that carries no other"""


def trunk(points: Mapping[str, Floats]) -> dict[str, Floats]:
    """Returns the matrices (F, 3, 3) of hips and spine: up from the pelvis to the neck, left as the legs and
    as the shoulders are.
    """
    pelvis = points["Pelvis"]
    up = points["Neck"] - pelvis if "Neck" in points else np.broadcast_to(Y, pelvis.shape)

    def across(bone: str, fallback: Floats) -> Floats:
        pair = [points[side + bone] for side in ("Left", "Right") if side + bone in points]
        return pair[0] - pair[1] if len(pair) == 2 else fallback

    legs = across("UpperLeg", np.broadcast_to(X, pelvis.shape))
    spine = _frame(across("UpperArm", legs), up, keep_up=True)
    return {"Hips": _frame(legs, up, keep_up=False), "Spine": spine}


def _frame(left: Floats, up: Floats, keep_up: bool) -> Floats:
    forward = vector.unit(vector.cross(left, up))
    x, y = (vector.cross(vector.unit(up), forward), vector.unit(up)) if keep_up else (vector.unit(left), None)
    y = vector.cross(forward, x) if y is None else y
    return np.stack([x, y, forward], -1)


def turned(
    points: Mapping[str, Floats], segments: Sequence[Segment], matrices: dict[str, Floats]
) -> dict[str, Floats]:
    """Returns the matrices (F, 3, 3) of all bones, by rule 8 from each parent's."""
    found = dict(matrices)
    for segment in segments:
        parent = found[segment.parent if segment.parent in found else "Hips"]
        direction = np.broadcast_to(np.array(segment.direction, np.float64), points[segment.start].shape)
        found[segment.bone] = find_matrix(parent, direction, points[segment.end] - points[segment.start])
    return found


def skeleton_of(points: Mapping[str, Floats], segments: Sequence[Segment]) -> tuple[Skeleton, Pose]:
    """Returns the bones as joints, with places at rest; a bone that carries no other has an end joint."""
    names, parents, offsets = ["Hips", "Spine"], [-1, 0], [np.zeros(3), np.zeros(3)]
    hips_height = _length(points, "Pelvis", "Neck") if "Neck" in points else 0.5
    place: dict[str, int] = {"Hips": 0, "Spine": 1}
    at = {"Pelvis": np.zeros(3), "Neck": Y * hips_height}
    for segment in segments:
        if segment.start not in at:
            side = 1.0 if segment.start.startswith("Left") else -1.0
            base = at["Neck"] if segment.parent == "Spine" else at["Pelvis"]
            other = (
                segment.start.replace("Left", "Right") if side > 0 else segment.start.replace("Right", "Left")
            )
            apart = _length(points, segment.start, other) / 2 if other in points else 0.0
            at[segment.start] = base + X * side * apart
        start = at[segment.start]
        at[segment.end] = start + np.array(segment.direction) * _length(points, segment.start, segment.end)
        parent = place.get(segment.parent, 0)
        above = segments[[one.bone for one in segments].index(segment.parent)] if parent > 1 else None
        base = at[above.start] if above else np.zeros(3)
        place[segment.bone] = len(names)
        names.append(segment.bone)
        parents.append(parent)
        offsets.append(start - base)
    carrying = {segment.parent for segment in segments}
    for segment in segments:
        if segment.bone not in carrying:
            names.append(_ENDS.get(segment.bone, f"{segment.bone}.end"))
            parents.append(place[segment.bone])
            offsets.append(at[segment.end] - at[segment.start])
    rest = poses.rest(len(names))
    rest.translation[:] = np.array(offsets)
    return Skeleton(tuple(names), np.array(parents, np.int32)), rest


def _length(points: Mapping[str, Floats], start: str, end: str) -> float:
    return float(np.median(vector.length(points[end] - points[start])))


def clip_of(
    name: str, skeleton: Skeleton, times: Floats, matrices: Mapping[str, Floats], pelvis: Floats, rest: Pose
) -> Clip:
    """Returns the turns of the bones relative to their parents, and the way of the hips, as keys."""
    keys = times.astype(np.float32)
    channels = [Channel(0, "translation", keys, pelvis.astype(np.float32))]
    world = {bone: quat.from_matrix(matrix) for bone, matrix in matrices.items()}
    for joint, (bone, parent) in enumerate(zip(skeleton.names, skeleton.parent.tolist(), strict=True)):
        if bone in world:
            above = world[skeleton.names[parent]] if parent >= 0 else quat.IDENTITY
            local = continuous(quat.mul(quat.conjugate(above), world[bone]))
            channels.append(Channel(joint, "rotation", keys, local.astype(np.float32)))
    return Clip(name, tuple(channels), float(keys[-1]), rest)
