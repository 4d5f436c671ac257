"""Builds clips from key frames: the channels of each bone, and how they are interpolated (FAQ Q17).

KF3, KF4, KF5, KF6, KF7.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from statwalk.errors import TextError, UnknownNameError
from statwalk.files.faq.key_frame_text import BoneKey, KeyFrame
from statwalk.maths import quat, vector
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose
from statwalk.motion.clip import Clip
from statwalk.motion.keys.channel import WEIGHT_RANGE, Channel, Path
from statwalk.motion.keys.interpolations import TimedKeys, channel_of, rotation_channel
from statwalk.rig.bones import Bones

ByPath = Mapping[Path, str]
"""the name of the interpolation of each property"""


@dataclass(frozen=True)
class Interpolations:
    """How keys are interpolated: each property, and what differs in single bones."""

    everywhere: ByPath
    bones: Mapping[str, ByPath] = field(default_factory=dict)

    def of(self, bone: str, path: Path) -> str:
        """Returns the name of the interpolation of a bone's property."""
        return self.bones.get(bone, {}).get(path, self.everywhere[path])


_NO_KEYS = TimedKeys(np.zeros(0), np.zeros((0, 3)))


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
        channels += _rotation(bone, keys, how.of(bone_name, "rotation"), loop)
        parent = int(form.bones.skeleton.parent[bone])
        channels += _translation(form, bone, _offsets(form, keys), _lengths(form, parent, frames), how)
        channels += _scale(bone, keys, how.of(bone_name, "scale"))
        if bone in form.ends:
            channels += _translation(form, form.ends[bone], _NO_KEYS, _lengths(form, bone, frames), how)
    return Clip(name, tuple(channels), frames[-1].time, form.rest, loop=loop)


def _rotation(
    bone: int, keys: Sequence[tuple[float, BoneKey]], interpolation: str, loop: bool
) -> list[Channel]:
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
    return [rotation_channel(bone, TimedKeys(times, quaternions, weights), angles, interpolation, loop)]


def _angles(key: BoneKey, rotation: Floats) -> Floats:
    """Returns the three Euler angles in radians."""
    return quat.to_euler_xyz(rotation) if key.rotate_deg is None else np.radians(key.rotate_deg)


def _quaternion(key: BoneKey) -> Floats:
    if key.matrix is None:
        return quat.from_euler_xyz(np.radians(key.rotate_deg or (0.0, 0.0, 0.0)))
    return quat.from_matrix(key.matrix[:, :3] / vector.length(key.matrix[:, :3].T))


def _offsets(form: ClipForm, keys: Sequence[tuple[float, BoneKey]]) -> TimedKeys:
    """Returns the keys (K, 3) of a bone's own translation, in metres."""
    moved = [(time, key) for time, key in keys if key.translate is not None or key.matrix is not None]
    return TimedKeys(
        np.array([time for time, _ in moved]),
        np.array([_offset(key) for _, key in moved]) * form.scale,
        np.array([key.weight for _, key in moved]),
    )


def _lengths(form: ClipForm, bone: int, frames: Sequence[KeyFrame]) -> TimedKeys:
    """Returns the keys (K,) of a bone's length, in metres."""
    name = form.bones.skeleton.names[bone] if bone >= 0 else ""
    keys = [
        (frame.time, key.length, key.weight)
        for frame in frames
        if (key := frame.bones.get(name)) is not None and key.length is not None
    ]
    times, lengths, weights = np.array(keys, np.float64).reshape(-1, 3).T
    return TimedKeys(times, lengths * form.scale, weights)


def _translation(
    form: ClipForm, joint: int, own: TimedKeys, parent_length: TimedKeys, how: Interpolations
) -> list[Channel]:
    """Builds the translation channel of a joint: its parent's direction times its parent's length, plus its
    own translation. A joint that only its parent's length moves is interpolated as the parent is.
    """
    times = np.union1d(own.times, parent_length.times)
    if not len(times):
        return []
    parent = next((bone for bone, end in form.ends.items() if end == joint), None)
    parent = int(form.bones.skeleton.parent[joint]) if parent is None else parent
    positions: Floats = np.broadcast_to(form.rest.translation[joint].astype(np.float64), (len(times), 3))
    if len(parent_length.times):
        lengths = np.interp(times, parent_length.times, parent_length.values)
        positions = form.bones.direction[parent] * lengths[:, None]
    if len(own.times):
        positions = positions + np.stack([np.interp(times, own.times, axis) for axis in own.values.T], -1)
    weights = np.clip(_weights_at(times, own) * _weights_at(times, parent_length), *WEIGHT_RANGE)
    bone = form.bones.skeleton.names[joint if len(own.times) else parent]
    return [
        channel_of(joint, "translation", TimedKeys(times, positions, weights), how.of(bone, "translation"))
    ]


def _weights_at(times: Floats, keys: TimedKeys) -> Floats:
    weights = keys.weights
    return (
        np.ones(len(times)) if weights is None or not len(weights) else np.interp(times, keys.times, weights)
    )


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
