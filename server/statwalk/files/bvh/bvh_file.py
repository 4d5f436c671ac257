"""Reads a BVH file as a Character with one clip: joints in the order of the file, its units as written."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Literal

import numpy as np

from statwalk.character.character import Character
from statwalk.errors import ContentError, TextError
from statwalk.files.bvh.frames import read_frames
from statwalk.files.bvh.hierarchy import AXES, BvhJoint, lines_of, read_hierarchy
from statwalk.files.gltf import write
from statwalk.files.gltf.names import unique
from statwalk.files.scale import check_scale
from statwalk.files.tetrahedra import MATERIAL, joined_parts
from statwalk.maths import pose as poses
from statwalk.maths import quat
from statwalk.maths.arrays import Floats
from statwalk.maths.filters import continuous
from statwalk.maths.pose import Pose
from statwalk.motion.clip import Channel, Clip
from statwalk.rig.skeleton import Skeleton

Position = Literal["replace", "add"]
POSITIONS: tuple[Position, ...] = ("replace", "add")
Form = tuple[Position, float]
"""how positions count, and the scale"""


def read_bvh(data: bytes, name: str, position: Position = "replace", scale: float = 1.0) -> Character:
    """Reads the character of a BVH file; its clip is called `name` too.

    Position channels replace a joint's OFFSET, axis by axis, or with "add" are added to it. Lengths are the
    file's own units times `scale`. A file with no frames or one frame has a clip of no duration.

    :raises TextError: when the file is refused; `place` is the line.
    """
    if position not in POSITIONS:
        raise ContentError(f"position is one of {', '.join(POSITIONS)}, not {str(position)[:40]!r}")
    check_scale(scale)
    text = text_of(data)
    joints, motion = read_hierarchy(lines_of(text))
    channels = sum(len(joint.channels) for joint in joints)
    rows, seconds = read_frames(text, motion.number, channels)
    skeleton = Skeleton(
        tuple(unique([joint.name for joint in joints], "joint")),
        np.array([joint.parent for joint in joints], np.int32),
    )
    rest = poses.rest(len(joints))
    rest.translation[:] = np.array([joint.offset for joint in joints]) * scale
    clip = _clip(name, joints, rows, seconds, rest, (position, scale))
    parts = joined_parts(skeleton, rest.translation.astype(np.float64))
    character = Character(
        name,
        skeleton,
        np.arange(len(joints), dtype=np.int32),
        rest,
        clips={name: clip},
        parts=parts,
        materials=(MATERIAL,) if parts else (),
    )
    return replace(character, model_glb=write.model_glb(character))


def text_of(data: bytes) -> str:
    """Returns the text; line ends of Windows and of old Macs become newlines."""
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        head = data[:64].lstrip().upper()
        if not head.startswith(b"HIERARCHY") or b"\0" in data:
            raise TextError("this is no BVH file: it is not text", place=f"byte {error.start}") from None
        text = data.decode("latin-1")
    return text.replace("\r\n", "\n").replace("\r", "\n")


def _clip(
    name: str,
    joints: Sequence[BvhJoint],
    rows: Floats,
    seconds: float,
    rest: Pose,
    form: Form,
) -> Clip:
    times = (np.arange(len(rows)) * seconds).astype(np.float32)
    if (times[1:] <= times[:-1]).any():
        raise TextError(f"{len(rows)} frames of {seconds:g} s are too many to be told apart")
    channels = tuple(_channels(joints, rows, times, form)) if len(rows) else ()
    return Clip(name, channels, float(times[-1]) if len(rows) else 0.0, rest)


def _channels(joints: Sequence[BvhJoint], rows: Floats, times: Floats, form: Form) -> Iterator[Channel]:
    """Yields the keys of each joint that has channels."""
    first = 0
    for number, joint in enumerate(joints):
        columns = dict(zip(joint.channels, range(first, first + len(joint.channels)), strict=True))
        first += len(columns)
        if any(channel.endswith("position") for channel in columns):
            yield Channel.checked(
                number, "translation", times, _positions(joint, columns, rows, form), "LINEAR"
            )
        if any(channel.endswith("rotation") for channel in columns):
            yield Channel.checked(number, "rotation", times, _rotations(columns, rows), "LINEAR")


def _positions(joint: BvhJoint, columns: dict[str, int], rows: Floats, form: Form) -> Floats:
    position, scale = form
    places = np.tile(np.asarray(joint.offset, np.float64), (len(rows), 1))
    for axis, letter in enumerate(AXES):
        if f"{letter}position" in columns:
            values = rows[:, columns[f"{letter}position"]]
            places[:, axis] = values if position == "replace" else places[:, axis] + values
    return (places * scale).astype(np.float32)


def _rotations(columns: dict[str, int], rows: Floats) -> Floats:
    """Returns the product of the turns (F, 4) in the order of the channels: R = R1 · R2 · R3."""
    turn: Floats | None = None
    for channel, column in columns.items():
        if channel.endswith("rotation"):
            axis = np.eye(3)[AXES.index(channel[0])]
            own = quat.from_axis_angle(axis, np.radians(np.remainder(rows[:, column], 360.0)))
            turn = own if turn is None else quat.mul(turn, own)
    assert turn is not None
    return continuous(turn).astype(np.float32)
