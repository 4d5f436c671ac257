"""Senses: thresholds that raise events, with hysteresis, for all actors at once."""

from __future__ import annotations

import numpy as np

from statwalk.machine.built.runform import Machine
from statwalk.machine.ticking.asking import Answers
from statwalk.machine.ticking.state import MachineState
from statwalk.maths.arrays import Bools, Floats


def sense(machine: Machine, state: MachineState, measured: Floats, dt: float) -> tuple[Bools, Bools]:
    """(N, K) which senses are on by now, and which of them raise their event in this tick.

    One that is off goes on, and raises its event, when its condition is true; it goes off when `release` is true, or without one
    when its condition is false. Phase and time are those of the base layer.
    """
    answers = Answers(machine, state, measured, dt, 0, np.arange(len(state.state)))
    now = np.empty_like(state.sensing)
    for column, one in enumerate(machine.senses):
        stays = answers.truths(one.when) if one.release is None else ~answers.truths(one.release)
        now[:, column] = np.where(state.sensing[:, column], stays, answers.truths(one.when))
    return now, now & ~state.sensing
