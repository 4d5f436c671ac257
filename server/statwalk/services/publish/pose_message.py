"""The binary pose message: the animated properties of every actor at one tick, little-endian.

The layout is in docs/api.md: a header of 32 bytes, then for each cast four counts and its arrays as float32
(`state`: uint32) in glTF's accessor layout, all 4-byte aligned.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.elementary import sincos
from statwalk.stage.state.frame import CastFrame, Frame

MAGIC = 0x31575453
HEADER = struct.Struct("<IIIIQII")
COUNTS = struct.Struct("<IIII")
FloatRows = NDArray[np.float32]


class PoseMessage(NamedTuple):
    """A decoded message; `casts` in the order of the hello."""

    epoch: int
    tick: int
    head: int
    hash: int
    casts: tuple[CastPoses, ...]


class CastPoses(NamedTuple):
    """The poses of n actors with J joints, W morph weights and L layers.

    Local transforms: translation (n,J,3), rotation (n,J,4) xyzw, scale (n,J,3). weights (n,W). root (n,7): x
    y z and a quaternion xyzw. phase, blend and state (n,L).
    """

    translation: FloatRows
    rotation: FloatRows
    scale: FloatRows
    weights: FloatRows
    root: FloatRows
    phase: FloatRows
    blend: FloatRows
    state: NDArray[np.uint32]


def _root_rows(position: NDArray[Any], heading: NDArray[Any]) -> FloatRows:
    """Returns (n,7): the position in metres, and the rotation by `heading` radians about +Y as a
    quaternion.
    """
    rows = np.zeros((len(heading), 7), np.float32)
    rows[:, :3] = position
    rows[:, 4], rows[:, 6] = sincos(heading / 2)
    return rows


def _cast_arrays(cast: CastFrame) -> Iterator[bytes]:
    pose = cast.pose
    yield COUNTS.pack(len(cast.ids), pose.translation.shape[-2], pose.weights.shape[-1], cast.state.shape[-1])
    root = _root_rows(cast.root_position, cast.heading)
    for array in (pose.translation, pose.rotation, pose.scale, pose.weights, root, cast.phase, cast.blend):
        yield np.ascontiguousarray(array, "<f4").tobytes()
    yield np.ascontiguousarray(cast.state, "<u4").tobytes()


def encode(frame: Frame, epoch: int, head: int) -> bytes:
    """Returns the message of a frame; `epoch` numbers its layout, `head` is the stage's newest tick."""
    parts = [part for cast in frame.casts for part in _cast_arrays(cast)]
    length = HEADER.size + sum(len(part) for part in parts)
    header = HEADER.pack(MAGIC, epoch, frame.tick, head, int(frame.hash, 16), len(frame.casts), length)
    return b"".join((header, *parts))


def _shapes(n: int, joints: int, weights: int, layers: int) -> Sequence[tuple[int, ...]]:
    """Returns the shapes of a cast's arrays, in the order of the message."""
    return (
        (n, joints, 3),
        (n, joints, 4),
        (n, joints, 3),
        (n, weights),
        (n, 7),
        (n, layers),
        (n, layers),
        (n, layers),
    )


def decode(data: bytes) -> PoseMessage:
    """Decodes a message of `encode`, for clients in Python and for tests.

    :raises ValueError: when the bytes are no pose message of this version, or are cut short.
    """
    if len(data) < HEADER.size:
        raise ValueError(f"a pose message has a header of {HEADER.size} bytes; this has {len(data)} bytes")
    magic, epoch, tick, head, state_hash, count, length = HEADER.unpack_from(data)
    if magic != MAGIC or length != len(data):
        raise ValueError(
            f"no pose message: magic {magic:#x}, length {length} in a message of {len(data)} bytes"
        )
    casts, at = [], HEADER.size
    for _ in range(count):
        poses, at = _decode_cast(data, at)
        casts.append(poses)
    return PoseMessage(epoch, tick, head, state_hash, tuple(casts))


def _decode_cast(data: bytes, at: int) -> tuple[CastPoses, int]:
    """Returns the cast that starts at byte `at`, and the byte after it."""
    arrays: list[NDArray[Any]] = []
    shapes = _shapes(*COUNTS.unpack_from(data, at))
    at += COUNTS.size
    for shape in shapes:
        count = int(np.prod(shape))
        dtype = "<u4" if len(arrays) == len(shapes) - 1 else "<f4"
        arrays.append(np.frombuffer(data, dtype, count, at).reshape(shape))
        at += 4 * count
    return CastPoses(*arrays), at
