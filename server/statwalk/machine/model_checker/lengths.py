"""How many ticks of 1/60 s the motions of the base layer last, at the most and at the least."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from statwalk.machine.compile.compile_states import MotionFacts
from statwalk.machine.compile.machine import Machine
from statwalk.machine.runtime.timing import NEARLY

TICKS_PER_SECOND = 60


@dataclass(frozen=True)
class Lengths:
    """For each state of the base: the ticks of its motion, and whether it moves at all (if not, its end never
    comes).
    """

    ticks: tuple[int, ...]
    moves: tuple[bool, ...]


def lengths(machine: Machine, motions: Mapping[str, MotionFacts], slow: bool) -> Lengths:
    """The most ticks (`slow`) or the fewest that motions may last, by what parameters set, blends make of
    their clips, a tick cuts off.
    """
    seconds = [
        _slowest(machine, motions, state) if slow else _quickest(machine, motions, state)
        for state in machine.rows(0)
    ]
    rounding = math.ceil if slow else math.floor
    least = NEARLY if slow else -NEARLY
    whole = [rounding((one - least) * TICKS_PER_SECOND) if math.isfinite(one) else 1 for one in seconds]
    return Lengths(tuple(max(one, 1) for one in whole), tuple(map(math.isfinite, seconds)))


def _slowest(machine: Machine, motions: Mapping[str, MotionFacts], state: int) -> float:
    """Seconds at the most, infinite where the motion may stand still."""
    factor = _factors(machine, state)[0]
    return _durations(machine, motions, state)[1] / factor if factor > 0 else math.inf


def _quickest(machine: Machine, motions: Mapping[str, MotionFacts], state: int) -> float:
    """Seconds at the least."""
    factor = _factors(machine, state)[1]
    return _durations(machine, motions, state)[0] / factor if factor > 0 else math.inf


def _durations(machine: Machine, motions: Mapping[str, MotionFacts], state: int) -> tuple[float, float]:
    """The least and the most seconds at speed 1: those of the clips of a blend lie on either side of its
    own.
    """
    blend = machine.blends[state]
    clips = [motions[clip].duration for clip in blend.clips] if blend else [float(machine.duration[state])]
    return min(clips), max(clips)


def _factors(machine: Machine, state: int) -> tuple[float, float]:
    """The least and the most speed."""
    row = int(machine.speed_parameter[state])
    if row >= 0:
        return machine.parameters[row].minimum, machine.parameters[row].maximum
    return float(machine.speed[state]), float(machine.speed[state])


def depends(machine: Machine, motions: Mapping[str, MotionFacts], state: int) -> str:
    """What the length of a state's motion depends on beside the machine; empty where on nothing."""
    row, blend = int(machine.speed_parameter[state]), machine.blends[state]
    names = [machine.parameters[row].name] if row >= 0 else []
    if blend and len(set(_durations(machine, motions, state))) > 1:
        names += [name for name in blend.over if name not in names]
    return f"{machine.states[state]} lasts as long as {' and '.join(names)} will have it" if names else ""
