"""Solves chains of pose buffers from Python: the code that a tick runs."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.clamp_table import CLAMP_TABLE, ClampTable
from statwalk.maths.packed import packed
from statwalk.maths.pose_buffer import PoseBuffer
from statwalk.maths.simd.aligned import zeros
from statwalk.maths.simd.lanes import LANES
from statwalk.solve import _kernels
from statwalk.solve.chain_lanes import scratch_floats
from statwalk.solve.chains import (
    CHAINS,
    DISTANCE,
    ITERATIONS,
    POLE,
    ROTATION,
    TARGET,
    WEIGHT,
    Chain,
    chain_tables,
    cut_angle,
    input_rows,
)


@dataclass(frozen=True, eq=False)
class Goal:
    """What the actors of a buffer want of a chain; arrays have an axis of N actors, or none for all alike."""

    target: Floats
    """(…, 3) a point in model space, metres"""
    weight: Floats
    """(…) 0…1"""
    pole: Floats
    """(…, 3) see `Chain.pole`"""
    rotation: Floats
    """(…, 4) of the end in model space, unit length"""


@dataclass(frozen=True, eq=False)
class Solved:
    """How a solve went, for N actors."""

    distance: NDArray[np.float32]
    """(N,) metres from the end to the target"""
    iterations: NDArray[np.int64]
    """(N,)"""
    cut: Floats
    """(N, n) radians by which limits cut the last turn of each joint of the chain"""


def solve_poses(poses: PoseBuffer, parent: Ints, limits: ClampTable, chain: Chain, goal: Goal) -> Solved:
    """Turns the joints of the chain, within their limits, in all poses of the buffer, whose skeleton has
    these parents (J,).
    """
    notes = {joint: place for place, joint in enumerate(chain.joints)}
    tables = packed(chain_tables(parent, [chain], limits, notes), CHAINS)
    clamps = packed(limits, CLAMP_TABLE)
    rows = input_rows(len(poses.values), 1)
    for row, values in ((TARGET, goal.target), (POLE, goal.pole), (ROTATION, goal.rotation)):
        _fill(rows, row, values, poses.count)
    _fill(rows, WEIGHT, np.asarray(goal.weight)[..., None], poses.count)
    scratch, keep = zeros(scratch_floats(len(chain.joints))), np.zeros((poses.count, len(chain.joints)))
    _kernels.solve(tables.argument, clamps.argument, 0, poses.values, rows, scratch, keep)
    iterations = _row(rows, ITERATIONS, poses.count).astype(np.int64)
    return Solved(_row(rows, DISTANCE, poses.count), iterations, cut_angle(keep))


def _fill(rows: NDArray[np.float32], first: int, values: Floats, count: int) -> None:
    """Writes the rows of an input; lanes without an actor keep theirs."""
    width = values.shape[-1]
    lanes = np.zeros((len(rows) * LANES, width), np.float32)
    lanes[:count] = values
    place = rows[:, 0, first : first + width]
    place[:] = np.where(
        np.arange(len(lanes)).reshape(-1, 1, LANES) < count,
        lanes.reshape(-1, LANES, width).transpose(0, 2, 1),
        place,
    )


def _row(rows: NDArray[np.float32], row: int, count: int) -> NDArray[np.float32]:
    return rows[:, 0, row].reshape(-1)[:count].copy()
