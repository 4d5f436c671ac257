"""Parameters on their way: from what they were to what they were set to, without a jump in value or rate."""

from __future__ import annotations

import numpy as np

from statwalk.machine.built.runform import Machine
from statwalk.machine.ticking.state import MachineState
from statwalk.maths.arrays import Floats
from statwalk.maths.elementary import exp

REACHED = 6.6383521
"""ωt where (1 + ωt) e^-ωt is 0.01: what is left of the way after `smooth` seconds is a hundredth"""
NEARLY = 1e-6
"""of the way from minimum to maximum: nearer than this (and slower than this in a second) it is there"""


def smooth(machine: Machine, state: MachineState, dt: float) -> MachineState:
    """`smoothed` and its rate `dt` seconds later.

    A critically damped spring, solved exactly over the step: it never overshoots from rest, and stays within the bounds of what is set.
    """
    slow = [row for row, one in enumerate(machine.parameters) if one.smooth > 0]
    if not slow:
        return state._replace(smoothed=state.parameters)
    given = [machine.parameters[row] for row in slow]
    omega = REACHED / np.array([one.smooth for one in given])
    least, most = np.array([one.minimum for one in given]), np.array([one.maximum for one in given])
    value, rate = approach(state.smoothed[:, slow], state.smoothed_rate[:, slow], state.parameters[:, slow], omega, dt)
    near = (np.abs(value - state.parameters[:, slow]) <= NEARLY * (most - least)) & (np.abs(rate) <= NEARLY * (most - least))
    smoothed, rates = state.parameters.copy(), np.zeros_like(state.parameters)
    smoothed[:, slow] = np.where(near, state.parameters[:, slow], np.minimum(np.maximum(value, least), most))
    rates[:, slow] = np.where(near, 0.0, rate)
    return state._replace(smoothed=smoothed, smoothed_rate=rates)


def approach(value: Floats, rate: Floats, goal: Floats, omega: Floats, dt: float) -> tuple[Floats, Floats]:
    """Value and rate (per second) of a critically damped spring of `omega` (per second) after `dt` seconds."""
    left = value - goal
    drift = (rate + omega * left) * dt
    decay = exp(-omega * dt)
    return goal + (left + drift) * decay, (rate - omega * drift) * decay
