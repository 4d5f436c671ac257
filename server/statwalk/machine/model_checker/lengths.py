"""How many ticks of 1/60 s the motions of the base layer last, at the most and at the least."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from statwalk.machine.compile.machine import Machine
from statwalk.machine.model_checker.blend_lengths import Moments, Pick, blend_moments
from statwalk.machine.runtime.timing import NEARLY

TICKS_PER_SECOND = 60
EVEN: Moments = ((0.0, 0.0), (1.0, 1.0))
"""the shares of a motion that goes at one pace"""
_ALMOST = 1e-9
"""of a motion: rounding does not make a pace uneven"""


@dataclass(frozen=True)
class Lengths:
    """For each state of the base: the ticks of its motion, whether it moves at all (if not, its end never
    comes), and its pace: the share of the ticks that have gone at each phase; linear between these phases.
    """

    ticks: tuple[int, ...]
    moves: tuple[bool, ...]
    shares: tuple[Moments, ...]

    def share(self, state: int, phase: float) -> float:
        """Returns the share of a motion's ticks that have gone at a phase, 0 to 1."""
        phases, gone = zip(*self.shares[state], strict=True)
        return float(np.interp(phase, phases, gone))


def lengths(machine: Machine, slow: bool, as_set: bool = False) -> Lengths:
    """Returns the most ticks (`slow`) or the fewest that motions may last, by what parameters set, blends
    make of their clips, a tick cuts off. `as_set`: parameters have their defaults.
    """
    rows, rounding, least = machine.rows(0), math.ceil if slow else math.floor, NEARLY if slow else -NEARLY
    moments = [_moments(machine, state, max if slow else min, as_set) for state in rows]
    factors = [_factors(machine, state, as_set)[0 if slow else 1] for state in rows]
    seconds = [
        found[-1][1] / factor if factor > 0 else math.inf
        for found, factor in zip(moments, factors, strict=True)
    ]
    whole = [rounding((one - least) * TICKS_PER_SECOND) if math.isfinite(one) else 1 for one in seconds]
    return Lengths(
        tuple(max(one, 1) for one in whole), tuple(map(math.isfinite, seconds)), tuple(map(_shares, moments))
    )


def _moments(machine: Machine, state: int, pick: Pick, as_set: bool) -> Moments:
    if machine.blends[state] is not None:
        return blend_moments(machine, state, pick, as_set)
    return ((0.0, 0.0), (1.0, float(machine.duration[state])))


def _shares(moments: Moments) -> Moments:
    whole = moments[-1][1]
    if not 0.0 < whole < math.inf:
        return EVEN
    shares = tuple((phase, seconds / whole) for phase, seconds in moments)
    return EVEN if all(abs(phase - share) < _ALMOST for phase, share in shares) else shares


def _factors(machine: Machine, state: int, as_set: bool) -> tuple[float, float]:
    """The least and the most speed."""
    row = int(machine.speed_parameter[state])
    if row < 0:
        return float(machine.speed[state]), float(machine.speed[state])
    parameter = machine.parameters[row]
    return (parameter.default,) * 2 if as_set else (parameter.minimum, parameter.maximum)


def depends(machine: Machine, state: int) -> str:
    """Returns what the length of a state's motion depends on beside the machine; empty where on nothing."""
    row, blend = int(machine.speed_parameter[state]), machine.blends[state]
    names = [machine.parameters[row].name] if row >= 0 else []
    if blend and _moments(machine, state, min, False) != _moments(machine, state, max, False):
        names += [name for name in blend.over if name not in names]
    return f"{machine.states[state]} lasts as long as {' and '.join(names)} will have it" if names else ""
