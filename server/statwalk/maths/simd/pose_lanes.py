"""Joints of a block of a `PoseBuffer` as lanes: the positions of a joint's channels, defined once for all
kernels.

`at` is the index of a joint's first float in values (B, C, 16); a channel is sixteen floats.
"""

from __future__ import annotations

from typing import Any

from statwalk.maths.compiling import inlined
from statwalk.maths.simd.lane_functions import either
from statwalk.maths.simd.lanes import load, store

CHANNELS = 10
"""channels of a joint: translation, rotation, scale"""
WIDTH = 16
ROTATION, SCALE = 3 * WIDTH, 7 * WIDTH
"""floats from a joint's first float to its rotation and scale"""


@inlined
def joint_at(values: Any, block: int, joint: int) -> Any:
    """Returns the index of a joint's first float."""
    return (block * values.shape[1] + CHANNELS * joint) * WIDTH


@inlined
def weight_at(values: Any, block: int, joints: int, weight: int) -> Any:
    """Returns the index of a morph weight of a pose of `joints` joints."""
    return (block * values.shape[1] + CHANNELS * joints + weight) * WIDTH


@inlined
def load3(values: Any, at: int) -> Any:
    """Returns three channels."""
    return load(values, at), load(values, at + WIDTH), load(values, at + 2 * WIDTH)


@inlined
def load4(values: Any, at: int) -> Any:
    """Returns four channels."""
    return (
        load(values, at),
        load(values, at + WIDTH),
        load(values, at + 2 * WIDTH),
        load(values, at + 3 * WIDTH),
    )


@inlined
def store3(values: Any, at: int, v: Any) -> None:
    """Writes three channels."""
    store(values, at, v[0])
    store(values, at + WIDTH, v[1])
    store(values, at + 2 * WIDTH, v[2])


@inlined
def either3(mask: Any, a: Any, b: Any) -> Any:
    """Returns a in lanes with a mask above 0, else b; three channels."""
    return either(mask, a[0], b[0]), either(mask, a[1], b[1]), either(mask, a[2], b[2])


@inlined
def store4(values: Any, at: int, q: Any) -> None:
    """Writes four channels."""
    store3(values, at, q)
    store(values, at + 3 * WIDTH, q[3])


@inlined
def either4(mask: Any, a: Any, b: Any) -> Any:
    """Returns a in lanes with a mask above 0, else b; four channels."""
    return (
        either(mask, a[0], b[0]),
        either(mask, a[1], b[1]),
        either(mask, a[2], b[2]),
        either(mask, a[3], b[3]),
    )
