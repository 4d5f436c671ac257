"""The way that motions take their actors in a tick."""

from __future__ import annotations

import numpy as np

from statwalk.machine.step import StepResult
from statwalk.maths.arrays import Floats, Ints
from statwalk.motion.root import compose
from statwalk.stage.cast import Cast


def way_gone(cast: Cast, done: StepResult, turned: Ints, dt: float) -> Floats:
    """x, z (metres), yaw (radians) (N, 3) in the frame of each actor: along the motion it was in, then along the one it turned to."""
    way = np.zeros((len(cast.ids), 3))
    if not cast.role.travels:
        return way
    states, begin = cast.machine.state[:, 0], done.time_before[:, 0]
    end, wraps = done.state.time[:, 0].copy(), done.wraps[:, 0].copy()
    if len(turned):
        end[turned], wraps[turned] = _left_at(cast, done, turned, dt)
    for state in np.unique(states):
        rows = (states == state).nonzero()[0]
        way[rows] = cast.role.roots[state].displacement(begin[rows], end[rows], wraps[rows])
    for row in turned:
        root, time = cast.role.roots[done.state.state[row, 0]], done.state.time[row : row + 1, 0]
        begun = root.displacement(np.zeros(1), time, np.zeros(1, np.int64))
        way[row : row + 1] = compose(way[row : row + 1], begun)
    return way


def _left_at(cast: Cast, done: StepResult, rows: Ints, dt: float) -> tuple[Floats, Ints]:
    """Times (n,) at which the motions of `rows` were left, and how often they had wrapped.

    Where the new motion has time on it already, the old one was left at its end (END); else it was left at the end of the tick.
    """
    states, machine = cast.machine.state[rows, 0], cast.role.machine
    duration = machine.duration[states]
    reached = done.time_before[rows, 0] + dt * cast.role.speeds(states, done.state.parameters[rows])
    stops = ~machine.loop[states] | (done.state.time[rows, 0] > 0) | (duration <= 0)
    wraps = np.where(stops, 0, np.floor(reached / np.where(duration > 0, duration, 1)))
    return np.where(stops, np.minimum(reached, duration), reached - wraps * duration), wraps.astype(np.int64)
