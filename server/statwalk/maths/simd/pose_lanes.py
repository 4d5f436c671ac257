"""Joints of a block of a `PoseBuffer` as lanes (see `pose_layout`).

`at` is the index of a joint's first float in values (B, C, 16); a channel is sixteen floats.
"""

from __future__ import annotations

from typing import Any

from statwalk.maths.compiling import inlined
from statwalk.maths.simd.lane_functions import either
from statwalk.maths.simd.lanes import LANES, load, store
from statwalk.maths.simd.pose_layout import (
    ROTATION_CHANNEL,
    SCALE_CHANNEL,
    index_at,
    joint_channel,
    weight_channel,
)

ROTATION, SCALE = ROTATION_CHANNEL * LANES, SCALE_CHANNEL * LANES
"""floats from a joint's first float to its rotation and scale"""


@inlined
def joint_at(values: Any, block: int, joint: int) -> Any:
    """Returns the index of a joint's first float."""
    return index_at(values, block, joint_channel(joint))


@inlined
def weight_at(values: Any, block: int, joints: int, weight: int) -> Any:
    """Returns the index of a morph weight of a pose of `joints` joints."""
    return index_at(values, block, weight_channel(joints, weight))


@inlined
def load3(values: Any, at: int) -> Any:
    """Returns three channels."""
    return load(values, at), load(values, at + LANES), load(values, at + 2 * LANES)


@inlined
def load4(values: Any, at: int) -> Any:
    """Returns four channels."""
    return (
        load(values, at),
        load(values, at + LANES),
        load(values, at + 2 * LANES),
        load(values, at + 3 * LANES),
    )


@inlined
def store3(values: Any, at: int, v: Any) -> None:
    """Writes three channels."""
    store(values, at, v[0])
    store(values, at + LANES, v[1])
    store(values, at + 2 * LANES, v[2])


@inlined
def either3(mask: Any, a: Any, b: Any) -> Any:
    """Returns a in lanes with a mask above 0, else b; three channels."""
    return either(mask, a[0], b[0]), either(mask, a[1], b[1]), either(mask, a[2], b[2])


@inlined
def store4(values: Any, at: int, q: Any) -> None:
    """Writes four channels."""
    store3(values, at, q)
    store(values, at + 3 * LANES, q[3])


@inlined
def either4(mask: Any, a: Any, b: Any) -> Any:
    """Returns a in lanes with a mask above 0, else b; four channels."""
    return (
        either(mask, a[0], b[0]),
        either(mask, a[1], b[1]),
        either(mask, a[2], b[2]),
        either(mask, a[3], b[3]),
    )
