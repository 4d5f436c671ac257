"""Runs expressions on the pose of an actor, compiled (EX1): channels are loaded into slots, the assignments
run in order, and the channels that they set are stored.

`x` ExpressionTables; `values` (V,) the slots, `stack` memory to work in; `pose` (B, C, 16) a `PoseBuffer`, of
which `at` is the block and `lane` the lane of the actor.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from statwalk.maths import scalar
from statwalk.maths.compiling import inlined
from statwalk.maths.formula.evaluate import number, result
from statwalk.maths.reference import called
from statwalk.maths.simd.pose_layout import ROTATION_CHANNEL, SCALE_CHANNEL, joint_channel
from statwalk.solve.expression_tables import FIRST_PARAMETER, FRAME_SLOT, TIME_SLOT

_RADIANS, _DEGREES = math.pi / 180, 180 / math.pi
_TWO_TURNS = 720.0
"""degrees after which a quaternion comes back to itself, with its sign"""
_LOCKED = 1e-6
"""cosine of the second angle below which the third is 0 (gimbal lock)"""


@called
def express(
    x: Any, group: int, parameters: Any, row: int, frame: float, time: float, values: Any, stack: Any,
    pose: Any, at: int, lane: int,
) -> None:  # fmt: skip
    """Runs a group for the actor `row` of `parameters` (N, P), and writes the channels that it sets."""
    evaluate_group(x, group, parameters, row, frame, time, values, stack, pose, at, lane)
    for touched in range(x.first_joint[group], x.first_joint[group + 1]):
        _store_joint(x, touched, values, pose, at, lane)
    for touched in range(x.first_weight[group], x.first_weight[group + 1]):
        slot = x.weight_store[touched]
        if slot >= 0:
            pose[at, x.weight[touched], lane] = np.float32(_single(values[slot]))


@called
def evaluate_group(
    x: Any, group: int, parameters: Any, row: int, frame: float, time: float, values: Any, stack: Any,
    pose: Any, at: int, lane: int,
) -> None:  # fmt: skip
    """Writes the slots of a group; the pose stays as it is."""
    values[FRAME_SLOT], values[TIME_SLOT] = frame, time
    for parameter in range(parameters.shape[1]):
        values[FIRST_PARAMETER + parameter] = number(parameters[row, parameter])
    for touched in range(x.first_joint[group], x.first_joint[group + 1]):
        _load_joint(x, touched, values, pose, at, lane)
    for touched in range(x.first_weight[group], x.first_weight[group + 1]):
        slot = x.weight_load[touched]
        if slot >= 0:
            values[slot] = float(pose[at, x.weight[touched], lane])
    for line in range(x.first_assignment[group], x.first_assignment[group + 1]):
        first, end = x.first_step[line], x.first_step[line + 1]
        values[x.slot[line]] = number(result(x.opcode, x.operand, first, end, values, stack))


@inlined
def _load_joint(x: Any, touched: int, values: Any, pose: Any, at: int, lane: int) -> None:
    channel = joint_channel(x.joint[touched])
    if x.load[touched, 0] >= 0 or x.load[touched, 1] >= 0 or x.load[touched, 2] >= 0:
        turn = channel + ROTATION_CHANNEL
        angles = _angles(
            float(pose[at, turn, lane]), float(pose[at, turn + 1, lane]), float(pose[at, turn + 2, lane]),
            float(pose[at, turn + 3, lane]),
        )  # fmt: skip
        _put(x, touched, 0, angles[0], values)
        _put(x, touched, 1, angles[1], values)
        _put(x, touched, 2, angles[2], values)
    for axis in range(3):
        _put(x, touched, 3 + axis, float(pose[at, channel + axis, lane]), values)
        _put(x, touched, 6 + axis, float(pose[at, channel + SCALE_CHANNEL + axis, lane]), values)


@inlined
def _put(x: Any, touched: int, axis: int, value: float, values: Any) -> None:
    slot = x.load[touched, axis]
    if slot >= 0:
        values[slot] = value


@inlined
def _angles(i: float, j: float, k: float, w: float) -> Any:
    """Degrees about X first, then Y, then Z, of a unit quaternion (see `quat.to_euler_xyz`)."""
    m00, m10 = 1.0 - 2.0 * (j * j + k * k), 2.0 * (i * j + k * w)
    m20, m21, m22 = 2.0 * (i * k - j * w), 2.0 * (j * k + i * w), 1.0 - 2.0 * (i * i + j * j)
    level = math.sqrt(m00 * m00 + m10 * m10)
    if level < _LOCKED:
        m11, m12 = 1.0 - 2.0 * (i * i + k * k), 2.0 * (j * k - i * w)
        return scalar.atan2(-m12, m11) * _DEGREES, scalar.atan2(-m20, level) * _DEGREES, 0.0
    return (
        scalar.atan2(m21, m22) * _DEGREES,
        scalar.atan2(-m20, level) * _DEGREES,
        scalar.atan2(m10, m00) * _DEGREES,
    )


@inlined
def _store_joint(x: Any, touched: int, values: Any, pose: Any, at: int, lane: int) -> None:
    channel = joint_channel(x.joint[touched])
    if x.store[touched, 0] >= 0:  # then all three are
        _store_turn(
            values[x.store[touched, 0]], values[x.store[touched, 1]], values[x.store[touched, 2]], pose, at,
            channel + ROTATION_CHANNEL, lane,
        )  # fmt: skip
    for axis in range(3):
        if x.store[touched, 3 + axis] >= 0:
            pose[at, channel + axis, lane] = np.float32(_single(values[x.store[touched, 3 + axis]]))
        if x.store[touched, 6 + axis] >= 0:
            place = channel + SCALE_CHANNEL + axis
            pose[at, place, lane] = np.float32(_single(values[x.store[touched, 6 + axis]]))


@inlined
def _single(value: float) -> float:
    """Within what a pose may hold: at most ±1e9."""
    return min(max(value, -1e9), 1e9)


@inlined
def _store_turn(x: float, y: float, z: float, pose: Any, at: int, turn: int, lane: int) -> None:
    """Writes the rotation by angles in degrees (see `quat.from_euler_xyz`)."""
    sx, cx = scalar.sincos(scalar.modulo(x, _TWO_TURNS) * _RADIANS * 0.5)
    sy, cy = scalar.sincos(scalar.modulo(y, _TWO_TURNS) * _RADIANS * 0.5)
    sz, cz = scalar.sincos(scalar.modulo(z, _TWO_TURNS) * _RADIANS * 0.5)
    pose[at, turn, lane] = np.float32(sx * cy * cz - cx * sy * sz)
    pose[at, turn + 1, lane] = np.float32(cx * sy * cz + sx * cy * sz)
    pose[at, turn + 2, lane] = np.float32(cx * cy * sz - sx * sy * cz)
    pose[at, turn + 3, lane] = np.float32(cx * cy * cz + sx * sy * sz)
