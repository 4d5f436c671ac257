"""The layout of a `PoseBuffer`: no other module computes a position in one.

The values are (B, C, LANES): the actor of row LANES·b + l is lane l of block b. The channels of a pose are,
for each joint, translation xyz, rotation xyzw and scale xyz, then the morph weights, then padding to a
multiple of LANES. NumPy calls the plain functions, kernels the inlined ones.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Ints
from statwalk.maths.compiling import inlined
from statwalk.maths.simd.aligned import zeros
from statwalk.maths.simd.lanes import LANES

JOINT_CHANNELS, ROTATION_CHANNEL, SCALE_CHANNEL = 10, 3, 7
"""channels of a joint; the first of its rotation and of its scale"""
_FIRST = {"translation": 0, "rotation": ROTATION_CHANNEL, "scale": SCALE_CHANNEL}


def places(rows: Ints) -> tuple[Ints, Ints]:
    """Returns the block and the lane of each row."""
    return rows // LANES, rows % LANES


def blocks(count: int) -> int:
    """Returns the number of blocks for `count` actors."""
    return -(-count // LANES)


def padded(channels: int) -> int:
    """Returns the next multiple of LANES."""
    return blocks(channels) * LANES


def zero_blocks(blocks: int, channels: int) -> NDArray[np.float32]:
    """Returns (B, C, LANES) zeros, aligned to a cache line."""
    return zeros(blocks * channels * LANES).reshape(blocks, channels, LANES)


def first_channels(path: str, targets: Ints, joints: int) -> Ints:
    """Returns the first channel of a property of some joints, or the channels of some "weights", of a pose of
    `joints` joints.
    """
    return JOINT_CHANNELS * joints + targets if path == "weights" else JOINT_CHANNELS * targets + _FIRST[path]


def indices_in_block(channels: Ints) -> NDArray[np.int32]:
    """Returns the index of each channel's first number in a block."""
    return (channels * LANES).astype(np.int32)


@inlined
def channel_of(index: int) -> int:
    """Returns the channel of an index in a block."""
    return index // LANES


@inlined
def joint_channel(joint: int) -> int:
    """Returns the first channel of a joint."""
    return JOINT_CHANNELS * joint


@inlined
def weight_channel(joints: int, weight: int) -> int:
    """Returns the channel of a morph weight of a pose of `joints` joints."""
    return JOINT_CHANNELS * joints + weight


@inlined
def index_at(values: Any, block: int, channel: int) -> Any:
    """Returns the index of a channel's first number in values (B, C, LANES)."""
    return (block * values.shape[1] + channel) * LANES


@inlined
def place_of(row: int) -> tuple[int, int]:
    """Returns the block and the lane of a row."""
    return row // LANES, row % LANES


@inlined
def first_row(block: int) -> int:
    """Returns the row of a block's first actor."""
    return LANES * block


@inlined
def end_row(block: int, count: int) -> int:
    """Returns the row after a block's last actor, of `count` actors in all."""
    return min(LANES * (block + 1), count)
