"""The way that motions take their actors in a tick."""

from __future__ import annotations

import numpy as np

from statwalk.machine.step import StepResult
from statwalk.maths.arrays import Floats, Ints
from statwalk.motion.root import compose
from statwalk.stage.cast import Cast


def way_gone(cast: Cast, done: StepResult, turned: Ints) -> Floats:
    """x, z (metres), yaw (radians) (N, 3) in the frame of each actor: along the motion it was in, then along the one it turned to."""
    way = np.zeros((len(cast.ids), 3))
    if not cast.role.travels:
        return way
    states, begin = cast.machine.state[:, 0], done.time_before[:, 0]
    end, wraps = done.time_reached[:, 0].copy(), done.wraps[:, 0].copy()
    _leave_at_end(cast, done, turned, end, wraps)
    for state in np.unique(states):
        rows = (states == state).nonzero()[0]
        way[rows] = cast.role.roots[state].displacement(begin[rows], end[rows], wraps[rows])
    begun = done.state.state[turned, 0]
    for state in np.unique(begun):
        rows = turned[begun == state]
        start, wraps = np.zeros(len(rows)), np.zeros(len(rows), np.int64)
        way[rows] = compose(way[rows], cast.role.roots[state].displacement(start, done.state.time[rows, 0], wraps))
    return way


def _leave_at_end(cast: Cast, done: StepResult, turned: Ints, end: Floats, wraps: Ints) -> None:
    """Sets `end` and `wraps` of those who left a looping motion at END, the time left over being spent on the next one."""
    left = turned[(wraps[turned] > 0) & (done.state.time[turned, 0] > 0)]
    end[left] = cast.role.machine.duration[cast.machine.state[left, 0]]
    wraps[left] -= 1
