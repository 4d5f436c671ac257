"""The frames of a BVH file that is written: the joints' turns from the rest pose, in the character's axes."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.maths import quat
from statwalk.maths.arrays import Bools, Floats
from statwalk.maths.pose import Pose
from statwalk.motion.clip import Clip
from statwalk.rig.evaluate import world_from_local
from statwalk.rig.skeleton import Skeleton

RATE = 60
SLOWEST_KEYS = 1 / 20
"""seconds: keys at least as dense, at equal distances, become the frames as they are"""
MOST_FRAMES, MOST_TURNS = 36_000, 2_000_000
STILL = 1e-6
"""of the character's size: movement within a parent's axes that is none"""


class BvhMotion(NamedTuple):
    """The numbers of a BVH file: F frames of J joints."""

    times: Floats
    """(F,) seconds"""
    seconds: float
    """from frame to frame"""
    offset: Floats
    """(J, 3) from the parent, at rest"""
    position: Floats
    """(F, J, 3) from the parent, in the parent's axes"""
    angles_deg: Floats
    """(F, J, 3) about X, Y and Z"""
    moves: Bools
    """(J,) whether the position differs from the offset"""


def motion_of(character: Character, clip: Clip | None) -> BvhMotion:
    """Returns the frames of a clip of the character; without one, one frame of its rest pose.

    :raises ContentError: when the skeleton is too large to be written frame by frame.
    """
    skeleton = character.skeleton
    if len(skeleton) > MOST_TURNS // 2:
        raise ContentError(f"a BVH file may have {MOST_TURNS // 2:,} joints at most, not {len(skeleton):,}")
    rest = Pose(*(array.astype(np.float64)[None] for array in character.bind_pose))
    times: Floats = np.zeros(1)
    seconds, poses = 1 / RATE, rest
    if clip is not None:
        times, seconds = _frame_times(clip, MOST_TURNS // max(1, len(skeleton)))
        poses = Pose(*(array.astype(np.float64) for array in clip.sample(times)))
    back = quat.conjugate(_world_turns(skeleton, rest))
    offset = _from_parent(skeleton, rest, quat.mul(_world_turns(skeleton, rest), back))[0]
    turned = quat.mul(_world_turns(skeleton, poses), back)
    position = _from_parent(skeleton, poses, turned)
    size = max(float(np.ptp(offset, 0).max(initial=0)), float(np.abs(offset).max(initial=0)), STILL)
    moves = (np.abs(position - offset) > STILL * size).any((0, 2))
    angles = quat.to_euler_xyz(quat.mul(_parents(skeleton, quat.conjugate(turned)), turned))
    return BvhMotion(times, seconds, offset, position, np.degrees(np.unwrap(angles, axis=0)), moves)


def _frame_times(clip: Clip, most: int) -> tuple[Floats, float]:
    """Returns the clip's own key times if they are dense and at equal distances; else 60 a second, fewer in
    very long clips; and the seconds from frame to frame.
    """
    keys = np.unique(np.concatenate([np.zeros(1), *(channel.times for channel in clip.channels)]))
    most = max(2, min(most, MOST_FRAMES))
    if clip.duration <= 0:
        return np.zeros(1), 1 / RATE
    steps = np.diff(keys)
    is_even = len(keys) <= most and bool((np.abs(steps - steps.mean()) < 1e-3 * steps.mean()).all())
    if is_even and steps.mean() <= SLOWEST_KEYS:
        return keys, float(clip.duration / (len(keys) - 1))
    count = min(most, max(2, round(clip.duration * RATE) + 1))
    return np.linspace(0, clip.duration, count), float(clip.duration / (count - 1))


def _world_turns(skeleton: Skeleton, poses: Pose) -> Floats:
    """Returns the rotations (F, J, 4) of the joints in the character's space; scales do not turn."""
    turns = quat.normalize(poses.rotation)
    for joint, parent in enumerate(skeleton.parent.tolist()):
        if parent >= 0:
            turns[:, joint] = quat.normalize(quat.mul(turns[:, parent], turns[:, joint]))
    return turns


def _parents(skeleton: Skeleton, turns: Floats) -> Floats:
    """Returns the rotations of the joints' parents (F, J, 4); of a root none."""
    of_parents = turns[:, skeleton.parent]
    of_parents[:, skeleton.parent < 0] = quat.IDENTITY
    return of_parents


def _from_parent(skeleton: Skeleton, poses: Pose, turned: Floats) -> Floats:
    """Returns where the joints are (F, J, 3), seen from their parents, which have turned."""
    places = world_from_local(skeleton, poses)[..., 3]
    above = np.where((skeleton.parent < 0)[:, None], 0.0, places[:, skeleton.parent])
    return quat.rotate(_parents(skeleton, quat.conjugate(turned)), places - above)
