"""Builds clips from key frames: the channels of each bone, and how they are interpolated (FAQ Q17).

KF3, KF4, KF5, KF6, KF7.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from statwalk.errors import TextError, UnknownNameError
from statwalk.files.faq.key_frame_text import BoneKey, KeyFrame
from statwalk.maths import quat, vector
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose
from statwalk.motion.clip import Clip
from statwalk.motion.keys.channel import Channel, Path
from statwalk.motion.keys.interpolations import TimedKeys, channel_of, rotation_channel
from statwalk.rig.bones import Bones

Interpolations = Mapping[Path, str]
"""the name of the interpolation of each property"""


@dataclass(frozen=True, eq=False)
class ClipForm:
    """What all clips of a character share: the bones in metres, the joint at the end of each bone that has
    one, and the pose at rest.
    """

    bones: Bones
    scale: float
    """metres per unit of the files"""
    ends: Mapping[int, int]
    rest: Pose


def check_names(bones: Bones, frames: Sequence[KeyFrame]) -> None:
    """Checks that the skeleton has every bone that a pose keys.

    :raises TextError: when a pose keys an unknown bone; `place` is the line of the key.
    """
    bone_names = set(bones.skeleton.names)
    for frame in frames:
        for name, key in frame.bones.items():
            if name not in bone_names:
                raise TextError(str(UnknownNameError("bone", name, bones.skeleton.names)), place=key.place)


def keyed_lengths(bones: Bones, frames: Sequence[KeyFrame]) -> dict[int, float]:
    """Returns the greatest keyed length of each bone whose length is keyed, in the file's unit."""
    longest_lengths: dict[int, float] = {}
    for frame in frames:
        for name, key in frame.bones.items():
            if key.length is not None:
                bone = bones.skeleton.index(name)
                longest_lengths[bone] = max(longest_lengths.get(bone, 0.0), key.length)
    return longest_lengths


def clip_of(name: str, form: ClipForm, frames: Sequence[KeyFrame], how: Interpolations, loop: bool) -> Clip:
    """Builds the clip of a list of poses. A bone has a key at each time that names the bone, and rests if no
    pose names it.
    """
    channels: list[Channel] = []
    for bone, bone_name in enumerate(form.bones.skeleton.names):
        keys = [(frame.time, frame.bones[bone_name]) for frame in frames if bone_name in frame.bones]
        channels += _rotation(bone, keys, how["rotation"])
        channels += _translation(
            form,
            bone,
            keys,
            _lengths(form, int(form.bones.skeleton.parent[bone]), frames),
            how["translation"],
        )
        channels += _scale(bone, keys, how["scale"])
        if bone in form.ends:
            channels += _translation(
                form, form.ends[bone], [], _lengths(form, bone, frames), how["translation"]
            )
    return Clip(name, tuple(channels), frames[-1].time, form.rest, loop=loop)


def _rotation(bone: int, keys: Sequence[tuple[float, BoneKey]], interpolation: str) -> list[Channel]:
    """Builds the rotation channel of a bone, from the angles or matrices of its keys."""
    rotation_keys = [
        (time, key) for time, key in keys if key.rotate_deg is not None or key.matrix is not None
    ]
    if not rotation_keys:
        return []
    quaternions = np.stack([_quaternion(key) for _, key in rotation_keys])
    angles = np.stack([_angles(key, turn) for (_, key), turn in zip(rotation_keys, quaternions, strict=True)])
    times = np.array([time for time, _ in rotation_keys])
    weights = np.array([key.weight for _, key in rotation_keys])
    return [rotation_channel(bone, TimedKeys(times, quaternions, weights), angles, interpolation)]


def _angles(key: BoneKey, rotation: Floats) -> Floats:
    """Returns the three Euler angles in radians."""
    return quat.to_euler_xyz(rotation) if key.rotate_deg is None else np.radians(key.rotate_deg)


def _quaternion(key: BoneKey) -> Floats:
    if key.matrix is None:
        return quat.from_euler_xyz(np.radians(key.rotate_deg or (0.0, 0.0, 0.0)))
    return quat.from_matrix(key.matrix[:, :3] / vector.length(key.matrix[:, :3].T))


def _lengths(form: ClipForm, bone: int, frames: Sequence[KeyFrame]) -> TimedKeys:
    """Returns the times and lengths (K,), in metres, of the keys of a bone's length."""
    name = form.bones.skeleton.names[bone] if bone >= 0 else ""
    length_keys = [
        (frame.time, key.length)
        for frame in frames
        if (key := frame.bones.get(name)) is not None and key.length is not None
    ]
    return TimedKeys(
        np.array([time for time, _ in length_keys]),
        np.array([length for _, length in length_keys]) * form.scale,
    )


def _translation(
    form: ClipForm,
    joint: int,
    keys: Sequence[tuple[float, BoneKey]],
    parent_length: TimedKeys,
    interpolation: str,
) -> list[Channel]:
    """Builds the translation channel of a joint: its parent's direction times its parent's length, plus its
    own translation.
    """
    offset_keys = [
        (time, _offset(key)) for time, key in keys if key.translate is not None or key.matrix is not None
    ]
    times = np.union1d(np.array([time for time, _ in offset_keys]), parent_length.times)
    if not len(times):
        return []
    positions: Floats = np.broadcast_to(form.rest.translation[joint].astype(np.float64), (len(times), 3))
    if len(parent_length.times):
        parent = next((bone for bone, end in form.ends.items() if end == joint), None)
        parent_bone = int(form.bones.skeleton.parent[joint]) if parent is None else parent
        positions = (
            form.bones.direction[parent_bone]
            * np.interp(times, parent_length.times, parent_length.values)[:, None]
        )
    if offset_keys:
        own_times, own_offsets = (
            np.array([time for time, _ in offset_keys]),
            np.array([offset for _, offset in offset_keys]) * form.scale,
        )
        positions = positions + np.stack(
            [np.interp(times, own_times, own_offsets[:, axis]) for axis in range(3)], -1
        )
    weights = np.interp(times, [time for time, _ in keys], [key.weight for _, key in keys]) if keys else None
    return [channel_of(joint, "translation", TimedKeys(times, positions, weights), interpolation)]


def _offset(key: BoneKey) -> Floats:
    return np.array(key.translate) if key.matrix is None else key.matrix[:, 3]


def _scale(bone: int, keys: Sequence[tuple[float, BoneKey]], interpolation: str) -> list[Channel]:
    """Builds the scale channel from a bone's matrices; none if all scales are 1."""
    scale_keys = [(time, vector.length(key.matrix[:, :3].T)) for time, key in keys if key.matrix is not None]
    values = np.array([scale for _, scale in scale_keys])
    if not scale_keys or bool((np.abs(values - 1) < 1e-6).all()):
        return []
    times = np.array([time for time, _ in scale_keys])
    weights = np.array([key.weight for _, key in keys if key.matrix is not None])
    return [channel_of(bone, "scale", TimedKeys(times, values, weights), interpolation)]
