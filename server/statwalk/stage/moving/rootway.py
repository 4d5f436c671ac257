"""The way that motions of the base layer take their actors in a tick."""

from __future__ import annotations

import numpy as np

from statwalk.machine.ticking.state import BEGINNING
from statwalk.machine.ticking.step import StepResult
from statwalk.maths.arrays import Floats, Ints
from statwalk.motion.root import compose
from statwalk.stage.cast import Cast


def way_gone(cast: Cast, done: StepResult, turned: Ints) -> Floats:
    """x, z (metres), yaw (radians) (N, 3) in the frame of each actor: along the motion it was in, then along the one it turned to."""
    way = np.zeros((len(cast.ids), 3))
    if not cast.role.travels:
        return way
    begin, reached = done.time_before[:, 0], done.time_reached[:, 0].copy()
    wraps = done.wraps[:, 0].copy()
    entered = done.state.passed[turned, 0] - BEGINNING
    _leave_at_end(cast, done, (turned, entered), reached, wraps)
    everyone = np.arange(len(way))
    _go(way, cast, done, (everyone, cast.machine.state[:, 0]), (begin, reached, wraps))
    after = done.state.time[turned, 0]
    over = (after < entered).astype(np.int64)  # what was left of the tick has led through the end of a loop
    _go(way, cast, done, (turned, done.state.state[turned, 0]), (entered, after, over))
    return way


def _go(way: Floats, cast: Cast, done: StepResult, who: tuple[Ints, Ints], time: tuple[Floats, Floats, Ints]) -> None:
    """Adds to the way of some rows that of the states they are in; `who` is rows and states, `time` start, end and wraps (n,) each."""
    rows, states = who
    for state in np.unique(states):
        motion, some = cast.role.motions[state], (states == state).nonzero()[0]
        if motion is not None:
            gone = motion.way(*(part[some] for part in time), done.state.smoothed[rows[some]])
            way[rows[some]] = compose(way[rows[some]], gone)


def _leave_at_end(cast: Cast, done: StepResult, who: tuple[Ints, Floats], reached: Floats, wraps: Ints) -> None:
    """Sets `reached` and `wraps` of those who left a looping motion at END, the time left over being spent on the next one.

    `who` is the rows that turned, and the seconds into the new motion at which they entered it.
    """
    turned, entered = who
    left = turned[(wraps[turned] > 0) & (done.state.time[turned, 0] > entered)]
    reached[left] = cast.role.machine.duration[cast.machine.state[left, 0]]
    wraps[left] -= 1
