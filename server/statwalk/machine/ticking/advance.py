"""Rule 0 of "One tick": motions advance by one step, and what they cross on the way; (N, L) actors and layers, seconds."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.built.runform import Machine
from statwalk.machine.ticking.state import ENDED, RUNNING, MachineState
from statwalk.maths.arrays import Bools, Floats

NEARLY = 1e-6
"""seconds by which a motion may miss its end or a marker: durations are float32 in most files, and sixty sixtieths are hardly ever one"""


class Advance(NamedTuple):
    """Motions after one step, (N, L) each."""

    time: NDArray[np.float64]
    ended: NDArray[np.uint8]
    at_end: Bools
    """END came"""
    carry: Floats
    """the seconds left after END, where it came"""
    wraps: NDArray[np.int64]
    """how often a loop began anew"""


def advance(machine: Machine, state: MachineState, dt: float, rate: Floats) -> Advance:
    """Motions advance; END comes at the end of a motion and at each wrap of one that loops. `rate` (N, L) is a factor beside the speed."""
    factor = speeds(machine, state) * rate
    time: NDArray[np.float64] = state.time + dt * factor
    over = np.asarray(time >= machine.duration[state.state] - NEARLY)
    at_end, ended = over, state.ended
    carry, wraps = np.zeros_like(time), np.zeros(time.shape, np.int64)
    if over.any():
        at_end, ended, time = over.copy(), ended.copy(), time.copy()
        here = state.state[over]
        loop, duration, reached = machine.loop[here], machine.duration[here], time[over]
        turns = np.where(loop & (duration > 0), np.floor((reached + NEARLY) / np.where(duration > 0, duration, 1.0)), 0.0)
        wrapped = np.where(duration > 0, np.maximum(reached - turns * duration, 0.0), 0.0)
        seconds = np.where(loop, wrapped, np.maximum(reached - duration, 0.0))
        wraps[over] = turns
        carry[over] = np.divide(seconds, factor[over], out=np.zeros_like(seconds), where=factor[over] > 0)
        at_end[over] = loop | (ended[over] != ENDED)
        time[over] = np.where(loop, wrapped, duration)
        ended[over] = np.where(loop, RUNNING, ENDED)
    return Advance(time, ended, at_end, carry, wraps)


def speeds(machine: Machine, state: MachineState) -> Floats:
    """(N, L) factor of time of each motion."""
    factor: Floats = machine.speed[state.state]
    if machine.parameters:
        row = machine.speed_parameter[state.state]
        given = np.take_along_axis(state.smoothed, np.maximum(row, 0).astype(np.intp), axis=1)
        factor = np.where(row >= 0, given, factor)
    return factor
