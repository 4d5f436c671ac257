"""Measurements of how actors move, after the tick before: values of conditions and of entries.
`step_machines` measures in a tick; `surroundings` is for explanations.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import types

from statwalk.character.pose_tables import POSES
from statwalk.machine.conditions.variables import HEIGHT, SPEED, TURNING
from statwalk.machine.runtime.surroundings import SURROUNDINGS, Measurements
from statwalk.maths.arrays import Floats
from statwalk.maths.compiling import FLOAT, inlined, kernel, read
from statwalk.maths.packed import ADDRESSES, PackedColumns, opened
from statwalk.maths.simd.pose_layout import joint_channel, place_of
from statwalk.solve.foot_tables import DROP
from statwalk.stage.state.cast import Cast
from statwalk.stage.steps.memory import Memory

_poses, _surroundings = opened(POSES), opened(SURROUNDINGS)


@inlined
def measure(t: Any, shown: Any, position: Any, root_delta: Any, around: Any, row: int, dt: float) -> None:
    """Measures an actor's motion after the tick before: its speed, turning and height."""
    x, z = root_delta[row, 0], root_delta[row, 1]
    around.measured[SPEED, row] = np.sqrt(x * x + z * z) / dt
    around.measured[TURNING, row] = root_delta[row, 2] / dt
    around.measured[HEIGHT, row] = position[row, 1] + _root_height(t, shown, row)


@inlined
def _root_height(t: Any, shown: Any, row: int) -> Any:
    """Metres from an actor's place up to its root joint; 0 if the machine names no root joint."""
    joint = t.root[0]
    if joint < 0:
        return 0.0
    block, lane = place_of(row)
    channel, frame = joint_channel(joint), t.root_frame
    height = frame[1, 3]
    for axis in range(3):
        height += frame[1, axis] * np.float64(shown[block, channel + axis, lane])
    return height


def surroundings(cast: Cast, memory: Memory, dt: float, seed: int) -> PackedColumns[Measurements]:
    """Returns the surroundings of a cast's machines in the next tick, in `memory`, valid until its
    next use.
    """
    role, around = cast.role, memory.surroundings
    memory.key(cast.ids, seed)
    if role.measures:
        _measure_all(role.packed.poses.argument, *places_of(cast), around.argument, dt)
    return around


def places_of(cast: Cast) -> tuple[Floats, Floats, Floats]:
    """Returns what `measure` reads of a cast: the shown poses, positions (N, 3), root motion (N, 3).

    On uneven ground heights count from the ground, and a root joint that gives way to the legs is as high as
    in its motion: which clip a height chooses must not depend on the ground.
    """
    legs, position = cast.role.solvers.legs, cast.position
    if legs.fit[0] >= 0:
        position = position.copy()
        position[:, 1] = _given_way(cast) if legs.pelvis[0] == cast.role.packed.poses.values.root[0] else 0.0
    return cast.shown.values, position, cast.root_delta


def _given_way(cast: Cast) -> Floats:
    """(N,) metres by which the foot lock has lowered the pelvis."""
    legs, weight = cast.role.solvers.legs, cast.role.solvers.legs.weight[0]
    if legs.weight_parameter[0] >= 0:
        weight = cast.machine.smoothed[:, legs.weight_parameter[0]].clip(0, 1)
    drop: Floats = cast.solver_memory[:, legs.memory[0] + DROP] * weight * legs.unit[0]
    return drop


@kernel(
    ADDRESSES, read(FLOAT, 3), read(types.float64, 2), read(types.float64, 2), ADDRESSES, types.float64,
)  # fmt: skip
def _measure_all(poses: Any, shown: Any, position: Any, root_delta: Any, around: Any, dt: float) -> None:
    t, out = _poses(poses), _surroundings(around)
    for row in range(position.shape[0]):
        measure(t, shown, position, root_delta, out, row, dt)
