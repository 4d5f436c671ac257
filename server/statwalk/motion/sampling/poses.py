"""Samples the tables of one motion for N actors: poses, weights, pace and root motion."""

from __future__ import annotations

import numpy as np

from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.pose import Pose
from statwalk.maths.pose_buffer import channels
from statwalk.motion.sampling import _kernels
from statwalk.motion.tables.motion_tables import MotionTables

_NONE = np.zeros((0, 0))


def poses_at(
    motions: MotionTables, rest: Pose, times: Floats, parameters: Floats = _NONE, start: bool = False
) -> Pose:
    """Returns the poses (N, …) of the first state at `times` (N,) seconds, or with `start` the poses at its
    start.

    `rest` is the unbatched rest pose of the character.
    """
    count, joints, weights = len(times), rest.rotation.shape[-2], rest.weights.shape[-1]
    pose = Pose(
        np.empty((count, joints, 3), np.float32),
        np.empty((count, joints, 4), np.float32),
        np.empty((count, joints, 3), np.float32),
        np.empty((count, weights), np.float32),
    )
    rows, every = np.empty(motions.memory, np.float32), np.empty(channels(rest), np.float32)
    _kernels.poses(
        motions,
        0,
        start,
        _doubles(times),
        _doubles(parameters),
        np.empty(motions.most_members),
        rows,
        every,
        *pose,
    )
    return pose


def weights_at(motions: MotionTables, parameters: Floats) -> Floats:
    """Returns the weights (N, K) of the first state's clips."""
    weights = np.empty((len(parameters), motions.most_members))
    _kernels.weights(motions, 0, _doubles(parameters), np.empty(motions.most_members), weights)
    return weights


def rates_at(motions: MotionTables, times: Floats, seconds: Floats, parameters: Floats) -> Floats:
    """Returns the factors of time (N,) of the first state."""
    factors = np.empty(len(times))
    _kernels.rates(
        motions,
        0,
        _doubles(times),
        _doubles(seconds),
        _doubles(parameters),
        np.empty(motions.most_members),
        factors,
    )
    return factors


def ways_gone(motions: MotionTables, start: Floats, end: Floats, wraps: Ints, parameters: Floats) -> Floats:
    """Returns x, z, yaw (N, 3) of the first state from `start` to `end` (N,) seconds through `wraps` (N,)
    repeats.
    """
    ways, laps = np.empty((len(start), 3)), np.ascontiguousarray(wraps, np.int64)
    memory = np.empty(motions.most_members)
    _kernels.ways(motions, 0, _doubles(start), _doubles(end), laps, _doubles(parameters), memory, ways)
    return ways


def _doubles(values: Floats) -> Floats:
    return np.ascontiguousarray(values, np.float64)
