"""The values that expressions set (EX1), computed when they are read: a tick keeps none of them.

They follow from the poses of the motions, as in the tick, and not from the shown poses, which limits, springs
and solvers have changed since.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import types

from statwalk.character.pose_tables import POSES
from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.compiling import FLOAT, INT, kernel, read, write
from statwalk.maths.packed import ADDRESSES, opened
from statwalk.maths.simd.pose_layout import place_of
from statwalk.solve.express import evaluate_group
from statwalk.stage.state.cast import Cast
from statwalk.stage.steps.sample import motion_poses

_poses = opened(POSES)


def expression_values(cast: Cast, rows: Ints, tick: int, dt: float) -> Floats:
    """Returns the values (n, F) of all names that the machine's and the character's expressions set, in the
    order of `Role.expressions.slots`, of some rows of a cast at a tick of `dt` seconds.
    """
    program = cast.role.expressions
    out = np.zeros((len(rows), len(program.slots)))
    if program.slots:
        slots = np.array(list(program.slots.values()), np.int32)
        clock, work = np.array([tick, tick * dt]), np.zeros(program.values + program.deepest)
        poses, smoothed = cast.role.packed.poses.argument, cast.machine.smoothed
        wanted = np.asarray(rows, np.int32)
        moved = motion_poses(cast).values
        _evaluate(poses, smoothed, moved, wanted, slots, clock, work, program.values, out)
    return out


@kernel(
    ADDRESSES, read(types.float64, 2), read(FLOAT, 3), read(INT, 1), read(INT, 1), read(types.float64, 1),
    write(types.float64, 1), types.int64, write(types.float64, 2),
)  # fmt: skip
def _evaluate(
    poses: Any, smoothed: Any, moved: Any, rows: Any, slots: Any, clock: Any, work: Any, count: int, out: Any
) -> None:
    """Writes the slots of some actors; `work`: `count` values, then the stack."""
    x, values, stack = _poses(poses).expressions, work[:count], work[count:]
    for place in range(rows.shape[0]):
        block, lane = place_of(rows[place])
        evaluate_group(x, 0, smoothed, rows[place], clock[0], clock[1], values, stack, moved, block, lane)
        for number in range(slots.shape[0]):
            out[place, number] = values[slots[number]]
