"""The kernels that Python calls for one motion: poses of a clip or a blend space, pace, weights and root
motion.
"""

from __future__ import annotations

from typing import Any

from numba import types

from statwalk.maths.blending import rate, weigh
from statwalk.maths.columns import columns
from statwalk.maths.compiling import FLOAT, LONG, kernel, read, write
from statwalk.maths.simd.pose_layout import (
    ROTATION_CHANNEL,
    SCALE_CHANNEL,
    channel_of,
    joint_channel,
    weight_channel,
)
from statwalk.motion.sampling.root_motion import way
from statwalk.motion.sampling.sample import sample
from statwalk.motion.tables.motion_tables import MotionTables

DOUBLE = types.float64
TABLES = columns(MotionTables, readonly=True)


@kernel(
    TABLES, LONG, types.boolean, read(DOUBLE, 1), read(DOUBLE, 2), write(DOUBLE, 1), write(FLOAT, 1),
    write(FLOAT, 1), write(FLOAT, 3), write(FLOAT, 3), write(FLOAT, 3), write(FLOAT, 2),
)  # fmt: skip
def poses(
    motions: Any, state: int, start: bool, times: Any, parameters: Any, weights: Any, rows: Any, pose: Any,
    translation: Any, rotation: Any, scale: Any, morph: Any,
) -> None:  # fmt: skip
    """Writes the poses (N, …) of one state at `times` (N,); `rows` is memory for `motions.memory` numbers,
    `pose` for all channels of a pose.
    """
    joints = translation.shape[1]
    for number in range(motions.common.shape[0]):
        pose[channel_of(motions.common[number])] = motions.common_values[number]
    for actor in range(times.shape[0]):
        sample(motions, state, times[actor], start, parameters, actor, weights, rows, 0, motions.layout[1])
        for number in range(motions.layout[1]):
            pose[channel_of(motions.layout[2 + number])] = rows[number]
        for joint in range(joints):
            at = joint_channel(joint)
            for k in range(3):
                translation[actor, joint, k] = pose[at + k]
                scale[actor, joint, k] = pose[at + SCALE_CHANNEL + k]
            for k in range(4):
                rotation[actor, joint, k] = pose[at + ROTATION_CHANNEL + k]
        for k in range(morph.shape[1]):
            morph[actor, k] = pose[weight_channel(joints, k)]


@kernel(TABLES, LONG, read(DOUBLE, 1), read(DOUBLE, 1), read(DOUBLE, 2), write(DOUBLE, 1), write(DOUBLE, 1))
def rates(
    motions: Any, state: int, times: Any, seconds: Any, parameters: Any, weights: Any, out: Any
) -> None:
    """Writes out (N,): the factor of time of one state."""
    for actor in range(times.shape[0]):
        out[actor] = rate(motions, state, times[actor], seconds[actor], parameters, actor, weights)


@kernel(TABLES, LONG, read(DOUBLE, 2), write(DOUBLE, 1), write(DOUBLE, 2))
def weights(motions: Any, state: int, parameters: Any, memory: Any, out: Any) -> None:
    """Writes out (N, K): the weights of a blend space's clips."""
    for actor in range(out.shape[0]):
        weigh(motions, state, parameters, actor, memory)
        for k in range(out.shape[1]):
            out[actor, k] = memory[k]


@kernel(
    TABLES,
    LONG,
    read(DOUBLE, 1),
    read(DOUBLE, 1),
    read(LONG, 1),
    read(DOUBLE, 2),
    write(DOUBLE, 1),
    write(DOUBLE, 2),
)
def ways(
    motions: Any, state: int, start: Any, end: Any, wraps: Any, parameters: Any, weights: Any, out: Any
) -> None:
    """Writes out (N, 3): x, z, yaw from `start` to `end` (N,) seconds through `wraps` (N,) repeats."""
    for actor in range(start.shape[0]):
        moved = way(motions, state, start[actor], end[actor], wraps[actor], parameters, actor, weights)
        out[actor, 0], out[actor, 1], out[actor, 2] = moved
