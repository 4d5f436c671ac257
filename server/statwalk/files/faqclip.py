"""From key frames to a clip: which channels the bones get, and how they pass from key to key (FAQ Q17). KF3, KF4, KF5, KF7."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from statwalk.errors import TextError, UnknownNameError
from statwalk.files.faqkeys import BoneKey, KeyFrame
from statwalk.maths import quat, vector
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose
from statwalk.motion.channel import Channel, Interpolation, Path
from statwalk.motion.clip import Clip
from statwalk.rig.bones import Bones

_DENSE_PER_SECOND, _DENSE_MOST = 60, 32
INTERPOLATIONS: Mapping[str, Interpolation] = {
    "hold": "STEP",  # until the next key
    "step": "STEP",  # switched half-way between two keys (RTCA Listing 2)
    "linear": "LINEAR",  # rotations: straight and normalised
    "slerp": "LINEAR",
    "squad": "LINEAR",
    "euler linear": "LINEAR",  # the FAQ's own: each of the three angles for itself
    "b-spline": "BSPLINE",
    "b-spline through": "BSPLINE_THROUGH",
}


@dataclass(frozen=True, eq=False)
class ClipForm:
    """What all clips of a character share: its bones in metres, the joint at the end of a bone (where it has one), the pose at rest."""

    bones: Bones
    scale: float
    """metres per unit of the files"""
    ends: Mapping[int, int]
    rest: Pose


@dataclass(frozen=True, eq=False)
class _Keys:
    times: Floats
    values: Floats


def check_names(bones: Bones, frames: Sequence[KeyFrame]) -> None:
    """Raises TextError where a pose keys a bone that the skeleton does not have."""
    known = set(bones.skeleton.names)
    for frame in frames:
        for name, key in frame.bones.items():
            if name not in known:
                raise TextError(str(UnknownNameError("bone", name, bones.skeleton.names)), place=key.place)


def keyed_lengths(bones: Bones, frames: Sequence[KeyFrame]) -> dict[int, float]:
    """The bones whose length is keyed, and the greatest length of each, in the file's unit."""
    longest: dict[int, float] = {}
    for frame in frames:
        for name, key in frame.bones.items():
            if key.length is not None:
                bone = bones.skeleton.index(name)
                longest[bone] = max(longest.get(bone, 0.0), key.length)
    return longest


def clip_of(name: str, form: ClipForm, frames: Sequence[KeyFrame], interpolation: str, loop: bool) -> Clip:
    """The clip of some poses: a bone is keyed at the times at which it is named, and rests where it is not."""
    channels: list[Channel] = []
    for bone, bone_name in enumerate(form.bones.skeleton.names):
        keys = [(frame.time, frame.bones[bone_name]) for frame in frames if bone_name in frame.bones]
        channels += _rotation(bone, keys, interpolation)
        channels += _translation(form, bone, keys, _lengths(form, int(form.bones.skeleton.parent[bone]), frames), interpolation)
        channels += _scale(bone, keys, interpolation)
        if bone in form.ends:
            channels += _translation(form, form.ends[bone], [], _lengths(form, bone, frames), interpolation)
    return Clip(name, tuple(channels), frames[-1].time, form.rest, loop=loop)


def _channel(joint: int, path: Path, keys: _Keys, interpolation: str) -> list[Channel]:
    times, values = keys.times.astype(np.float32), keys.values.astype(np.float32)
    if interpolation == "step":
        halves = (times[:-1] + times[1:]) * np.float32(0.5)
        times, values = np.concatenate([times[:1], halves, times[-1:]]), np.concatenate([values, values[-1:]])
        times, values = (times[1:], values[1:]) if len(times) == 2 else (times, values)
    return [Channel(joint, path, times, values, INTERPOLATIONS[interpolation])]


def _rotation(bone: int, keys: Sequence[tuple[float, BoneKey]], interpolation: str) -> list[Channel]:
    """The channel of a bone's turns, from its angles or matrices."""
    turned = [(time, key) for time, key in keys if key.rotate_deg is not None or key.matrix is not None]
    if not turned:
        return []
    times = np.array([time for time, _ in turned])
    quaternions = np.stack([_quaternion(key) for _, key in turned])
    if interpolation not in ("linear", "squad", "euler linear") or len(times) == 1:
        return _channel(bone, "rotation", _Keys(times, quaternions), interpolation)
    index, part, dense = _dense(times)
    if interpolation == "euler linear":
        angles = np.stack([_angles(key, turn) for (_, key), turn in zip(turned, quaternions, strict=True)])
        values = quat.from_euler_xyz(angles[index] * (1 - part)[:, None] + angles[index + 1] * part[:, None])
    elif interpolation == "linear":
        values = quat.nlerp(quaternions[index], quaternions[index + 1], part)
    else:
        values = _squad(quaternions, index, part)
    return _channel(bone, "rotation", _Keys(dense, values), interpolation)


def _dense(times: Floats) -> tuple[np.ndarray[tuple[int, ...], np.dtype[np.int64]], Floats, Floats]:
    """Close moments on the way between keys, where a curve that clips do not know is laid down: (key before, part of the way, time)."""
    counts = np.clip(np.ceil(np.diff(times) * _DENSE_PER_SECOND), 1, _DENSE_MOST).astype(np.int64)
    index = np.repeat(np.arange(len(counts)), counts)
    part = np.concatenate([np.arange(count) / count for count in counts])
    index, part = np.append(index, len(counts) - 1), np.append(part, 1.0)
    return index, part, times[index] * (1 - part) + times[index + 1] * part


def _squad(keys: Floats, index: np.ndarray[tuple[int, ...], np.dtype[np.int64]], part: Floats) -> Floats:
    """The spherical cubic through the keys; it leaves the first and reaches the last as if the neighbours were they themselves."""
    aligned = keys.copy()
    for row in range(1, len(keys)):
        aligned[row] = quat.align(aligned[row - 1], aligned[row])
    before, after = aligned[np.maximum(np.arange(len(keys)) - 1, 0)], aligned[np.minimum(np.arange(len(keys)) + 1, len(keys) - 1)]
    inner = quat.squad_tangent(before, aligned, after)
    return quat.squad(aligned[index], inner[index], inner[index + 1], aligned[index + 1], part)


def _angles(key: BoneKey, turn: Floats) -> Floats:
    """The three angles in radians."""
    return quat.to_euler_xyz(turn) if key.rotate_deg is None else np.radians(key.rotate_deg)


def _quaternion(key: BoneKey) -> Floats:
    if key.matrix is None:
        return quat.from_euler_xyz(np.radians(key.rotate_deg or (0.0, 0.0, 0.0)))
    return quat.from_matrix(key.matrix[:, :3] / vector.length(key.matrix[:, :3].T))


def _lengths(form: ClipForm, bone: int, frames: Sequence[KeyFrame]) -> _Keys:
    """When and how a bone's length is keyed, metres (K,)."""
    name = form.bones.skeleton.names[bone] if bone >= 0 else ""
    keyed = [(frame.time, key.length) for frame in frames if (key := frame.bones.get(name)) is not None and key.length is not None]
    return _Keys(np.array([time for time, _ in keyed]), np.array([length for _, length in keyed]) * form.scale)


def _translation(form: ClipForm, joint: int, keys: Sequence[tuple[float, BoneKey]], length: _Keys, interpolation: str) -> list[Channel]:
    """The channel of a joint's place: its parent's direction times its parent's length, and its own translation on top."""
    moved = [(time, _moved(key)) for time, key in keys if key.translate is not None or key.matrix is not None]
    times = np.union1d(np.array([time for time, _ in moved]), length.times)
    if not len(times):
        return []
    place: Floats = np.broadcast_to(form.rest.translation[joint].astype(np.float64), (len(times), 3))
    if len(length.times):
        parent = next((bone for bone, end in form.ends.items() if end == joint), None)
        above = int(form.bones.skeleton.parent[joint]) if parent is None else parent
        place = form.bones.direction[above] * np.interp(times, length.times, length.values)[:, None]
    if moved:
        when, own = np.array([time for time, _ in moved]), np.array([offset for _, offset in moved]) * form.scale
        place = place + np.stack([np.interp(times, when, own[:, axis]) for axis in range(3)], -1)
    return _channel(joint, "translation", _Keys(times, place), interpolation)


def _moved(key: BoneKey) -> Floats:
    return np.array(key.translate) if key.matrix is None else key.matrix[:, 3]


def _scale(bone: int, keys: Sequence[tuple[float, BoneKey]], interpolation: str) -> list[Channel]:
    """The channel of the sizes that a bone's matrices have, if any is not 1."""
    sized = [(time, vector.length(key.matrix[:, :3].T)) for time, key in keys if key.matrix is not None]
    values = np.array([size for _, size in sized])
    if not sized or bool((np.abs(values - 1) < 1e-6).all()):
        return []
    return _channel(bone, "scale", _Keys(np.array([time for time, _ in sized]), values), interpolation)
