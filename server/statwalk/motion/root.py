"""Root motion: the clip's movement of the character's position and heading is taken out of the pose and moves
the actor instead.

A place is a row x, z (metres), yaw (radians about +Y; a turn to the left is positive, +Z is forward). The
root joint keeps its height, pitch and roll. A motion that plays once gives its whole movement to the root.
From a loop the root takes the even part, a straight line or an arc of constant speed; the sway about it stays
in the pose, so that the heading does not wag.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from statwalk.maths import quat, transform
from statwalk.maths.arrays import Floats
from statwalk.maths.elementary import atan2, sin, sincos
from statwalk.motion.clip import Clip
from statwalk.motion.keys.channel import Channel
from statwalk.motion.root_track import STANDING, RootTrack, compose, relative

__all__ = ["STANDING", "RootTrack", "compose", "extract", "relative"]

SAMPLES_PER_SECOND = 240  # of the root's channels in the clip without its root motion
_UP = np.array([0.0, 1.0, 0.0])


def extract(clip: Clip, joint: int, loop: bool, frame: Floats | None = None) -> tuple[Clip, RootTrack]:
    """Returns the clip with `joint` in place, and the root track taken out of it.

    `frame` (3, 4): the transform of the joint's parent in the character's space (default: no parent). A joint
    without keys has no root motion.
    """
    if all(channel.joint != joint for channel in clip.channels) or clip.duration <= 0:
        return clip, STANDING
    frame = transform.from_trs(np.zeros(3), quat.IDENTITY, np.ones(3)) if frame is None else frame
    times = _times(clip, joint)
    pose = clip.sample(times)
    position = transform.apply(frame, pose.translation[:, joint].astype(np.float64))
    turn = quat.mul(_rotation_of(frame), pose.rotation[:, joint].astype(np.float64))
    rest = quat.mul(_rotation_of(frame), clip.rest.rotation[joint].astype(np.float64))
    places = np.concatenate([position[:, ::2], _yaw(quat.mul(turn, quat.conjugate(rest)))[:, None]], -1)
    path = _even(times / clip.duration, places) if loop else places
    in_place = _in_place(clip, joint, frame, times, (position, turn, path))
    return in_place, RootTrack(times, path)


def _times(clip: Clip, joint: int) -> Floats:
    """The joint's own key times and a fine grid between them, distinct in float32."""
    keys = [channel.times for channel in clip.channels if channel.joint == joint]
    grid = np.arange(0, clip.duration, 1 / SAMPLES_PER_SECOND)
    every = np.unique(np.concatenate([grid, [clip.duration], *keys]).astype(np.float32))
    return every.astype(np.float64)


def _rotation_of(frame: Floats) -> Floats:
    """The rotation (4,) of a matrix T·R·S (3, 4)."""
    columns = frame[:, :3]
    lengths = np.sqrt(columns[0] * columns[0] + columns[1] * columns[1] + columns[2] * columns[2])
    return quat.from_matrix(columns / lengths)


def _yaw(turn: Floats) -> Floats:
    """The twist about +Y of rotations (K, 4), radians without jumps of a whole turn."""
    half = np.unwrap(atan2(turn[:, 1], turn[:, 3]), period=np.pi)
    return 2 * half


def _even(part: Floats, places: Floats) -> Floats:
    """The arc of constant speed and turn from the first place to the last, at fractions `part` (K,) 0…1."""
    first, last = places[:1], places[-1:]
    whole = relative(first, last)
    x, z, yaw = whole[0]
    half = yaw / 2
    is_straight = abs(sin(half)) < 1e-9
    chord = part if is_straight else sin(part * half) / sin(half)
    sine, cosine = sincos((part - 1) * half)
    way = np.stack([(x * cosine + z * sine) * chord, (z * cosine - x * sine) * chord, yaw * part], -1)
    return compose(first.repeat(len(part), 0), way)


def _in_place(
    clip: Clip, joint: int, frame: Floats, times: Floats, moving: tuple[Floats, Floats, Floats]
) -> Clip:
    """The clip with the joint's translation and rotation relative to the path; `moving` is position, rotation
    and path.
    """
    position, turn, path = moving
    seen = relative(path, np.concatenate([position[:, ::2], path[:, 2:]], -1))
    still = np.stack([seen[:, 0], position[:, 1], seen[:, 1]], -1)
    back = quat.from_axis_angle(_UP, -path[:, 2])
    rotation = quat.mul(quat.conjugate(_rotation_of(frame)), quat.mul(back, turn))
    translation = transform.apply(transform.invert(frame), still)
    keys = times.astype(np.float32)
    ours = (
        Channel(joint, "translation", keys, translation.astype(np.float32)),
        Channel(joint, "rotation", keys, rotation.astype(np.float32)),
    )
    others = tuple(
        channel for channel in clip.channels if channel.joint != joint or channel.path in ("scale", "weights")
    )
    return replace(clip, channels=(*ours, *others))
