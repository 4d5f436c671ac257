"""Smoothing of parameters towards their set values; senses, thresholds with hysteresis that raise events."""

from __future__ import annotations

from statwalk.machine.compile.program import NO_CONDITION, Program
from statwalk.machine.conditions.condition_values import is_true, observe
from statwalk.machine.runtime.effects import Workspace
from statwalk.machine.runtime.scratch import DT
from statwalk.machine.runtime.state import MachineState
from statwalk.machine.runtime.surroundings import Measurements
from statwalk.maths.reference import inlined
from statwalk.maths.springs import settled

_NEARLY, _WIDEST = 1e-6, 100.0
"""share of the range from minimum to maximum, of at most 100 of it: a parameter nearer than this to its set
value, and slower than this per second, has arrived
"""


@inlined
def smooth(p: Program, s: MachineState, i: int, dt: float) -> None:
    """Advances `smoothed` and its rate by `dt` seconds: a critically damped spring."""
    for k in range(s.parameters.shape[1]):
        goal = s.parameters[i, k]
        if p.omega[k] == 0 or (s.smoothed[i, k] == goal and s.smoothed_rate[i, k] == 0):
            s.smoothed[i, k], s.smoothed_rate[i, k] = goal, 0.0
            continue
        left, rate = settled(s.smoothed[i, k] - goal, s.smoothed_rate[i, k], p.omega[k], dt)
        value = goal + left
        near = _NEARLY * min(p.maximum[k] - p.minimum[k], _WIDEST)
        if abs(value - goal) <= near and abs(rate) <= near:
            value, rate = goal, 0.0
        else:
            value = min(max(value, p.minimum[k]), p.maximum[k])
        s.smoothed[i, k], s.smoothed_rate[i, k] = value, rate


@inlined
def sense(p: Program, s: MachineState, w: Workspace, around: Measurements, i: int) -> int:
    """Returns how many senses raise their event in this tick; senses see phase and time of the base layer.

    A sense that is off goes on, and raises its event, when its condition is true. It goes off when `release`
    is true, or, without a `release`, when its condition is false. `w.sensed` marks the senses that went on.
    """
    observe(p, w.conditions, s.state[i, 0], s.time[i, 0], s.age[i, 0], w.clock[DT])
    raised = 0
    for k in range(p.sense_event.shape[0]):
        w.sensed[k] = 0
        releases = s.sensing[i, k] and p.sense_release[k] != NO_CONDITION
        condition = p.sense_release[k] if releases else p.sense_when[k]
        answer = is_true(p, s, around, w.conditions, i, 0, condition)
        now = answer != releases
        if now and not s.sensing[i, k]:
            w.sensed[k] = 1
            raised += 1
        s.sensing[i, k] = now
    return raised
