"""The binary pose message: the animated properties of every actor at one tick, laid out as in docs/api.md, little-endian.

A header of 32 bytes, then for each cast four counts and its arrays as float32, in glTF's accessor layout, all 4-byte aligned.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.elementary import sincos
from statwalk.stage.frame import CastFrame, Frame

MAGIC = 0x31575453
HEADER = struct.Struct("<IIIIQII")
COUNTS = struct.Struct("<IIII")
WORDS = NDArray[np.float32]


class PoseMessage(NamedTuple):
    """One decoded message; `casts` in the order of the hello."""

    epoch: int
    tick: int
    head: int
    hash: int
    casts: tuple[CastPoses, ...]


class CastPoses(NamedTuple):
    """The poses of n actors: local transforms of J joints, W morph weights, L layers; root (n,7) is x y z and a quaternion xyzw."""

    translation: WORDS
    rotation: WORDS
    scale: WORDS
    weights: WORDS
    root: WORDS
    phase: WORDS
    blend: WORDS
    state: NDArray[np.uint32]


def root_rows(position: NDArray[Any], heading: NDArray[Any]) -> WORDS:
    """(n,7): metres, and the turn by `heading` radians about y as a quaternion."""
    rows = np.zeros((len(heading), 7), np.float32)
    rows[:, :3] = position
    rows[:, 4], rows[:, 6] = sincos(heading / 2)
    return rows


def cast_arrays(cast: CastFrame) -> Iterator[bytes]:
    """A cast's counts and arrays, as bytes."""
    pose = cast.pose
    yield COUNTS.pack(len(cast.ids), pose.translation.shape[-2], pose.weights.shape[-1], cast.state.shape[-1])
    root = root_rows(cast.root_position, cast.heading)
    for array in (pose.translation, pose.rotation, pose.scale, pose.weights, root, cast.phase, cast.blend):
        yield np.ascontiguousarray(array, "<f4").tobytes()
    yield np.ascontiguousarray(cast.state, "<u4").tobytes()


def encode(frame: Frame, epoch: int, head: int) -> bytes:
    """The message for a frame: immutable, made once, sent to every viewer."""
    parts = [part for cast in frame.casts for part in cast_arrays(cast)]
    length = HEADER.size + sum(len(part) for part in parts)
    header = HEADER.pack(MAGIC, epoch, frame.tick, head, int(frame.hash, 16), len(frame.casts), length)
    return b"".join((header, *parts))


def shapes(n: int, joints: int, weights: int, layers: int) -> Sequence[tuple[int, ...]]:
    """The shapes of a cast's arrays, in the order of the message."""
    return ((n, joints, 3), (n, joints, 4), (n, joints, 3), (n, weights), (n, 7), (n, layers), (n, layers), (n, layers))


def decode(data: bytes) -> PoseMessage:
    """What `encode` wrote; for clients in Python and for tests.

    :raises ValueError: if the message is not one of this version, or cut short.
    """
    if len(data) < HEADER.size:
        raise ValueError(f"a pose message has a header of {HEADER.size} bytes; this has {len(data)} bytes")
    magic, epoch, tick, head, state_hash, count, length = HEADER.unpack_from(data)
    if magic != MAGIC or length != len(data):
        raise ValueError(f"no pose message: magic {magic:#x}, says {length} bytes, has {len(data)}")
    casts, at = [], HEADER.size
    for _ in range(count):
        poses, at = decode_cast(data, at)
        casts.append(poses)
    return PoseMessage(epoch, tick, head, state_hash, tuple(casts))


def decode_cast(data: bytes, at: int) -> tuple[CastPoses, int]:
    """The cast that starts at byte `at`, and where the next one does."""
    arrays: list[NDArray[Any]] = []
    wanted = shapes(*COUNTS.unpack_from(data, at))
    at += COUNTS.size
    for shape in wanted:
        count = int(np.prod(shape))
        kind = "<u4" if len(arrays) == len(wanted) - 1 else "<f4"
        arrays.append(np.frombuffer(data, kind, count, at).reshape(shape))
        at += 4 * count
    return CastPoses(*arrays), at
