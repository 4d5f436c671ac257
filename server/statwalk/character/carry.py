"""Carries the turns of one body over to another: each bone turns from its rest as the other's does from its
own, after the rest poses are brought into line.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from statwalk.character.body import Body, world_rotations
from statwalk.character.body_bones import SIDES, SPINE
from statwalk.maths import quat, vector
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose
from statwalk.rig.evaluate import world_from_local

FACING_SECONDS = 1.0
"""the character faces +Z on average over so much of the clip: about two steps"""
LEVEL_FOOT = 0.65
"""cosine: a foot that points further down than this at rest does not stand flat"""
_LIMBS = tuple(
    (side + bone, side + child)
    for side in SIDES
    for bone, child in (
        ("UpperArm", "LowerArm"),
        ("LowerArm", "Hand"),
        ("UpperLeg", "LowerLeg"),
        ("LowerLeg", "Foot"),
        *(
            (f"{finger}{row}", f"{finger}{row + 1}")
            for finger in ("Index", "Middle", "Ring", "Little")
            for row in (1, 2)
        ),
    )
)
_FOLLOWS = {side + "Hand": side + "LowerArm" for side in SIDES} | {
    side + "Toes": side + "Foot" for side in SIDES
}


class CapturedMotion(NamedTuple):
    """A captured motion in the space of the body that it was captured from.

    times     (F,) seconds from 0
    turned    by bone, (F, 4): the turn from its rest
    places    by bone, (F, 3)
    """

    times: Floats
    turned: dict[str, Floats]
    places: dict[str, Floats]


def motion_of(body: Body, poses: Pose, times: Floats) -> CapturedMotion:
    """Returns how the bones of a body turn and move in poses with a leading axis of frames (F)."""
    exact = Pose(*(array.astype(np.float64) for array in poses))
    turns = world_rotations(body.character.skeleton, exact.rotation)
    places = world_from_local(body.character.skeleton, exact)[..., 3]
    turned = {
        bone: quat.mul(turns[:, joint], quat.conjugate(body.rotation[joint]))
        for bone, joint in body.bones.items()
    }
    return CapturedMotion(times, turned, {bone: places[:, joint] for bone, joint in body.bones.items()})


def to_world(source: Body, target: Body, motion: CapturedMotion) -> Floats:
    """Returns the rotation (4,) from the space of the captured motion to the target's: up is up, and over the
    first second the character faces as the target does at rest.
    """
    hips = motion.turned["Hips"]
    up = vector.unit(quat.rotate(hips, source.up).mean(0))
    lies_in_z = abs(source.up[2]) > 0.9 and abs(up[2]) > abs(up[1])
    axis = np.array([0.0, 0.0, np.sign(up[2])]) if lies_in_z else np.array([0.0, 1.0, 0.0])
    upright = quat.between(axis, np.array([0.0, 1.0, 0.0]))
    first = motion.times <= FACING_SECONDS
    forward = quat.rotate(
        quat.mul(upright, quat.mul(hips[first], source.axes)), np.array([0.0, 0.0, 1.0])
    ).mean(0)
    wanted = quat.rotate(target.axes, np.array([0.0, 0.0, 1.0]))
    yaw = np.arctan2(wanted[0], wanted[2]) - np.arctan2(forward[0], forward[2])
    return quat.mul(quat.from_axis_angle(np.array([0.0, 1.0, 0.0]), yaw), upright)


def rotations(source: Body, target: Body, motion: CapturedMotion, world: Floats) -> dict[str, Floats]:
    """Returns for each bone that both bodies have its rotation (F, 4) in the target's space."""
    onto = quat.mul(source.axes, quat.conjugate(target.axes))
    lined_up = _lined_up(source, target, onto)
    carried: dict[str, Floats] = {}
    for bone, turned in _turned(source, target, motion).items():
        rest = quat.mul(
            lined_up.get(bone, quat.IDENTITY), quat.mul(onto, target.rotation[target.bones[bone]])
        )
        carried[bone] = quat.mul(quat.mul(world, turned), rest)
    return carried


def _turned(source: Body, target: Body, motion: CapturedMotion) -> dict[str, Floats]:
    """Returns the turns of the target's bones; a spine with more or fewer joints bends as much as a whole."""
    turned = {
        bone: turn for bone, turn in motion.turned.items() if bone in target.bones and bone not in SPINE
    }
    ours = [bone for bone in ("Hips", *SPINE) if bone in source.bones]
    theirs = [bone for bone in ("Hips", *SPINE) if bone in target.bones]
    if len(ours) > 1 and "Hips" in ours:
        for row, bone in enumerate(theirs[1:], 1):
            part = row / (len(theirs) - 1) * (len(ours) - 1)
            low = min(int(part), len(ours) - 2)
            turned[bone] = quat.slerp(motion.turned[ours[low]], motion.turned[ours[low + 1]], part - low)
    return turned


def _lined_up(source: Body, target: Body, onto: Floats) -> dict[str, Floats]:
    """Returns the turns (4,) in the source's space that bring the target's limbs along the source's."""
    turns: dict[str, Floats] = {}
    for bone, child in _LIMBS:
        ours, theirs = target.direction(bone, child), source.direction(bone, child)
        if ours is not None and theirs is not None:
            turns[bone] = quat.between(quat.rotate(onto, ours), theirs)
    for side in SIDES:
        foot = _foot(source, target, onto, side)
        if foot is not None:
            turns[side + "Foot"] = foot
    return turns | {
        bone: turns[parent] for bone, parent in _FOLLOWS.items() if parent in turns and bone not in turns
    }


def _foot(source: Body, target: Body, onto: Floats, side: str) -> Floats | None:
    """Returns the turn of a foot: about the vertical only, if both feet stand flat at rest."""
    theirs = source.direction(side + "Foot", side + "Toes")
    ours = target.direction(side + "Foot", side + "Toes")
    if theirs is None:
        return None
    up, forward = source.up, quat.rotate(source.axes, np.array([0.0, 0.0, 1.0]))
    flat = theirs - up * vector.dot(theirs, up)
    if vector.length(flat) < LEVEL_FOOT:
        return quat.between(forward, theirs)
    mine = forward if ours is None else quat.rotate(onto, ours)
    level = mine - up * vector.dot(mine, up)
    if vector.length(level) < 0.2:
        return None
    return quat.between(vector.unit(level), vector.unit(flat))
