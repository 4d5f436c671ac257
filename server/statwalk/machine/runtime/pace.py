"""How fast motions go: by their own speed, and by the pace of a blend of clips.

The pace depends on the moment: a lap of a blend takes the weighted mean of its clips' durations, and within
the lap the clips stay in step (`maths.blending`).
"""

from __future__ import annotations

from statwalk.machine.compile.program import Program
from statwalk.machine.runtime.effects import Workspace
from statwalk.machine.runtime.state import MachineState
from statwalk.maths.arrays import Floats
from statwalk.maths.blending import rate
from statwalk.maths.reference import called, inlined


@inlined
def speed_of(p: Program, s: MachineState, i: int, state: int) -> float:
    """Returns the speed factor of an actor's motion, without the pace of a blend."""
    row = p.speed_parameter[state]
    return s.smoothed[i, row] if row >= 0 else p.speed[state]


@inlined
def pace_of(
    p: Program, s: MachineState, weights: Floats, i: int, state: int, time: float, seconds: float
) -> float:
    """Returns the factor that a blend of clips adds to the speed of an actor's motion, which is at `time`, in
    the next `seconds`; 1 for a motion of one clip. `weights` is memory for the weights of the clips.
    """
    if p.blends.states[state, 1] < 2:
        return 1.0
    ahead = seconds * speed_of(p, s, i, state)
    return float(rate(p.blends, state, time, ahead, s.smoothed, i, weights))


@inlined
def motion_seconds(
    p: Program, s: MachineState, weights: Floats, i: int, state: int, time: float, seconds: float
) -> float:
    """Returns by how many seconds an actor's motion, now at `time`, advances in the next `seconds`."""
    return seconds * (speed_of(p, s, i, state) * pace_of(p, s, weights, i, state, time, seconds))


@called
def note_paces(p: Program, s: MachineState, w: Workspace, i: int, dt: float) -> None:
    """Writes the pace of each layer's motion in a tick of `dt` seconds, by the parameters before the tick."""
    for layer in range(s.state.shape[1]):
        w.pace[layer] = pace_of(p, s, w.weights, i, s.state[i, layer], s.time[i, layer], dt)
