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
    for row in turned:
        root, time = cast.role.roots[done.state.state[row, 0]], done.state.time[row : row + 1, 0]
        begun = root.displacement(np.zeros(1), time, np.zeros(1, np.int64))
        way[row : row + 1] = compose(way[row : row + 1], begun)
    return way


def _leave_at_end(cast: Cast, done: StepResult, turned: Ints, end: Floats, wraps: Ints) -> None:
    """Sets `end` and `wraps` of those who left a looping motion at END, the time left over being spent on the next one."""
    left = turned[(wraps[turned] > 0) & (done.state.time[turned, 0] > 0)]
    end[left] = cast.role.machine.duration[cast.machine.state[left, 0]]
    wraps[left] -= 1
